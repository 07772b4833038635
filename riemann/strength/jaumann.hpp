#pragma once
/// Hooke's law with the Jaumann rate: dS/dt = 2 mu dev(D) + W S - S W, D and W the symmetric and the antisymmetric part
/// of the velocity gradient, W_ij = (u_i,j - u_j,i)/2.
#include "riemann/base/lane.hpp"

namespace g27 {

/// dS/dt that the derivatives g_k = u_k,1 along the face's normal cause, OG (4.6)-(4.11). Tensors 11 22 33 12 13 23.
template <Lane V>
G27_INLINE void jaumann_along(double mu, V const* S, V const* g, V* rate) noexcept {
  V const stretch = (2.0 / 3.0 * mu) * g[0], turn_2 = S[3] * g[1], turn_3 = S[4] * g[2];
  rate[1] = turn_2 - stretch, rate[2] = turn_3 - stretch, rate[0] = -(rate[1] + rate[2]);
  V const shear = 0.5 * S[5];
  rate[3] = (mu + 0.5 * (S[0] - S[1])) * g[1] - shear * g[2];
  rate[4] = (mu + 0.5 * (S[0] - S[2])) * g[2] - shear * g[1];
  rate[5] = 0.5 * (S[4] * g[1] + S[3] * g[2]);
}

}  // namespace g27
