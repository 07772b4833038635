#pragma once
/// States and materials of the exact solutions for solids, written apart from those of the solvers they judge.
///
/// A law is p = p(rho, e), linear in e; S is the deviator of the stress sigma = -p I + S. SI units, or any consistent
/// set.
#include <array>
#include <functional>
#include <limits>
#include <span>

#include "riemann/state/solid_point.hpp"
#include "verification/exact/eos.hpp"

namespace g27 {

using Vector3 = std::array<double, 3>;
using Tensor6 = Sym3;

/// p = K (rho/rho0 - 1), whatever the energy.
struct LinearBulkLaw {
  double K = 175e9, rho0 = 7800;
  /// That of the isentrope through (rho0, e = 0): p says nothing about it.
  template <class T>
  T energy(T const& rho, T const&) const {
    using std::log;
    return K / rho0 * (log(rho / rho0) + rho0 / rho - 1);
  }
  template <class T>
  T pressure(T const& rho, T const&) const {
    return K * (rho / rho0 - 1);
  }
  template <class T>
  T bulk_modulus(T const& rho, T const&) const {
    return K * rho / rho0;
  }
};

/// Mie-Grueneisen on the shock locus of MieGruneisenLaw, with Gamma itself constant instead of Gamma rho:
/// p = p_ref + Gamma rho (e - e_ref). The law of ExactPack's elastic-plastic piston. Expanded, it goes on along the
/// locus.
struct ConstantGammaLaw {
  double rho0 = 2790, c0 = 5330, s = 1.34, Gamma = 2;
  /// p_ref, its derivative by eta, rho0 e_ref, and its derivative by eta; eta = 1 - rho0/rho.
  template <class T>
  MieGruneisenLaw::Reference<T> reference(T const& rho) const {
    T const eta = 1 - rho0 / rho, d = 1 - s * eta;
    T const p = rho0 * c0 * c0 * eta / (d * d), slope = rho0 * c0 * c0 * (1 + s * eta) / (d * d * d);
    return {p, slope, p * eta / 2, (slope * eta + p) / 2};
  }
  template <class T>
  T energy(T const& rho, T const& p) const {
    auto const r = reference(rho);
    return r.e / rho0 + (p - r.p) / (Gamma * rho);
  }
  template <class T>
  T pressure(T const& rho, T const& e) const {
    auto const r = reference(rho);
    return r.p + Gamma * rho * (e - r.e / rho0);
  }
  template <class T>
  T bulk_modulus(T const& rho, T const& p) const {
    auto const r = reference(rho);
    return rho0 / rho * r.p_slope + p - r.p + Gamma * (p - r.e_slope);
  }
};

/// Grueneisen coefficient f = (dp/de)/rho at constant density.
inline double gruneisen(LinearBulkLaw const&, double) { return 0; }
inline double gruneisen(IdealLaw const& law, double) { return law.gamma - 1; }
inline double gruneisen(StiffenedLaw const& law, double) { return law.gamma - 1; }
inline double gruneisen(JwlLaw const& law, double) { return law.omega; }
inline double gruneisen(MieGruneisenLaw const& law, double rho) { return law.Gamma0 * law.rho0 / rho; }

inline double gruneisen(ConstantGammaLaw const& law, double) { return law.Gamma; }

using ExactSolidLaw = std::variant<LinearBulkLaw, MieGruneisenLaw, ConstantGammaLaw, StiffenedLaw, IdealLaw, JwlLaw>;

inline double energy(ExactSolidLaw const& law, double rho, double p) {
  return std::visit([&](auto const& l) { return l.energy(rho, p); }, law);
}
inline double pressure(ExactSolidLaw const& law, double rho, double e) {
  return std::visit([&](auto const& l) { return l.pressure(rho, e); }, law);
}
/// rho c^2 of (rho, p), c the sound speed of the material without strength.
inline double bulk_modulus(ExactSolidLaw const& law, double rho, double p) {
  return std::visit([&](auto const& l) { return l.bulk_modulus(rho, p); }, law);
}
inline double gruneisen(ExactSolidLaw const& law, double rho) {
  return std::visit([&](auto const& l) { return gruneisen(l, rho); }, law);
}

/// Hypoelastic, of von Mises' yield stress Y = yield + hardening * plastic strain. mu = 0 is a fluid.
struct SolidMaterial {
  ExactSolidLaw law;
  double mu = 0;
  double yield = std::numeric_limits<double>::infinity();
  double hardening = 0;
};

/// Rates of change along the path of a particle, caused by the gradient L_ij = du_i/dx_j of the velocity while it loads
/// elastically: of density, pressure, energy and deviator (Jaumann's rate). `u` and `ep` stay zero.
SolidPoint elastic_rate(SolidMaterial const& material, SolidPoint const& s, double const (&L)[3][3]);

SolidDensities densities(SolidPoint const& s);
/// Mean of `state` over [x0, x1]: Gauss-Legendre quadrature with `points` nodes on every piece between x0, the `breaks`
/// inside (where the state jumps or has a kink, in increasing order) and x1.
SolidDensities solid_average(std::function<SolidPoint(double x)> const& state, double x0, double x1,
                             std::span<double const> breaks = {}, int points = 12);
/// Mean over the cell with that centre and those widths, `points` Gauss-Legendre nodes along each axis; along an axis
/// of width 0 the value at the centre.
SolidDensities solid_average(std::function<SolidPoint(Vector3 const& x)> const& state, Vector3 const& centre,
                             Vector3 const& widths, int points = 4);
/// Value of the tensor T turned by the matrix R: R T R^T.
Tensor6 turned(double const (&R)[3][3], Tensor6 const& T);

}  // namespace g27
