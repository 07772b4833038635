#pragma once
/// A stressed body in rigid rotation: an exact solution of the nonlinear equations of hypoelastic solids.
///
/// With D = 0 Jaumann's rate turns the deviator with the body, S(t) = R(t) S(0) R(t)^T, uniform in space; density and
/// energy stay with their particles, and the pressure holds the body together: grad p = rho w^2 s, s the vector from
/// the axis, |s| the same for a particle at all times. Laws with energy: rho uniform, p = p_c + rho w^2 |s|^2/2. The
/// linear law: rho = rho_c exp(rho0 w^2 |s|^2/(2 K)).
#include "verification/exact/solid.hpp"

namespace g27 {

struct RigidRotation {
  ExactSolidLaw law;
  double rho = 7800, p = 0;  ///< on the axis
  Tensor6 S{};               ///< at t = 0
  Vector3 axis{0, 0, 1};     ///< any length
  double rate = 1;           ///< angular velocity [rad/s]
  Vector3 centre{};          ///< a point of the axis at t = 0
  Vector3 drift{};           ///< velocity of the axis

  [[nodiscard]] SolidPoint at(Vector3 const& x, double t) const;
  /// Where the particle that was at x at t = 0 is at t.
  [[nodiscard]] Vector3 moved(Vector3 const& x, double t) const;
};

}  // namespace g27
