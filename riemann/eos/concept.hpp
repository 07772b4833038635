#pragma once
/// What the scheme and the Riemann solvers ask of an equation of state p = p(rho, e).
///
/// An EOS is a plain struct of parameters (SI doubles) whose functions are templates on the lane type. To add one:
/// write its header, add its type to the list in registry.hpp; the factory, `g27 list` and every property test follow.
#include <concepts>

#include "riemann/base/lane.hpp"

namespace g27 {

template <class E>
concept EquationOfState = requires(E const& eos, double x, Simd v) {
  /// name in scenes and on the command line
  { E::name } -> std::convertible_to<char const*>;
  /// specific internal energy [J/kg] of (rho [kg/m^3], p [Pa])
  { eos.energy(x, x) } -> std::same_as<double>;
  { eos.energy(v, v) } -> std::same_as<Simd>;
  /// the same per volume, rho e [J/m^3]
  { eos.energy_density(v, v) } -> std::same_as<Simd>;
  /// pressure [Pa] of (rho, e)
  { eos.pressure(x, x) } -> std::same_as<double>;
  { eos.pressure(v, v) } -> std::same_as<Simd>;
  /// adiabatic bulk modulus rho c^2 [Pa] of (rho, p)
  { eos.bulk_modulus(x, x) } -> std::same_as<double>;
  { eos.bulk_modulus(v, v) } -> std::same_as<Simd>;
  /// pressure above the lowest admissible one at this density [Pa]; a state with rho > 0 is admissible iff > 0,
  /// and the set of such states is convex in the conserved variables
  { eos.pressure_margin(x, x) } -> std::same_as<double>;
  { eos.pressure_margin(v, v) } -> std::same_as<Simd>;
  /// second differential [J/m^3] of rho e along (d_rho, d_p) at rho: what a cell average adds to rho e of the averages
  { eos.energy_bend(v, v, v) } -> std::same_as<Simd>;
  /// Grueneisen parameter, 1/(d(rho e)/dp) at constant rho
  { eos.gruneisen(v) } -> std::same_as<Simd>;
  /// exponent g with which rho (1 + g dp / K)^(1/g) follows an isentrope (exact for ideal and stiffened gas)
  { eos.isentropic_exponent() } -> std::same_as<double>;
};

}  // namespace g27
