#pragma once
/// Rows of several fields in one block.
#include "scheme/grid/line.hpp"
#include "scheme/kernel/solid_kernels.hpp"

namespace g27 {

/// Rows of several fields that may be read and written a vector beyond both ends.
class RowBlock {
 public:
  RowBlock() = default;
  RowBlock(int fields, std::size_t n, double value = 0.0)
      : stride_(static_cast<std::ptrdiff_t>((n + 24 + 7) / 8 * 8)),
        data_(static_cast<std::size_t>(fields) * static_cast<std::size_t>(stride_), value) {}
  /// At lane 0.
  [[nodiscard]] FieldRows rows() noexcept { return {data_.data() + 8, stride_}; }
  [[nodiscard]] std::size_t bytes() const noexcept { return data_.bytes(); }

 private:
  struct Storage : Padded {
    using Padded::Padded;
    std::size_t size = 0;
    Storage() = default;
    Storage(std::size_t n, double value) : Padded(n, value), size(n) {}
    [[nodiscard]] std::size_t bytes() const noexcept { return size * sizeof(double); }
  };
  std::ptrdiff_t stride_ = 0;
  Storage data_;
};

}  // namespace g27
