#include "verification/exact/chapman_jouguet.hpp"

#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

/// The Chapman-Jouguet wave whose products have the state (rho, p).
ChapmanJouguet wave(ExactEos const& products, double rho0, double rho, double p, double p0) {
  double const compression = 1 - rho0 / rho, D = std::sqrt((p - p0) / (rho0 * compression));
  double const E0 = rho0 * energy(products, rho, p) - (p + p0) * compression / 2;
  return {.D = D, .state = {rho, D * compression, p}, .E0 = E0, .rho0 = rho0};
}

/// First sign change of f over ratios v = rho0/rho that fall from just below 1.
double first_root(ScalarFunction const& f) {
  constexpr int steps = 400;
  double last = 1 - 1e-6, f_last = f(last);
  for (int i = 1; i < steps; ++i) {
    double const v = 1 - 0.9 * i / steps, f_v = f(v);
    if (f_last * f_v <= 0) return find_root(f, v, last);
    last = v;
    f_last = f_v;
  }
  throw NumericsError("no Chapman-Jouguet state: the Rayleigh line does not touch the Hugoniot");
}

}  // namespace

ChapmanJouguet chapman_jouguet(ExactEos const& products, double rho0, double E0, double p0) {
  // The Hugoniot is linear in p at fixed v, because the laws are linear in e: p from two values of its residual.
  auto pressure_at = [&](double v) {
    auto residual = [&](double p) { return rho0 * energy(products, rho0 / v, p) - E0 - (p + p0) * (1 - v) / 2; };
    double const at_0 = residual(0), unit = std::fabs(E0) + std::fabs(p0);
    return -at_0 * unit / (residual(unit) - at_0);
  };
  // Sonic: rho c^2/v = (p - p0)/(1 - v), the slopes of isentrope and Rayleigh line. Multiplied by 1 - v.
  double const v = first_root([&](double ratio) {
    double const rho = rho0 / ratio, p = pressure_at(ratio);
    double const c2 = std::visit([&](auto const& law) { return law.bulk_modulus(rho, p) / rho; }, products);
    return rho * c2 * (1 - ratio) / ratio - (p - p0);
  });
  return wave(products, rho0, rho0 / v, pressure_at(v), p0);
}

ChapmanJouguet chapman_jouguet_of_isentrope(JwlLaw const& law, double C) {
  auto p = [&](double v) {
    return law.A * std::exp(-law.R1 * v) + law.B * std::exp(-law.R2 * v) + C * std::pow(v, -1 - law.omega);
  };
  auto slope = [&](double v) {
    return -law.R1 * law.A * std::exp(-law.R1 * v) - law.R2 * law.B * std::exp(-law.R2 * v) -
           (1 + law.omega) * C * std::pow(v, -2 - law.omega);
  };
  double const v = first_root([&](double ratio) { return p(ratio) + (1 - ratio) * slope(ratio); });
  return wave(law, law.rho0, law.rho0 / v, p(v), 0);
}

ChapmanJouguet chapman_jouguet_of_speed(IdealLaw const& law, double rho0, double D) {
  return wave(law, rho0, rho0 * (law.gamma + 1) / law.gamma, rho0 * D * D / (law.gamma + 1), 0);
}

}  // namespace g27
