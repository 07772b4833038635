#pragma once
/// Exact contact of a gas of any convex equation of state with a solid: the gas's wave curve, a shock or a rarefaction,
/// meets the line (two lines, where the solid yields) on which its outgoing characteristics leave the solid.
///
/// With m = P - p_vac, p_vac the pressure that the gas tends to as rho -> 0, F(m) = v(P) - u + jump(P) grows with m. If
/// F(0) >= 0 the gas does not reach the solid: its front moves at u - jump(p_vac) and p_vac is left on the surface
/// (0 for ideal gas and JWL). Otherwise a bracketed Newton iteration, in m where the solid yields more than the gas,
/// else in the variables of riemann/gas/exact.hpp. Any ratio of impedances, 0 (a free surface) to infinity (a rigid
/// wall).
#include <cmath>

#include "riemann/contact/contact.hpp"
#include "riemann/contact/solid_trace.hpp"
#include "riemann/gas/exact.hpp"

namespace g27 {

struct GasSolidContact {
  Contact contact;         ///< of the solid's surface; of the gas too, but in a vacuum
  double rho = 0;          ///< of the gas beside it [kg/m^3]; 0 in a vacuum
  double front = 0;        ///< velocity of the gas there [m/s]: the contact's, in a vacuum that of the gas's front
  bool shock = false;      ///< the wave in the gas
  bool vacuum = false;     ///< the gas does not reach the solid
  bool converged = false;  ///< false: the caller must not use the rest
  int iterations = 0;
  double residual = 0;  ///< |v(P) - u + jump(P)| over c + |u - v(p)| + (|p - p_vac| + |P|)/Z; 0 in a vacuum
};

namespace contact {

/// Residual that is convergence: near the limit of compression the gas's wave curve itself is known to 1e-12.
inline constexpr double tolerance = 1e-11;

/// A gas and the solid that it runs into along n.
template <EquationOfState E>
struct GasProblem {
  E const& eos;
  GasState<> gas;
  double p_vacuum;
  WaveCurve<double, E> curve;

  GasProblem(E const& law, GasState<> const& state) noexcept
      : eos(law), gas(state), p_vacuum(law.vacuum_pressure()), curve(law, state) {}

  /// The solution with the excess m over the vacuum's pressure, given where the wave curve leads to.
  [[nodiscard]] GasSolidContact at(double m, WavePoint<double> const& point, SolidTrace const& solid) const noexcept {
    double const P = p_vacuum + m;
    return {.contact = {.p = P, .u = solid.velocity(P)},
            .rho = point.rho,
            .front = gas.u - point.jump,
            .shock = m > curve.excess()};
  }

  [[nodiscard]] GasSolidContact solve(SolidTrace const& solid) noexcept {
    double const c = curve.sound_speed(), m_gas = curve.excess();
    double const approach = gas.u - solid.velocity(gas.p);
    double const scale = c + std::fabs(approach) + m_gas * solid.compliance(gas.p);
    // apart: only where the solid recedes from the gas faster than this can follow
    if (solid.velocity(p_vacuum) - gas.u >= curve.escape_at_least()) {
      double const escape = curve.escape(true);
      if (solid.velocity(p_vacuum) - gas.u - escape >= 0.0) {
        GasSolidContact r = at(0.0, {0.0, -escape, 0.0}, solid);
        r.vacuum = r.converged = true;
        return r;
      }
    }
    // start: acoustic where it stays positive
    double const tiny = 1e-200 * m_gas, z = gas.rho * c;
    double const acoustic = m_gas + approach / (1.0 / z + solid.compliance(gas.p));
    double const g = eos.isentropic_exponent(), fan_power = 0.5 * (g - 1.0) / g;
    double m = acoustic > 0.1 * m_gas ? acoustic : 0.1 * m_gas;
    double low = tiny, high = 1e300, residual = 1e300, last = 1e300, before_last = 1e300;
    GasSolidContact best;
    int iterations = 0;
    for (bool open = true; open && iterations < 100;) {
      WavePoint<double> const point = curve.at(m, true);
      double const P = p_vacuum + m, f = solid.velocity(P) - gas.u + point.jump;
      // a soft solid's velocity is a difference of large ones
      double const now = std::fabs(f) / (scale + std::fabs(P) * solid.compliance(P));
      bool const better = now < residual;
      if (better) residual = now, best = at(m, point, solid);
      iterations += 1;
      (f > 0.0 ? high : low) = m;
      bool const slow = now > 0.5 * before_last, stalled = now < tolerance && !better;
      before_last = last, last = now;
      double const compliance = solid.compliance(P), linear = m - f / (point.rate + compliance);
      double next = exact::newton(m, f, point.rate + compliance, m_gas, fan_power, low, high, slow);
      if (compliance > point.rate && !slow && linear > low && linear < high) next = linear;
      open = residual > 2e-16 && !stalled && high > low * (1.0 + 2e-16);
      m = next;
    }
    best.iterations = iterations, best.residual = residual;
    best.converged = residual <= tolerance;
    // below the least pressure representable a fan is a vacuum to round-off
    best.vacuum = best.contact.p - p_vacuum < 1e3 * tiny;
    if (!best.vacuum) best.front = best.contact.u;
    return best;
  }
};

}  // namespace contact

/// in  gas: beside the solid, u along n, which points from the gas into the solid; admissible
///     solid: velocities along n
template <EquationOfState E>
[[nodiscard]] GasSolidContact gas_solid_contact(E const& eos, GasState<> const& gas, SolidTrace const& solid) noexcept {
  return contact::GasProblem<E>(eos, gas).solve(solid);
}

/// Gas against a rigid wall that moves at `wall` along n, from the gas into it: the contact's velocity is the wall's.
template <EquationOfState E>
[[nodiscard]] GasSolidContact gas_wall_contact(E const& eos, GasState<> const& gas, double wall) noexcept {
  return gas_solid_contact(eos, gas, rigid_wall_trace(wall));
}

}  // namespace g27
