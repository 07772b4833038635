#pragma once
/// The face between a solid and what bounds it: from the outgoing amplitudes alone.
#include "riemann/solid/linearised.hpp"

namespace g27 {

enum class SolidFaceCondition : int {
  wall,     ///< normal velocity given, no shear
  fixed,    ///< velocity given
  traction  ///< traction given
};

/// Velocity and traction on the face. With z_k U_k - side T_k = out_k, in the amplitudes of the frozen families:
///   wall      u1 = given1, s2 = s3 = 0: the shear families leave U_k = out_k/z_k
///   fixed     u = given: T_k = side (z_k U_k - out_k)
///   traction  s = given: U_k = (out_k + side T_k)/z_k
/// in  out: outgoing amplitudes, `side` = 1 where the body lies below the face, -1 above; given [m/s] or [Pa]
template <class W, Lane V>
G27_INLINE void boundary_face(W const& w, SolidFaceCondition kind, double side, Triple<V> const& out,
                              Triple<V> const& given, Triple<V>& u, Triple<V>& s) noexcept {
  V const zero(0.0);
  if (kind == SolidFaceCondition::traction) {
    Triple<V> const T = w.project(given);
    s = given;
    u = w.unproject({{(out[0] + side * T[0]) * w.inv_z[0], (out[1] + side * T[1]) * w.inv_z[1],
                      (out[2] + side * T[2]) * w.inv_z[2]}});
    return;
  }
  if (kind == SolidFaceCondition::fixed) {
    u = given;
  } else {
    // s2 = s3 = 0 makes s = (s1, 0, 0) = (T_P, 0, 0) up to the tangent's coupling, and u follows but for u1
    u = w.unproject({{zero, out[1] * w.inv_z[1], out[2] * w.inv_z[2]}});
    u[0] = given[0];
  }
  Triple<V> const U = w.project(u);
  s = w.unproject(
      {{side * (w.z[0] * U[0] - out[0]), side * (w.z[1] * U[1] - out[1]), side * (w.z[2] * U[2] - out[2])}});
  if (kind == SolidFaceCondition::wall) s[1] = zero, s[2] = zero;
}

}  // namespace g27
