#pragma once
/// Equations of state of the exact solutions, written apart from those of the solvers they judge.
///
/// Each law is p = p(rho, e), linear in e. The formulas are templates on the number type, so that manufactured
/// solutions can differentiate them. Units are SI, or any consistent set.
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace g27 {

/// p = (gamma - 1) rho e.
struct IdealLaw {
  double gamma = 1.4;
  template <class T>
  T energy(T const& rho, T const& p) const {
    return p / ((gamma - 1) * rho);
  }
  template <class T>
  T pressure(T const& rho, T const& e) const {
    return (gamma - 1) * rho * e;
  }
  template <class T>
  T bulk_modulus(T const&, T const& p) const {
    return gamma * p;
  }
};

/// p = (gamma - 1) rho e - gamma p_inf (Harlow and Amsden 1971; Menikoff and Plohr 1989, IV.B).
struct StiffenedLaw {
  double gamma = 4.4, p_inf = 6e8;
  template <class T>
  T energy(T const& rho, T const& p) const {
    return (p + gamma * p_inf) / ((gamma - 1) * rho);
  }
  template <class T>
  T pressure(T const& rho, T const& e) const {
    return (gamma - 1) * rho * e - gamma * p_inf;
  }
  template <class T>
  T bulk_modulus(T const&, T const& p) const {
    return gamma * (p + p_inf);
  }
};

/// Jones, Wilkins and Lee: p = A (1 - omega/(R1 v)) exp(-R1 v) + B (1 - omega/(R2 v)) exp(-R2 v) + omega rho e,
/// v = rho0/rho (Lee, Hornig and Kury 1968). `thermal` is p less the two exponentials of the isentropes.
struct JwlLaw {
  double A = 708.6056e9, B = 13.16457e9, R1 = 4.94, R2 = 1.35, omega = 0.28, rho0 = 1650;
  template <class T>
  T thermal(T const& rho, T const& p) const {
    using std::exp;
    return p - A * exp(-R1 * rho0 / rho) - B * exp(-R2 * rho0 / rho);
  }
  template <class T>
  T energy(T const& rho, T const& p) const {
    using std::exp;
    T const v = rho0 / rho;
    T const a = A * exp(-R1 * v), b = B * exp(-R2 * v);
    return (a / R1 + b / R2 + (p - a - b) * v / omega) / rho0;
  }
  template <class T>
  T pressure(T const& rho, T const& e) const {
    using std::exp;
    T const v = rho0 / rho;
    return A * (1 - omega / (R1 * v)) * exp(-R1 * v) + B * (1 - omega / (R2 * v)) * exp(-R2 * v) + omega * rho * e;
  }
  template <class T>
  T bulk_modulus(T const& rho, T const& p) const {
    using std::exp;
    T const v = rho0 / rho;
    T const a = A * exp(-R1 * v), b = B * exp(-R2 * v);
    return v * (R1 * a + R2 * b) + (1 + omega) * (p - a - b);
  }
};

/// Mie-Grueneisen with Gamma rho = Gamma0 rho0: p = p_ref + Gamma0 rho0 (e - e_ref), eta = 1 - rho0/rho.
/// Compressed, the reference is the shock locus U_s = c0 + s u_p through (rho0, p = 0, e = 0) (Meyers 1994, 5.2):
/// p_ref = K eta/(1 - s eta)^2, e_ref = p_ref eta/(2 rho0), K = rho0 c0^2. Expanded, it is by definition the isentrope
/// p_ref = K (exp(4 s eta) - 1)/(4 s), d e_ref = p_ref d eta/rho0, which meets the locus in value, slope and curvature.
struct MieGruneisenLaw {
  double rho0 = 2790, c0 = 5330, s = 1.34, Gamma0 = 2;
  /// p_ref, its derivative by eta, rho0 e_ref, and its derivative by eta.
  template <class T>
  struct Reference {
    T p, p_slope, e, e_slope;
  };
  template <class T>
  Reference<T> reference(T const& eta) const {
    using std::exp;
    double const k = rho0 * c0 * c0, n = 4 * s;
    if (eta < 0) {
      T const growth = exp(n * eta), p = k / n * (growth - 1);
      return {p, k * growth, p / n - k / n * eta, p};
    }
    T const d = 1 - s * eta;
    T const p = k * eta / (d * d), slope = k * (1 + s * eta) / (d * d * d);
    return {p, slope, p * eta / 2, (slope * eta + p) / 2};
  }
  template <class T>
  T energy(T const& rho, T const& p) const {
    Reference<T> const r = reference(T(1 - rho0 / rho));
    return (r.e + (p - r.p) / Gamma0) / rho0;
  }
  template <class T>
  T pressure(T const& rho, T const& e) const {
    Reference<T> const r = reference(T(1 - rho0 / rho));
    return r.p + Gamma0 * (rho0 * e - r.e);
  }
  template <class T>
  T bulk_modulus(T const& rho, T const& p) const {
    // rho dp/drho along the isentrope, where de = p d eta/rho0 and d eta = rho0/rho d rho/rho
    Reference<T> const r = reference(T(1 - rho0 / rho));
    return rho0 / rho * (r.p_slope + Gamma0 * (p - r.e_slope));
  }
};

using ExactEos = std::variant<IdealLaw, StiffenedLaw, JwlLaw, MieGruneisenLaw>;

/// The name under which scenes and the command line know a law.
inline std::string eos_name(ExactEos const& eos) {
  static char const* const names[] = {"ideal", "stiffened", "jwl", "mie-gruneisen"};
  return names[eos.index()];
}
/// Specific internal energy [J/kg] of (rho [kg/m^3], p [Pa]).
inline double energy(ExactEos const& eos, double rho, double p) {
  return std::visit([&](auto const& law) { return law.energy(rho, p); }, eos);
}
/// Pressure [Pa] of (rho, e).
inline double pressure(ExactEos const& eos, double rho, double e) {
  return std::visit([&](auto const& law) { return law.pressure(rho, e); }, eos);
}
/// Adiabatic sound speed [m/s] of (rho, p).
inline double sound_speed(ExactEos const& eos, double rho, double p) {
  return std::visit([&](auto const& law) { return std::sqrt(law.bulk_modulus(rho, p) / rho); }, eos);
}

}  // namespace g27
