#pragma once
/// States of a gas in the frame of a face: u is the velocity normal to it. SI units.
#include "riemann/base/lane.hpp"

namespace g27 {

/// Primitive state: density [kg/m^3], normal velocity [m/s], pressure [Pa].
template <Lane V = double>
struct GasState {
  V rho, u, p;
};

/// Conserved densities: mass [kg/m^3], momentum [kg/(m^2 s)], total energy [J/m^3]; also their fluxes.
template <Lane V = double>
struct GasConserved {
  V mass, momentum, energy;
};

/// The state seen in the mirror x -> -x.
template <Lane V>
G27_INLINE GasState<V> mirror(GasState<V> const& s) noexcept {
  return {s.rho, -s.u, s.p};
}

}  // namespace g27
