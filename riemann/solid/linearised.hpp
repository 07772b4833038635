#pragma once
/// The linearised Riemann problem of a solid, OG (4.1)-(4.12): left vectors, impedances and coefficients frozen at the
/// mean of the two cells and applied to both. With cell-wise coefficients the order falls to one.
#include "riemann/solid/eigensystem.hpp"

namespace g27 {

/// Amplitudes at the face, as deviations from those of the frozen state: of A_k = l_k.(z_k u + s), which arrives from
/// the right, and of B_k = l_k.(z_k u - s), from the left.
template <Lane V>
struct Arrivals {
  Triple<V> A, B;
};

/// Velocity and traction amplitudes, U_k = (A + B)/(2 z), T_k = (A - B)/2, as deviations.
template <Lane V>
struct Meeting {
  Triple<V> U, T;
};

template <class W, Lane V>
G27_INLINE Meeting<V> meet(W const& w, Arrivals<V> const& a) noexcept {
  Meeting<V> m;
  unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
    m.U[k] = 0.5 * (a.A[k] + a.B[k]) * w.inv_z[k], m.T[k] = 0.5 * (a.A[k] - a.B[k]);
  });
  return m;
}

/// The particle that reaches the face, taken along its path from `foot` to the face's traction: what rides with the
/// velocity (density, energy, S22, S33, S23, plastic strain).
/// in  foot; change: of traction and gradient from the foot to the face; s: traction on the face
/// out rho = rho_foot exp(-g1) to third order, positive for every g1; trace-free S
template <Lane V>
G27_INLINE SolidFace<V> carry(SolidState<V> const& foot, PathChange<V> const& change, Triple<V> const& u,
                              Triple<V> const& s) noexcept {
  SolidFace<V> f;
  f.u = u, f.s = s;
  f.rho = foot.rho * (1.0 - change.g1 * (1.0 - 0.5 * change.g1));
  f.e = foot.e + change.e;
  f.ep = foot.ep + max(change.ep, 0.0);
  f.S[1] = foot.S[1] + change.S22, f.S[2] = foot.S[2] + change.S33, f.S[0] = -(f.S[1] + f.S[2]);
  f.S[3] = s[1], f.S[4] = s[2], f.S[5] = foot.S[5] + change.S23;
  return f;
}

}  // namespace g27
