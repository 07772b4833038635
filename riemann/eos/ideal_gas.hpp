#pragma once
/// Ideal gas of constant heat capacities (Toro, Riemann Solvers, 3rd ed., 1.2.4): p = (gamma - 1) rho e.
#include <array>

#include "riemann/eos/concept.hpp"
#include "riemann/eos/parameter.hpp"

namespace g27 {

struct IdealGas {
  double gamma = 1.4;  ///< ratio of specific heats, > 1

  static constexpr char const* name = "ideal";
  static constexpr char const* title = "ideal gas: p = (gamma - 1) rho e";
  static constexpr std::array<EosParameter<IdealGas>, 1> parameters{
      {{"gamma", &IdealGas::gamma, "1", "ratio of specific heats", 1.0, 20.0}}};
  /// Why these parameters cannot be used together; nullptr: they can.
  [[nodiscard]] constexpr char const* flaw() const noexcept { return nullptr; }

  template <Lane V>
  [[nodiscard]] G27_INLINE V energy(V rho, V p) const noexcept {
    return p / ((gamma - 1.0) * rho);
  }
  /// rho e = p first + second.
  [[nodiscard]] std::array<double, 2> energy_line() const noexcept { return {1.0 / (gamma - 1.0), 0.0}; }
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_density(V /*rho*/, V p) const noexcept {
    return p * (1.0 / (gamma - 1.0));
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure(V rho, V e) const noexcept {
    return (gamma - 1.0) * rho * e;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus(V /*rho*/, V p) const noexcept {
    return gamma * p;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure_margin(V /*rho*/, V p) const noexcept {
    return p;
  }
  /// Grueneisen parameter (dp/de)/rho at constant density.
  /// Second differential of rho e along (d_rho, d_p): rho e is linear in p alone.
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_bend(V /*rho*/, V /*d_rho*/, V /*d_p*/) const noexcept {
    return V(0.0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gruneisen(V /*rho*/) const noexcept {
    return V(gamma - 1.0);
  }
  /// 1 + (rho/c) dc/drho at constant entropy (Menikoff and Plohr 1989, 2.14); positive: convex.
  template <Lane V>
  [[nodiscard]] G27_INLINE V fundamental_derivative(V /*rho*/, V /*p*/) const noexcept {
    return V(0.5 * (gamma + 1.0));
  }
  [[nodiscard]] double isentropic_exponent() const noexcept { return gamma; }
  /// Pressure that every isentrope tends to as rho -> 0 [Pa]: that of the vacuum.
  [[nodiscard]] constexpr double vacuum_pressure() const noexcept { return 0.0; }
};

}  // namespace g27
