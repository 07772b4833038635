#pragma once
/// HLLC (Toro, Spruce and Speares 1994; Toro, Riemann Solvers, 3rd ed., 10.4-10.6), for comparison with the exact
/// solver: three waves, the contact restored, any equation of state.
#include "riemann/eos/concept.hpp"
#include "riemann/state/gas.hpp"

namespace g27 {

/// Flux of the conserved densities along the state's own motion.
template <Lane V, EquationOfState E>
[[nodiscard]] G27_INLINE GasConserved<V> physical_flux(E const& eos, GasState<V> const& s) noexcept {
  V const mass = s.rho * s.u;
  return {mass, mass * s.u + s.p, mass * (eos.energy(s.rho, s.p) + 0.5 * s.u * s.u) + s.p * s.u};
}

/// Flux through the face [kg/(m^2 s), Pa, W/m^2] between two admissible states, in the face frame.
/// Wave speeds: Einfeldt (1988), Roe's averages for u and c bounded by each side's own u -+ c (Toro 10.5.1, (10.52)),
/// with c^2 of the average from the bulk moduli, so that no equation of state is presumed.
template <Lane V, EquationOfState E>
[[nodiscard]] G27_INLINE GasConserved<V> hllc_flux(E const& eos, GasState<V> const& l, GasState<V> const& r) noexcept {
  V const c2_l = eos.bulk_modulus(l.rho, l.p) / l.rho, c2_r = eos.bulk_modulus(r.rho, r.p) / r.rho;
  V const w_l = sqrt(l.rho), w_r = sqrt(r.rho), w = 1.0 / (w_l + w_r);
  V const u = (w_l * l.u + w_r * r.u) * w, du = r.u - l.u;
  V const c = sqrt(V((w_l * c2_l + w_r * c2_r) * w + 0.5 * w_l * w_r * w * w * du * du));
  V const s_l = min(l.u - sqrt(c2_l), u - c), s_r = max(r.u + sqrt(c2_r), u + c);

  // Toro (10.37): speed of the contact; (10.36): pressure beside it
  V const m_l = l.rho * (s_l - l.u), m_r = r.rho * (s_r - r.u);
  V const s_m = (r.p - l.p + m_l * l.u - m_r * r.u) / (m_l - m_r);
  Mask<V> const from_left = s_m >= V(0.0);
  auto const upwind = [&](V a, V b) G27_INLINE_LAMBDA { return select(from_left, a, b); };
  GasState<V> const k{upwind(l.rho, r.rho), upwind(l.u, r.u), upwind(l.p, r.p)};
  V const s_k = upwind(s_l, s_r), m = upwind(m_l, m_r);
  GasConserved<V> const f = physical_flux(eos, k);

  // Toro (10.38), (10.39): F* = F + S (U* - U), where the fan of that side holds the face
  V const p = k.p + m * (s_m - k.u);
  V const rho = m / (s_k - s_m), e = eos.energy(k.rho, k.p) + 0.5 * k.u * k.u;
  V const e_star = e + (s_m - k.u) * (s_m + k.p / m);
  Mask<V> const star = s_l < V(0.0) && s_r > V(0.0);
  return {select(star, rho * s_m, f.mass), select(star, rho * s_m * s_m + p, f.momentum),
          select(star, (rho * e_star + p) * s_m, f.energy)};
}

}  // namespace g27
