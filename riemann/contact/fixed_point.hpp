#pragma once
/// The contact of a gas and a solid by OG's iteration: the gas against a rigid wall that moves with the solid, then the
/// solid under the pressure found, and again. The error shrinks by Z_gas/Z_solid, the ratio of the impedances, and
/// grows where that exceeds one: gas_solid.hpp is what a scheme should use, this is for comparison.
#include "riemann/contact/gas_solid.hpp"

namespace g27 {

/// in  as gas_solid_contact; start: velocity of the solid's surface at first [m/s]; most: iterations
/// out residual: last change of the velocity over c + |u - v(p)| + |p - p_vac|/Z; converged where it is below
///     `tolerance` and the velocity is finite
template <EquationOfState E>
[[nodiscard]] GasSolidContact fixed_point_contact(E const& eos, GasState<> const& gas, SolidTrace const& solid,
                                                  double start, double tolerance = 1e-10, int most = 1000) noexcept {
  contact::GasProblem<E> problem(eos, gas);
  double const scale = problem.curve.sound_speed() + std::fabs(gas.u - solid.velocity(gas.p)) +
                       problem.curve.excess() * solid.compliance(gas.p);
  GasSolidContact r;
  double v = start;
  for (int i = 1; i <= most; ++i) {
    GasSolidContact const wall = problem.solve(rigid_wall_trace(v));
    double const next = solid.velocity(wall.contact.p);
    r = wall;
    r.contact.u = next;
    r.iterations = i, r.residual = std::fabs(next - v) / scale;
    r.converged = wall.converged && r.residual < tolerance;
    if (r.converged || !wall.converged || !std::isfinite(next)) break;
    v = next;
  }
  if (!r.vacuum) r.front = r.contact.u;
  return r;
}

}  // namespace g27
