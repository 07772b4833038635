#include "verification/exact/noh.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

GasState<> Noh::shocked() const {
  double const rho = rho0 * std::pow((gamma + 1) / (gamma - 1), symmetry + 1);
  return {rho, 0, (gamma - 1) * rho * speed * speed / 2};
}

GasState<> Noh::at(double r, double t) const {
  if (r < shock_speed() * t) return shocked();
  double const gather = r > 0 ? std::pow(1 + speed * t / r, symmetry) : 1;
  return {rho0 * gather, -speed, 0};
}

GasConserved<> Noh::average(double r0, double r1, double t) const {
  int const n = symmetry + 1;
  double const shock = std::clamp(shock_speed() * t, r0, r1);
  auto between = [n](double a, double b) { return (std::pow(b, n) - std::pow(a, n)) / n; };
  GasState<> const inner = shocked();
  double const inside = between(r0, shock), whole = between(r0, r1);
  // ahead, mass is still where it started: rho r^symmetry = rho0 (r + speed t)^symmetry
  double const ahead = rho0 * between(shock + speed * t, r1 + speed * t);
  return {(inner.rho * inside + ahead) / whole, -speed * ahead / whole,
          (inner.p / (gamma - 1) * inside + ahead * speed * speed / 2) / whole};
}

}  // namespace g27
