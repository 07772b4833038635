#pragma once
/// Mie-Grueneisen solid or liquid on its principal Hugoniot U_s = c0 + s u_p, with Gamma rho = Gamma0 rho0
/// (Meyers, Dynamic Behavior of Materials, 1994, 5.2). With the compression eta = 1 - rho0/rho and K0 = rho0 c0^2,
///   p = F(eta) + Gamma0 rho0 e,   F = K0 eta (1 - Gamma0 eta/2)/(1 - s eta)^2   for eta >= 0.
///
/// Expansion: the Hugoniot's formula loses hyperbolicity at eta = -1/s, so for eta < 0 the isentrope through
/// (rho0, p = 0) is prescribed instead, p_c = K0 (exp(4 s eta) - 1)/(4 s). It meets the Hugoniot in value, slope and
/// curvature, so that c and the fundamental derivative (2 s at the origin) are continuous.
///
/// Admissible: p above that isentrope p_c and eta < 1/s. Every other isentrope is p = p_c + t exp(Gamma0 (eta -
/// eta_t)), so {t > 0} is invariant, and p_c' > 0, p_c'' > 0 (for Gamma0 < 2 s) make it hyperbolic and convex. As
/// rho -> 0 the pressure tends to the strength in tension, -K0/(4 s).
#include <array>

#include "riemann/base/lane_math.hpp"
#include "riemann/eos/concept.hpp"
#include "riemann/eos/parameter.hpp"

namespace g27 {

struct MieGruneisen {
  double rho0 = 2785.0;  ///< [kg/m^3]; the defaults are aluminium 2024
  double c0 = 5328.0;    ///< bulk sound speed at rho0, p = 0 [m/s]
  double s = 1.338;      ///< slope of the Hugoniot, >= 1: below, p would stay finite as rho grows
  double Gamma0 = 2.0;   ///< Grueneisen parameter at rho0, < 2 s

  static constexpr char const* name = "mie-gruneisen";
  static constexpr char const* title = "Mie-Grueneisen on the Hugoniot U_s = c0 + s u_p";
  static constexpr std::array<EosParameter<MieGruneisen>, 4> parameters{
      {{"rho0", &MieGruneisen::rho0, "kg/m^3", "density at zero pressure", 0.0, 1e5},
       {"c0", &MieGruneisen::c0, "m/s", "bulk sound speed at rho0", 0.0, 1e5},
       {"s", &MieGruneisen::s, "1", "slope dU_s/du_p of the Hugoniot", 1.0, 10.0, true},
       {"Gamma0", &MieGruneisen::Gamma0, "1", "Grueneisen parameter at rho0", 0.0, 20.0}}};
  [[nodiscard]] constexpr char const* flaw() const noexcept {
    return Gamma0 < 2.0 * s ? nullptr : "Gamma0 must be below 2 s: beyond, compression is not convex";
  }

