#pragma once
/// Fluxes of a face state.
#include "riemann/state/gas.hpp"

namespace g27 {

/// Flux of a face state, rho_e its energy per volume, through a face moving at w: mass, momentum with the pressure,
/// energy with its work.
template <Lane V>
G27_INLINE GasConserved<V> flux_of(V rho, V u, V p, V rho_e, V w) noexcept {
  V const v = u - w, m = rho * v;
  return {m, V(m * u + p), V(v * rho_e + 0.5 * m * u * u + p * u)};
}

/// Flux averaged over the step, from the change of the face state over dt/sqrt(12): two Gauss points in time.
/// `energy_density` of (rho, p).
template <Lane V, class EnergyDensity>
G27_INLINE GasConserved<V> mean_flux(GasState<V> const& s, GasState<V> const& d, V w,
                                     EnergyDensity const& energy_density) noexcept {
  V const rho_a = s.rho - d.rho, p_a = s.p - d.p, rho_b = s.rho + d.rho, p_b = s.p + d.p;
  GasConserved<V> const a = flux_of(rho_a, V(s.u - d.u), p_a, energy_density(rho_a, p_a), w);
  GasConserved<V> const b = flux_of(rho_b, V(s.u + d.u), p_b, energy_density(rho_b, p_b), w);
  return {0.5 * (a.mass + b.mass), 0.5 * (a.momentum + b.momentum), 0.5 * (a.energy + b.energy)};
}

}  // namespace g27
