#pragma once
/// Sum over the lanes of a row whose last group may reach beyond it.
#include <cstddef>

#include "riemann/base/lane.hpp"

namespace g27 {

template <Lane V>
class LaneSum {
 public:
  /// `left`: lanes of the row from this group on.
  G27_INLINE void add(V v, std::ptrdiff_t left) noexcept {
    if (left >= static_cast<std::ptrdiff_t>(width<V>)) {
      full_ += v;
    } else {
      for (std::size_t k = 0; k < static_cast<std::size_t>(left); ++k) rest_ += lane(v, k);
    }
  }
  [[nodiscard]] G27_INLINE double total() const noexcept {
    double sum = rest_;
    for (std::size_t k = 0; k < width<V>; ++k) sum += lane(full_, k);
    return sum;
  }

 private:
  V full_{0.0};
  double rest_ = 0;
};

}  // namespace g27
