#pragma once
/// FNV-1a: a digest that tells apart what differs by accident, not by intent.
#include <cstdint>
#include <string_view>

namespace g27 {

class Digest {
 public:
  void add(std::string_view bytes) noexcept {
    for (char const c : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace g27
