#pragma once
/// The four cells z, a | b, y around a face of a solid as its predictor sees them. Lengths are in units of
/// L = (h_a + h_b)/2, the distance of the two centres beside the face; so are swept lengths, |lambda| dt/L.
#include <cstddef>

#include "riemann/base/lane.hpp"

namespace g27 {

/// Equal cells; the face stands.
struct EqualCells {
  /// Velocity of the material relative to the face.
  template <Lane V>
  G27_INLINE static V relative(V u) noexcept {
    return u;
  }
  /// Difference over the interval i = 0, 1, 2 (z a, a b, b y), over its length.
  template <Lane V>
  G27_INLINE static V gradient(V difference, int) noexcept {
    return difference;
  }
  /// v times the width of the cell on the left (`left`) or on the right of the face.
  template <Lane V>
  G27_INLINE static V own(Mask<V>, V v) noexcept {
    return v;
  }
  /// Width of the cell on that side, less s.
  template <Lane V>
  G27_INLINE static V beyond(Mask<V>, V s) noexcept {
    return 1.0 - s;
  }
  /// Weight of the far gradient in the slope of the parabola through the cell on that side and its two neighbours,
  /// averaged over the swept length s: (s + h_opposite)/(h_far + h_own + h_opposite).
  template <Lane V>
  G27_INLINE static V far_weight(Mask<V>, V s) noexcept {
    return (s + 1.0) * (1.0 / 3.0);
  }
  /// The same of the cell on the right at a boundary, from the gradient extrapolated linearly to the face.
  template <Lane V>
  G27_INLINE static V boundary_weight(V s) noexcept {
    return (s + 1.0) * (1.0 / 3.0);
  }
  /// Curvature of the parabola through z a b (side 0) or a b y (1), of the difference of its two gradients; up to a
  /// factor.
  template <Lane V>
  G27_INLINE static V curvature(V difference, int) noexcept {
    return difference;
  }
  /// Value at the face, linear between the centres.
  template <Lane V>
  G27_INLINE static V mean(V a, V b) noexcept {
    return 0.5 * (a + b);
  }
};

/// Cells of any widths; the face moves with the material, so that what rides with the velocity stands.
struct RidingCells {
  double r[4];             ///< widths of z a b y
  double inv_interval[3];  ///< 1 over the distances of their centres
  double inv_triple[2];    ///< 1 over the lengths of z a b, a b y
  double inv_length;       ///< 1/L [1/m]

  /// in  h: widths of z a b y [m]
  explicit RidingCells(double const* h) noexcept : inv_length(2.0 / (h[1] + h[2])) {
    for (std::size_t i = 0; i < 4; ++i) r[i] = h[i] * inv_length;
    for (std::size_t i = 0; i < 3; ++i) inv_interval[i] = 2.0 / (r[i] + r[i + 1]);
    for (std::size_t i = 0; i < 2; ++i) inv_triple[i] = 1.0 / (r[i] + r[i + 1] + r[i + 2]);
  }
  template <Lane V>
  G27_INLINE static V relative(V) noexcept {
    return V(0.0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gradient(V difference, int i) const noexcept {
    return difference * inv_interval[i];
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V own(Mask<V> left, V v) const noexcept {
    return v * select(left, V(r[1]), r[2]);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V beyond(Mask<V> left, V s) const noexcept {
    return select(left, V(r[1]), r[2]) - s;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V far_weight(Mask<V> left, V s) const noexcept {
    return (s + select(left, V(r[2]), r[1])) * select(left, V(inv_triple[0]), inv_triple[1]);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V boundary_weight(V s) const noexcept {
    return (s + r[0]) * inv_triple[0];
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V curvature(V difference, int side) const noexcept {
    return difference * inv_triple[side];
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V mean(V a, V b) const noexcept {
    return a + (0.5 * r[1]) * (b - a);
  }
};

}  // namespace g27
