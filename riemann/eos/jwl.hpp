#pragma once
/// Jones-Wilkins-Lee products of detonation (Lee, Hornig and Kury 1968, UCRL-50422), v = rho0/rho:
///   p = a + b + t,   rho0 e = a/R1 + b/R2 + t v/omega,   a = A exp(-R1 v),   b = B exp(-R2 v).
/// a + b is the cold curve; the thermal pressure t follows v^-(1 + omega) along an isentrope. States with t > 0 are
/// admissible: there D1 = -(dp/dv)_s and D2 = (d2p/dv2)_s are sums of positive terms, hence c^2 > 0 and convexity.
#include <array>

#include "riemann/base/lane_math.hpp"
#include "riemann/eos/concept.hpp"
#include "riemann/eos/parameter.hpp"

namespace g27 {

struct Jwl {
  double A = 708.6056e9, B = 13.16457e9;  ///< [Pa]
  double R1 = 4.94, R2 = 1.35;
  double omega = 0.28;   ///< Grueneisen parameter
  double rho0 = 1650.0;  ///< density of the unburnt charge [kg/m^3]; the defaults are TNT-RDX

  static constexpr char const* name = "jwl";
  static constexpr char const* title = "Jones-Wilkins-Lee: p = A exp(-R1 v) + B exp(-R2 v) + t, v = rho0/rho";
  static constexpr std::array<EosParameter<Jwl>, 6> parameters{
      {{"A", &Jwl::A, "Pa", "first exponential", 0.0, 1e14, true},
       {"B", &Jwl::B, "Pa", "second exponential", 0.0, 1e14, true},
       {"R1", &Jwl::R1, "1", "decay of the first exponential", 0.0, 100.0},
       {"R2", &Jwl::R2, "1", "decay of the second exponential", 0.0, 100.0},
       {"omega", &Jwl::omega, "1", "Grueneisen parameter", 0.0, 10.0},
       {"rho0", &Jwl::rho0, "kg/m^3", "density of the unburnt charge", 0.0, 1e5}}};
  [[nodiscard]] constexpr char const* flaw() const noexcept { return nullptr; }

  template <Lane V>
  [[nodiscard]] G27_INLINE V energy(V rho, V p) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return (a * (1.0 / R1) + b * (1.0 / R2) + (p - a - b) * v * (1.0 / omega)) * (1.0 / rho0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_density(V rho, V p) const noexcept {
    return rho * energy(rho, p);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure(V rho, V e) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return a + b + (rho0 * e - a * (1.0 / R1) - b * (1.0 / R2)) * omega / v;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus(V rho, V p) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return (R1 * a + R2 * b) * v + (1.0 + omega) * (p - a - b);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure_margin(V rho, V p) const noexcept {
    return p - cold_pressure(rho);
  }
  /// Second differential of rho e along (d_rho, d_p): with k = R rho0/rho^2, d^2(rho e)/d rho^2 is the sum over both
  /// exponentials of a k ((1 + 2/omega)/rho - k/omega).
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_bend(V rho, V d_rho, V /*d_p*/) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    V const inv = 1.0 / rho, k1 = R1 * v * inv, k2 = R2 * v * inv, once = (1.0 + 2.0 / omega) * inv;
    return (a * k1 * (once - k1 * (1.0 / omega)) + b * k2 * (once - k2 * (1.0 / omega))) * d_rho * d_rho;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gruneisen(V /*rho*/) const noexcept {
    return V(omega);
  }
  /// v D2 / (2 D1)
  template <Lane V>
  [[nodiscard]] G27_INLINE V fundamental_derivative(V rho, V p) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    V const g_t = (1.0 + omega) * (p - a - b);
    V const v_d1 = (R1 * a + R2 * b) * v + g_t;
    return 0.5 * ((R1 * R1 * a + R2 * R2 * b) * v * v + (2.0 + omega) * g_t) / v_d1;
  }
  [[nodiscard]] double isentropic_exponent() const noexcept { return 1.0 + omega; }
  [[nodiscard]] constexpr double vacuum_pressure() const noexcept { return 0.0; }

  // The thermal form p = p_cold(rho) + t, e = e_cold(rho) + t/(Gamma rho), as the exact Riemann solver needs it.

  /// Pressure [Pa] and energy [J/kg] at t = 0.
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_pressure(V rho) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return a + b;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_energy(V rho) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return (a * (1.0 / R1) + b * (1.0 / R2)) * (1.0 / rho0);
  }
  /// cold_pressure - vacuum_pressure, without cancellation as rho -> 0.
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_excess(V rho) const noexcept {
    return cold_pressure(rho);
  }
  /// Bulk modulus [Pa] of (rho, t).
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus_thermal(V rho, V t) const noexcept {
    auto const [v, a, b] = exponentials(rho);
    return (R1 * a + R2 * b) * v + (1.0 + omega) * t;
  }
  /// t(to)/t(from) along an isentrope.
  template <Lane V>
  [[nodiscard]] G27_INLINE V thermal_ratio(V from, V to) const noexcept {
    return pow(to / from, 1.0 + omega);
  }
  /// Upper bound [kg/m^3] of the density at which the isentrope through (rho, t) has fallen to the pressure p: there
  /// the largest of the three terms alone makes p.
  template <Lane V>
  [[nodiscard]] G27_INLINE V expanded_density(V rho, V t, V p) const noexcept {
    V const v_a = log(max(V(A), p) / p) * (1.0 / R1), v_b = log(max(V(B), p) / p) * (1.0 / R2);
    V const v_t = (rho0 / rho) * pow(t / p, 1.0 / (1.0 + omega));
    return rho0 / max(v_t, max(v_a, v_b));
  }
  /// Velocity [m/s] gained from (rho, c) down to rho = 0 where only t is left: an ideal gas of exponent 1 + omega.
  template <Lane V>
  [[nodiscard]] G27_INLINE V thermal_escape(V /*rho*/, V c) const noexcept {
    return (2.0 / omega) * c;
  }
  /// Step in -ln(rho) over which Gauss quadrature of c reaches round-off: D1 has its zeros at Im(v) of about pi/R.
  template <Lane V>
  [[nodiscard]] G27_INLINE V smooth_step(V rho) const noexcept {
    V const v = rho0 / rho;
    double const fast = R1 > R2 ? R1 : R2, slow = R1 > R2 ? R2 : R1;
    // beyond, the faster exponential is so small that the coarser step resolves it
    return min(1.2 / (select(fast * v < V(25.0), V(fast), V(slow)) * v), 0.8);
  }
  /// Specific volume [m^3/kg] that shocks from rho approach as their strength grows.
  template <Lane V>
  [[nodiscard]] G27_INLINE V strong_shock_volume(V rho) const noexcept {
    return (omega / (2.0 + omega)) / rho;
  }

 private:
  template <Lane V>
  struct Exponentials {
    V v, a, b;
  };
  // exp(-700) is 1e-304: nothing below it can matter, and nothing underflows to a denormal.
  template <Lane V>
  [[nodiscard]] G27_INLINE Exponentials<V> exponentials(V rho) const noexcept {
    V const v = rho0 / rho;
    return {v, A * exp(max(-R1 * v, -700.0)), B * exp(max(-R2 * v, -700.0))};
  }
};

}  // namespace g27
