#pragma once
/// Stiffened gas (Harlow and Amsden 1971; Menikoff and Plohr 1989, IV.C): p = (gamma - 1) rho e - gamma p_inf.
/// An ideal gas in P = p + p_inf: tension is admitted down to p = -p_inf, where the density vanishes.
#include <array>

#include "riemann/eos/concept.hpp"
#include "riemann/eos/parameter.hpp"

namespace g27 {

struct StiffenedGas {
  double gamma = 4.4;  ///< > 1
  double p_inf = 6e8;  ///< stiffness [Pa], >= 0; the defaults are water's

  static constexpr char const* name = "stiffened";
  static constexpr char const* title = "stiffened gas: p = (gamma - 1) rho e - gamma p_inf";
  static constexpr std::array<EosParameter<StiffenedGas>, 2> parameters{
      {{"gamma", &StiffenedGas::gamma, "1", "exponent of the isentropes of p + p_inf", 1.0, 20.0},
       {"p_inf", &StiffenedGas::p_inf, "Pa", "stiffness: tension at which the density vanishes", 0.0, 1e15, true}}};
  [[nodiscard]] constexpr char const* flaw() const noexcept { return nullptr; }

  template <Lane V>
  [[nodiscard]] G27_INLINE V energy(V rho, V p) const noexcept {
    return (p + gamma * p_inf) / ((gamma - 1.0) * rho);
  }
  /// rho e = p first + second.
  [[nodiscard]] std::array<double, 2> energy_line() const noexcept {
    return {1.0 / (gamma - 1.0), gamma * p_inf / (gamma - 1.0)};
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_density(V /*rho*/, V p) const noexcept {
    return (p + gamma * p_inf) * (1.0 / (gamma - 1.0));
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure(V rho, V e) const noexcept {
    return (gamma - 1.0) * rho * e - gamma * p_inf;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus(V /*rho*/, V p) const noexcept {
    return gamma * (p + p_inf);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure_margin(V /*rho*/, V p) const noexcept {
    return p + p_inf;
  }
  /// Second differential of rho e along (d_rho, d_p): rho e is linear in p alone.
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_bend(V /*rho*/, V /*d_rho*/, V /*d_p*/) const noexcept {
    return V(0.0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gruneisen(V /*rho*/) const noexcept {
    return V(gamma - 1.0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V fundamental_derivative(V /*rho*/, V /*p*/) const noexcept {
    return V(0.5 * (gamma + 1.0));
  }
  [[nodiscard]] double isentropic_exponent() const noexcept { return gamma; }
  [[nodiscard]] constexpr double vacuum_pressure() const noexcept { return -p_inf; }
};

}  // namespace g27
