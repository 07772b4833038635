#pragma once
/// Shares of a slope that the graded switch leaves, from 1 down to 0 without a jump: round-off must not choose.
#include "riemann/base/lane.hpp"

namespace g27 {

/// Of the slope d, `far` being the slope upwind of it: all from half of it on.
template <Lane V>
G27_INLINE V graded_share(V far, V d) noexcept {
  V const product = far * d, square = d * d;
  return select(2.0 * product >= square, V(1.0), max(2.0 * product, V(0.0)) / max(square, V(1e-300)));
}

/// Nothing as well where the slope upwind is 5/2 of d or more: beside a steep front a flat slope is the front's foot.
template <Lane V>
G27_INLINE V two_way_share(V far, V d) noexcept {
  V const part = far * d / max(V(d * d), V(1e-300));
  return max(V(0.0), min(V(1.0), min(V(2.0 * part), V(2.5 - part))));
}

}  // namespace g27
