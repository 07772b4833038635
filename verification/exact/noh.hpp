#pragma once
/// Noh's problem: a cold ideal gas implodes with uniform speed on a plane, an axis or a point (Noh, J. Comput. Phys. 72
/// (1987) 78). The shock moves outwards at (gamma - 1) speed/2 and leaves a uniform gas at rest.
#include "riemann/state/gas.hpp"

namespace g27 {

struct Noh {
  double gamma = 5.0 / 3;  ///< > 1
  double rho0 = 1;         ///< density at t = 0 [kg/m^3]
  double speed = 1;        ///< inward speed [m/s], > 0
  int symmetry = 2;        ///< 0 planar, 1 cylindrical, 2 spherical

  [[nodiscard]] double shock_speed() const { return (gamma - 1) / 2 * speed; }
  /// State behind the shock: rho0 ((gamma + 1)/(gamma - 1))^(symmetry + 1), p = (gamma - 1) rho speed^2/2.
  [[nodiscard]] GasState<> shocked() const;
  /// State at r >= 0, t >= 0; p = 0 ahead of the shock.
  [[nodiscard]] GasState<> at(double r, double t) const;
  /// Mean of the conserved densities over [r0, r1], weighted with r^symmetry; closed form.
  [[nodiscard]] GasConserved<> average(double r0, double r1, double t) const;
};

}  // namespace g27
