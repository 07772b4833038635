#include "verification/exact/oblique_shock.hpp"

#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace g27 {

NormalShock normal_shock(double gamma, double mach) {
  double const m2 = mach * mach;
  return {.density_ratio = (gamma + 1) * m2 / ((gamma - 1) * m2 + 2),
          .pressure_ratio = 1 + 2 * gamma * (m2 - 1) / (gamma + 1),
          .mach_behind = std::sqrt((m2 + 2 / (gamma - 1)) / (2 * gamma / (gamma - 1) * m2 - 1))};
}

double shock_deflection(double gamma, double mach, double angle) {
  double const normal = mach * std::sin(angle);
  return std::atan(2 / std::tan(angle) * (normal * normal - 1) / (mach * mach * (gamma + std::cos(2 * angle)) + 2));
}

double detachment_angle(double gamma, double mach) {
  double const m2 = mach * mach, g = gamma + 1;
  double const sine_squared =
      (g * m2 / 4 - 1 + std::sqrt(g * (1 + (gamma - 1) / 2 * m2 + g / 16 * m2 * m2))) / (gamma * m2);
  return std::asin(std::sqrt(sine_squared));
}

ObliqueShock oblique_shock(double gamma, double mach, double deflection, ShockBranch branch) {
  if (!(gamma > 1) || !(mach > 1) || !(deflection > 0))
    throw NumericsError("oblique shock: gamma and the Mach number must exceed 1, the deflection be positive");
  double const between = detachment_angle(gamma, mach);
  if (deflection > shock_deflection(gamma, mach, between))
    throw NumericsError("oblique shock: the deflection detaches the shock");
  bool const weak = branch == ShockBranch::weak;
  double const outer = weak ? std::asin(1 / mach) : std::numbers::pi / 2;
  double const angle = find_root([&](double b) { return shock_deflection(gamma, mach, b) - deflection; },
                                 std::fmin(outer, between), std::fmax(outer, between));
  NormalShock const normal = normal_shock(gamma, mach * std::sin(angle));
  return {.gamma = gamma,
          .mach = mach,
          .deflection = deflection,
          .angle = angle,
          .density_ratio = normal.density_ratio,
          .pressure_ratio = normal.pressure_ratio,
          .mach_behind = normal.mach_behind / std::sin(angle - deflection)};
}

}  // namespace g27
