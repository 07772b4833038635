#include "verification/exact/simple_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/exact/cell_average.hpp"

namespace g27 {
namespace {
/// Cubic interpolation on this many intervals a side leaves an error below round-off: (1/1000)^4/384.
constexpr int intervals = 1000;
}  // namespace

SimpleWave::SimpleWave(ExactEos const& eos, GasState<> const& base, ScalarFunction perturbation, double amplitude,
                       Running running)
    : isentrope_(eos, base.rho, base.p),
      base_(base),
      perturbation_(std::move(perturbation)),
      amplitude_(std::fabs(amplitude)),
      sign_(running == Running::right ? 1 : -1) {
  if (amplitude_ == 0) amplitude_ = 1e-300;
  if (-amplitude_ <= isentrope_.vacuum_invariant())
    throw NumericsError("the amplitude of the simple wave reaches a vacuum");
  // d rho/d w = rho/c, in units of the base density and sound speed
  double const c0 = isentrope_.sound_speed(base.rho);
  auto slope = [&](double, double const* rho, double* out) {
    *out = *rho * c0 / isentrope_.sound_speed(*rho * base.rho);
  };
  std::vector<double> up{0}, down{0};
  for (int i = 1; i <= intervals; ++i) {
    up.push_back(amplitude_ / c0 * i / intervals);
    down.push_back(-up.back());
  }
  auto const above = solve_ode(slope, {1.0}, up), below = solve_ode(slope, {1.0}, down);
  for (int i = intervals; i > 0; --i) rho_.push_back(base.rho * below[static_cast<std::size_t>(i)][0]);
  for (auto const& value : above) rho_.push_back(base.rho * value[0]);
  for (double const rho : rho_) slope_.push_back(rho / isentrope_.sound_speed(rho));
}

double SimpleWave::density(double w) const {
  double const step = amplitude_ / intervals;
  double const place = std::clamp((w * sign_ + amplitude_) / step, 0.0, 2.0 * intervals);
  auto const i = std::min(static_cast<std::size_t>(place), rho_.size() - 2);
  return hermite(place - static_cast<double>(i), step, rho_[i], slope_[i], rho_[i + 1], slope_[i + 1]);
}

GasState<> SimpleWave::state_of(double w) const {
  double const rho = density(w);
  return {rho, base_.u + w, isentrope_.pressure(rho)};
}

double SimpleWave::characteristic_speed(double w) const {
  return base_.u + w + sign_ * isentrope_.sound_speed(density(w));
}

GasState<> SimpleWave::at(double x, double t) const {
  if (t == 0) return state_of(perturbation_(x));
  double const a = characteristic_speed(-amplitude_) * t, b = characteristic_speed(amplitude_) * t;
  // convex: the speed is monotone in w, so the foot lies between the two; widened by round-off
  double const widen = 1e-9 * std::fabs(b - a);
  auto miss = [&](double foot) { return foot + characteristic_speed(perturbation_(foot)) * t - x; };
  double const foot = find_root(miss, x - std::max(a, b) - widen, x - std::min(a, b) + widen);
  return state_of(perturbation_(foot));
}

GasConserved<> SimpleWave::average(double x0, double x1, double t) const {
  return cell_average(
      isentrope_.eos(), [&](double x) { return at(x, t); }, x0, x1);
}

double SimpleWave::breaking_time(double x0, double x1, int samples) const {
  double const h = (x1 - x0) / samples;
  double steepest = 0, last = characteristic_speed(perturbation_(x0));
  for (int i = 1; i <= samples; ++i) {
    double const next = characteristic_speed(perturbation_(x0 + i * h));
    steepest = std::max(steepest, (last - next) / h);
    last = next;
  }
  return steepest > 0 ? 1 / steepest : std::numeric_limits<double>::infinity();
}

}  // namespace g27
