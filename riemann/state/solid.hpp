#pragma once
/// States of a solid in the frame of a face: axis 1 is normal to it, 2 and 3 lie in it. Symmetric tensors are stored as
/// 11 22 33 12 13 23. SI units.
#include "riemann/base/lane.hpp"

namespace g27 {

/// Velocity or traction in the face's frame, or the amplitudes of the three families: P, S, S.
template <Lane V>
struct Triple {
  V v[3];
  G27_INLINE V& operator[](int k) noexcept { return v[k]; }
  G27_INLINE V const& operator[](int k) const noexcept { return v[k]; }
};

template <Lane V>
G27_INLINE Triple<V> operator+(Triple<V> const& a, Triple<V> const& b) noexcept {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
template <Lane V>
G27_INLINE Triple<V> operator-(Triple<V> const& a, Triple<V> const& b) noexcept {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

/// Primitive state: density [kg/m^3], velocity [m/s], pressure [Pa], specific energy [J/kg], stress deviator [Pa],
/// plastic strain.
template <Lane V = double>
struct SolidState {
  V rho, u[3], p, e, S[6], ep;

  /// Stress on the face (s11, s12, s13).
  [[nodiscard]] G27_INLINE Triple<V> traction() const noexcept { return {{S[0] - p, S[3], S[4]}}; }
  [[nodiscard]] G27_INLINE Triple<V> velocity() const noexcept { return {{u[0], u[1], u[2]}}; }
};

/// What the Riemann problem leaves on a face.
template <Lane V = double>
struct SolidFace {
  V rho, e, ep;
  Triple<V> u, s;  ///< velocity, traction
  V S[6];
};

/// Place among xx yy zz xy xz yz of the k-th component (11 22 33 12 13 23) in the frame of `axis`, whose axes are axis,
/// axis + 1, axis + 2. Not a table: kernels of different instruction sets would share its symbol.
[[gnu::always_inline]] constexpr int frame_component(int axis, int k) noexcept {
  if (k < 3) return (axis + k) % 3;
  int const i = (axis + (k == 5 ? 1 : 0)) % 3, j = (axis + (k == 3 ? 1 : 2)) % 3;
  return 2 + i + j;
}

}  // namespace g27
