#include "verification/exact/rigid_piston.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/exact/numerics.hpp"

namespace g27 {

namespace {

constexpr std::size_t intervals = 2000;

/// Pressure beside a wall that moves at v away from a gas.
double receding(RigidPiston::Gas const& gas, double v) {
  if (gas.p == 0) return 0;
  double const g = gas.gamma, c = std::sqrt(g * gas.p / gas.rho);
  return gas.p * std::pow(std::max(0.0, 1 - 0.5 * (g - 1) * v / c), 2 * g / (g - 1));
}

}  // namespace

RigidPiston::RigidPiston(Setup const& setup) : setup_(setup) {
  if (!(acceleration(0) > 0)) throw NumericsError("the gas behind the piston does not push it");
  std::vector<double> times(intervals + 1);
  for (std::size_t n = 0; n <= intervals; ++n) {
    times[n] = setup.t_end * static_cast<double>(n) / static_cast<double>(intervals);
  }
  path_ = solve_ode([&](double, double const* y, double* slope) { slope[0] = y[1], slope[1] = acceleration(y[1]); },
                    {0, 0}, times);
}

double RigidPiston::acceleration(double v) const {
  return (receding(setup_.behind, v) - receding(setup_.ahead, -v)) / setup_.mass_per_area;
}

double RigidPiston::pressure_behind(double t) const { return receding(setup_.behind, velocity(t)); }
double RigidPiston::pressure_ahead(double t) const { return receding(setup_.ahead, -velocity(t)); }

GasState<> RigidPiston::behind(double x, double t) const { return beside(setup_.behind, -1, x, t); }
GasState<> RigidPiston::ahead(double x, double t) const { return beside(setup_.ahead, 1, x, t); }

GasState<> RigidPiston::beside(Gas const& gas, double side, double x, double t) const {
  double const c0 = std::sqrt(gas.gamma * gas.p / gas.rho), half = 0.5 * (gas.gamma - 1);
  // how far the characteristic that left the piston at a time has come beyond x
  auto const beyond = [&](double left) {
    double const v = velocity(left);
    return side * (position(left) - x) + (c0 + side * (half + 1) * v) * (t - left);
  };
  if (beyond(0) <= 0) return {gas.rho, 0, gas.p};
  double const v = velocity(beyond(t) >= 0 ? t : find_root(beyond, 0, t)), share = 1 + side * half * v / c0;
  return {gas.rho * std::pow(share, 1 / half), v, gas.p * std::pow(share, gas.gamma / half)};
}

double RigidPiston::breaking_time() const {
  RigidPiston::Gas const& gas = setup_.ahead;
  if (gas.p == 0) return std::numeric_limits<double>::infinity();
  // its front breaks first, since the piston accelerates less and less
  return 2 * std::sqrt(gas.gamma * gas.p / gas.rho) / ((gas.gamma + 1) * acceleration(0));
}

double RigidPiston::at(double t, int component) const {
  double const h = setup_.t_end / static_cast<double>(intervals), place = std::clamp(t / h, 0.0, 1.0 * intervals);
  std::size_t const n = std::min(static_cast<std::size_t>(place), intervals - 1),
                    c = static_cast<std::size_t>(component);
  auto const slope = [&](std::size_t m) { return c == 0 ? path_[m][1] : acceleration(path_[m][1]); };
  return hermite(place - static_cast<double>(n), h, path_[n][c], slope(n), path_[n + 1][c], slope(n + 1));
}

}  // namespace g27
