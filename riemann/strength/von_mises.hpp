#pragma once
/// Yield surface of von Mises, q = sqrt(3/2 S:S) <= Y = Y0 + H ep, and the return to it.
#include "riemann/base/lane.hpp"

namespace g27 {

struct Strength {
  double mu = 0, Y0 = 0, H = 0;  ///< shear modulus, yield stress, hardening [Pa]
};

/// A : B of tensors stored as 11 22 33 12 13 23.
template <Lane V>
G27_INLINE V contraction(V const* A, V const* B) noexcept {
  return A[0] * B[0] + A[1] * B[1] + A[2] * B[2] + 2.0 * (A[3] * B[3] + A[4] * B[4] + A[5] * B[5]);
}
/// q^2 = 3/2 S:S [Pa^2].
template <Lane V>
G27_INLINE V mises_squared(V const* S) noexcept {
  return 1.5 * contraction(S, S);
}

/// S along itself to the yield surface: d_ep = (q - Y)/(3 mu + H), S* = (1 - 3 mu d_ep/q) S. Inside it nothing happens.
/// in, out  S [Pa], ep
template <Lane V>
G27_INLINE void radial_return(Strength const& m, V* S, V& ep) noexcept {
  V const q2 = mises_squared(S), Y = m.Y0 + m.H * ep;
  Mask<V> const yields = q2 > Y * Y;
  if (!any(yields)) return;
  V const q = sqrt(max(q2, 1e-300)), d = select(yields, (q - Y) * (1.0 / (3.0 * m.mu + m.H)), V(0.0));
  V const keep = 1.0 - 3.0 * m.mu * d / q;
  unrolled<6>([&](auto k) G27_INLINE_LAMBDA { S[k] *= keep; });
  ep += d;
}

/// The same along the direction N = S_mid/q(S_mid) of the middle of the step: second order where the direction turns.
/// Radial where the two directions differ by more than acos(0.9) or S_mid lies deep inside the surface.
/// S - 3 mu x N lies on the surface of ep + x: x is the smaller root of
///   (9 mu^2 - H^2) x^2 - (6 mu 3/2 S:N + 2 Y H) x + q^2 - Y^2 = 0.
template <Lane V>
G27_INLINE void midpoint_return(Strength const& m, V* S, V& ep, V const* S_mid) noexcept {
  V const q2 = mises_squared(S), Y = m.Y0 + m.H * ep;
  Mask<V> const yields = q2 > Y * Y;
  if (!any(yields)) return;
  V const q2_mid = mises_squared(S_mid), along = 1.5 * contraction(S, S_mid);
  V const q_mid = sqrt(max(q2_mid, 1e-300));
  V const a = V(9.0 * m.mu * m.mu - m.H * m.H), b = 6.0 * m.mu * along / q_mid + 2.0 * m.H * Y, c = q2 - Y * Y;
  V const root = b * b - 4.0 * a * c;
  Mask<V> const good =
      yields && along > 0.0 && along * along >= 0.81 * q2 * q2_mid && q2_mid >= 0.25 * Y * Y && root >= 0.0;
  V const x = select(good, 2.0 * c / (b + sqrt(max(root, 0.0))), V(0.0));
  V const step = 3.0 * m.mu * x / q_mid;
  unrolled<6>([&](auto k) G27_INLINE_LAMBDA { S[k] -= step * S_mid[k]; });
  ep += x;
  radial_return(m, S, ep);
}

}  // namespace g27