  template <Lane V>
  [[nodiscard]] G27_INLINE V energy(V rho, V p) const noexcept {
    return (p - reference(rho).f) * (1.0 / (Gamma0 * rho0));
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_density(V rho, V p) const noexcept {
    return rho * energy(rho, p);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure(V rho, V e) const noexcept {
    return reference(rho).f + Gamma0 * rho0 * e;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus(V rho, V p) const noexcept {
    Reference<V> const r = reference(rho);
    return (rho0 / rho) * (r.slope + Gamma0 * (p - r.base));
  }
  /// p - p_c; negative beyond the limit of compression.
  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure_margin(V rho, V p) const noexcept {
    return select(s * (1.0 - rho0 / rho) < V(1.0), p - cold_pressure(rho), V(-bulk_modulus_0()));
  }
  /// Second differential of rho e = rho (p - F)/(Gamma0 rho0) along (d_rho, d_p).
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy_bend(V rho, V d_rho, V d_p) const noexcept {
    V const v = rho0 / rho;
    return (2.0 * d_rho * d_p - reference(rho).curvature * v * v / rho * d_rho * d_rho) * (1.0 / (Gamma0 * rho0));
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gruneisen(V rho) const noexcept {
    return Gamma0 * rho0 / rho;
  }
  /// v D2/(2 D1), D1 = -(dp/dv)_s = F' + Gamma0 p, D2 = (d2p/dv2)_s = F'' + Gamma0 D1, v = rho0/rho.
  template <Lane V>
  [[nodiscard]] G27_INLINE V fundamental_derivative(V rho, V p) const noexcept {
    Reference<V> const r = reference(rho);
    V const d1 = r.slope + Gamma0 * (p - r.base);
    return 0.5 * (rho0 / rho) * (r.curvature / d1 + Gamma0);
  }
  /// dK/dp = 4 s - 1 at (rho0, p = 0).
  [[nodiscard]] double isentropic_exponent() const noexcept { return 4.0 * s - 1.0; }
  [[nodiscard]] constexpr double vacuum_pressure() const noexcept { return -bulk_modulus_0() / (4.0 * s); }

  // The thermal form p = p_cold(rho) + t, e = e_cold(rho) + t/(Gamma rho), as the exact Riemann solver needs it.

  /// Pressure [Pa] of the isentrope through (rho0, p = 0): F + Gamma0 rho0 e_cold.
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_pressure(V rho) const noexcept {
    V const eta = 1.0 - rho0 / rho;
    return select(eta > V(0.0), compressed_pressure(eta), tension(eta) + vacuum_pressure());
  }
  /// Energy [J/kg] on that isentrope.
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_energy(V rho) const noexcept {
    V const eta = 1.0 - rho0 / rho;
    return select(eta > V(0.0), compressed_energy(eta), expanded_energy(min(eta, 0.0))) * (1.0 / rho0);
  }
  /// cold_pressure - vacuum_pressure, without cancellation as rho -> 0.
  template <Lane V>
  [[nodiscard]] G27_INLINE V cold_excess(V rho) const noexcept {
    V const eta = 1.0 - rho0 / rho;
    return select(eta > V(0.0), compressed_pressure(eta) - vacuum_pressure(), tension(eta));
  }
  /// Bulk modulus [Pa] of (rho, t).
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus_thermal(V rho, V t) const noexcept {
    V const v = rho0 / rho, eta = 1.0 - v;
    Reference<V> const r = reference(rho);
    V const cold = select(eta > V(0.0), r.slope + Gamma0 * cold_pressure(rho), r.slope);
    return v * (cold + Gamma0 * t);
  }
  /// t(to)/t(from) along an isentrope.
  template <Lane V>
  [[nodiscard]] G27_INLINE V thermal_ratio(V from, V to) const noexcept {
    return exp(max(Gamma0 * (rho0 / from - rho0 / to), -700.0));
  }
  /// Upper bound [kg/m^3] of the density at which the isentrope through (rho, t) has fallen to the excess q over the
  /// vacuum's pressure: there the larger of the two exponentials alone makes q.
  template <Lane V>
  [[nodiscard]] G27_INLINE V expanded_density(V rho, V t, V q) const noexcept {
    V const v_t = rho0 / rho + log(t / q) * (1.0 / Gamma0);
    V const v_c = 1.0 + log(-vacuum_pressure() / q) * (1.0 / (4.0 * s));
    return rho0 / max(max(v_t, v_c), rho0 / rho);
  }
  /// Velocity [m/s] gained from (rho, c) down to rho = 0 where only t is left.
  template <Lane V>
  [[nodiscard]] G27_INLINE V thermal_escape(V rho, V c) const noexcept {
    return (2.0 / (Gamma0 * rho0)) * rho * c;
  }
  /// Step in -ln(rho) over which Gauss quadrature of c reaches round-off: D1 has a pole at eta = 1/s, a jump of its
  /// third derivative at eta = 0 and zeros at Im(eta) > pi/(4 s).
  template <Lane V>
  [[nodiscard]] G27_INLINE V smooth_step(V rho) const noexcept {
    V const v = rho0 / rho, pole = v - (1.0 - 1.0 / s);
    V const to_origin = select(v < V(1.0), log(1.0 / min(v, 1.0)), V(1.0));
    V const smooth = min(select(v < V(1.0), 0.45 * pole, V(1.0)), 0.3 / s) / v;
    // a sliver that would be left before eta = 0 is taken with the last step
    return select(to_origin < 1.001 * smooth, max(to_origin, 1e-9), smooth);
  }
  /// Specific volume [m^3/kg] that shocks from rho approach as their strength grows.
  template <Lane V>
  [[nodiscard]] G27_INLINE V strong_shock_volume(V rho) const noexcept {
    return max(1.0 / rho - 2.0 / (Gamma0 * rho0), (1.0 - 1.0 / s) / rho0);
  }

 private:
  [[nodiscard]] constexpr double bulk_modulus_0() const noexcept { return rho0 * c0 * c0; }

  template <Lane V>
  struct Reference {
    V f, slope, base, curvature;  ///< F; F' = slope - Gamma0 base; F''
  };
  template <Lane V>
  [[nodiscard]] G27_INLINE Reference<V> reference(V rho) const noexcept {
    V const eta = 1.0 - rho0 / rho;
    Mask<V> const compression = eta > V(0.0);
    V const x = max(eta, 0.0), z = 1.0 / (1.0 - s * x), g = 1.0 - 0.5 * Gamma0 * x;
    V const h = bulk_modulus_0() * z * z;  // the Hugoniot is P = h x, and F = P g
    V const dh = h * (1.0 + s * x) * z, ddh = h * z * z * (4.0 * s + 2.0 * s * s * x);
    // In expansion F' + Gamma0 p = p_c' + Gamma0 (p - p_c): positive term by term wherever p > p_c.
    V const y = min(eta, 0.0), q = tension(y);
    V const c = q + vacuum_pressure();
    return {select(compression, h * x * g, c - Gamma0 * expanded_energy(y)),
            select(compression, dh * g - 0.5 * Gamma0 * h * x, 4.0 * s * q), select(compression, V(0.0), c),
            select(compression, ddh * g - Gamma0 * dh, 4.0 * s * (4.0 * s - Gamma0) * q)};
  }

  /// Expansion: p_c above the strength in tension, and rho0 e_c = integral of p_c d eta.
  template <Lane V>
  [[nodiscard]] G27_INLINE V tension(V eta) const noexcept {
    return (bulk_modulus_0() / (4.0 * s)) * exp(max(4.0 * s * min(eta, 0.0), -700.0));
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V expanded_energy(V eta) const noexcept {
    return (tension(eta) + vacuum_pressure()) * (1.0 / (4.0 * s)) + vacuum_pressure() * eta;
  }

  /// Compression, eta > 0 (elsewhere of no meaning): p_c = F + Gamma0 rho0 e_c.
  template <Lane V>
  [[nodiscard]] G27_INLINE V compressed_pressure(V eta) const noexcept {
    V const x = max(eta, 0.0), z = 1.0 / (1.0 - s * x);
    return bulk_modulus_0() * z * z * x * (1.0 - 0.5 * Gamma0 * x) + Gamma0 * compressed_energy(x);
  }
  /// rho0 e_c = exp(Gamma0 eta) int_0^eta F(x) exp(-Gamma0 x) dx in closed form: with X = Gamma0/s, z = 1 - s eta,
  /// F is a quadratic in z over z^2, and int_z^1 exp(X y)/y dy = S(X) - S(X z) - ln z, S(y) = sum y^k/(k k!).
  /// Out of line: long, and called from many places of the exact solver.
  template <Lane V>
  [[nodiscard, gnu::noinline]] V compressed_energy(V eta) const noexcept {
    if (!any(eta > V(0.0))) {
      return V(0.0);
    }
    double const X = Gamma0 / s;
    V const z = max(1.0 - s * max(eta, 0.0), 1e-12);
    V const growth = exp(X * (1.0 - z));
    V const integral = series(V(X)) - series(X * z) - log(z);
    return (bulk_modulus_0() / (s * s)) *
           ((1.0 - 0.5 * X) * (1.0 / z - growth) - ((1.0 - 2.0 * X + 0.5 * X * X) * exp(-X)) * growth * integral -
            0.5 * (growth - 1.0));
  }
  /// S(y) for 0 <= y <= 2: 24 terms reach round-off.
  template <Lane V>
  [[nodiscard]] G27_INLINE static V series(V y) noexcept {
    V sum(0.0);
    for (int k = 24; k >= 1; --k) {
      // S = y (1 + y/2 (1/2 + y/3 (1/3 + ...))): the k-th bracket carries 1/k
      sum = (y / static_cast<double>(k)) * (1.0 / k + sum);
    }
    return sum;
  }
};

}  // namespace g27
