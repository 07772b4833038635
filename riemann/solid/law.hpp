#pragma once
/// What the solid side asks of an equation of state p = p(rho, e): less than the gas side, which needs isentropes and
/// a convex set of admissible states.
#include <concepts>

#include "riemann/base/lane.hpp"

namespace g27 {

template <class E>
concept SolidLaw = requires(E const& eos, double x, Simd v) {
  { E::name } -> std::convertible_to<char const*>;
  /// pressure [Pa] of (rho [kg/m^3], e [J/kg])
  { eos.pressure(x, x) } -> std::same_as<double>;
  { eos.pressure(v, v) } -> std::same_as<Simd>;
  /// energy [J/kg] of (rho, p); a law p(rho) gives that of its cold compression
  { eos.energy(x, x) } -> std::same_as<double>;
  /// adiabatic bulk modulus rho c^2 [Pa] of (rho, p)
  { eos.bulk_modulus(x, x) } -> std::same_as<double>;
  { eos.bulk_modulus(v, v) } -> std::same_as<Simd>;
  /// (1/rho) dp/de at constant rho: f of the equations
  { eos.gruneisen(x) } -> std::same_as<double>;
  { eos.gruneisen(v) } -> std::same_as<Simd>;
};

}  // namespace g27
