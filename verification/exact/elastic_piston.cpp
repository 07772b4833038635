#include "verification/exact/elastic_piston.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr std::size_t times = 96;      ///< collocation points in a period, even
constexpr std::size_t masses = 400;    ///< intervals between the contact and the depth
constexpr std::size_t stage = 20;      ///< intervals between two looks at the steepest wave
constexpr int velocities = 1000;       ///< intervals of the solid's table on each side of w = 0
constexpr double least_decay = 1e-10;  ///< of the highest harmonics, over the amplitude

/// Derivative by t of a function of the period T given at the collocation points.
class Differentiation {
 public:
  explicit Differentiation(double period) {
    for (std::size_t k = 1; k < times; ++k) {
      double const sign = k % 2 == 0 ? 1 : -1;
      row_[k] = std::numbers::pi / period * sign / std::tan(std::numbers::pi * static_cast<double>(k) / times);
    }
  }
  void apply(double const* f, double* slope) const {
    for (std::size_t i = 0; i < times; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < times; ++j) sum += row_[(i + times - j) % times] * f[j];
      slope[i] = sum;
    }
  }

 private:
  double row_[times] = {};
};

/// Weights of the trigonometric interpolant at t.
std::vector<double> weights_at(double t, double period) {
  std::vector<double> w(times);
  for (std::size_t j = 0; j < times; ++j) {
    double const half = std::numbers::pi * (t / period - static_cast<double>(j) / times);
    double const s = std::sin(half);
    w[j] = std::fabs(s) < 1e-14 ? 1.0 : std::sin(times * half) * std::cos(half) / (times * s);
  }
  return w;
}

/// Largest amplitude of the highest quarter of the harmonics over the largest of all but the mean.
double high_share(std::vector<double> const& f) {
  double high = 0, all = 1e-300;
  for (std::size_t k = 1; k <= times / 2; ++k) {
    double c = 0, s = 0;
    for (std::size_t j = 0; j < times; ++j) {
      double const phase = two_pi * static_cast<double>(j * k % times) / times;
      c += f[j] * std::cos(phase), s += f[j] * std::sin(phase);
    }
    double const amplitude = std::hypot(c, s);
    all = std::max(all, amplitude);
    if (k > 3 * times / 8) high = std::max(high, amplitude);
  }
  return high / all;
}

}  // namespace

ElasticPiston::ElasticPiston(ElasticPistonSetup const& setup)
    : setup_(setup), isentrope_(setup.eos, setup.gas.rho, setup.gas.p), rho_base_(setup.law.rho0) {
  double lo = setup_.law.rho0, hi = lo;
  while (stress(hi) < setup_.gas.p) hi *= 1.5;
  if (hi > lo) rho_base_ = find_root([&](double rho) { return stress(rho) - setup_.gas.p; }, lo, hi);
  // d rho/dw = rho/a in a wave that runs to the right
  auto slope = [&](double, double const* rho, double* out) { *out = *rho / sound_speed(*rho); };
  std::vector<double> up, down;
  for (int i = 0; i <= velocities; ++i) {
    up.push_back(setup_.velocity * i / velocities);
    down.push_back(-up.back());
  }
  auto const above = solve_ode(slope, {rho_base_}, up), below = solve_ode(slope, {rho_base_}, down);
  for (std::size_t i = velocities; i > 0; --i) rho_.push_back(below[i][0]);
  for (auto const& value : above) rho_.push_back(value[0]);
  for (double const rho : rho_) rho_slope_.push_back(rho / sound_speed(rho));
  march();
}

double ElasticPiston::position(double t) const {
  return setup_.velocity * setup_.period / two_pi * (1 - std::cos(two_pi * t / setup_.period));
}
double ElasticPiston::velocity(double t) const { return setup_.velocity * std::sin(two_pi * t / setup_.period); }
double ElasticPiston::pressure(double t) const { return stress(density(velocity(t))); }

double ElasticPiston::stress(double rho) const {
  return setup_.law.pressure(rho, 0.0) + 4.0 / 3 * setup_.mu * std::log(rho / setup_.law.rho0);
}
double ElasticPiston::sound_speed(double rho) const {
  return std::sqrt((setup_.law.bulk_modulus(rho, 0.0) + 4.0 / 3 * setup_.mu) / rho);
}
double ElasticPiston::density(double w) const {
  double const step = setup_.velocity / velocities;
  double const place = std::clamp((w + setup_.velocity) / step, 0.0, 2.0 * velocities);
  auto const i = std::min(static_cast<std::size_t>(place), rho_.size() - 2);
  return hermite(place - static_cast<double>(i), step, rho_[i], rho_slope_[i], rho_[i + 1], rho_slope_[i + 1]);
}

void ElasticPiston::march() {
  Differentiation const d_dt(setup_.period);
  std::vector<double> start(3 * times);  // rho, u, x of the gas at the times
  for (std::size_t j = 0; j < times; ++j) {
    double const t = setup_.period * static_cast<double>(j) / times;
    start[j] = isentrope_.density(pressure(t)), start[times + j] = velocity(t), start[2 * times + j] = position(t);
  }
  std::vector<double> rho_t(times), u_t(times);
  auto const slope = [&](double, double const* y, double* out) {
    double const *rho = y, *u = y + times;
    d_dt.apply(rho, rho_t.data());
    d_dt.apply(u, u_t.data());
    for (std::size_t j = 0; j < times; ++j) {
      if (!(rho[j] > 0)) throw NumericsError("a wave breaks in the gas");
      double const c = isentrope_.sound_speed(rho[j]);
      out[j] = -u_t[j] / (c * c);
      out[times + j] = -rho_t[j] / (rho[j] * rho[j]);
      out[2 * times + j] = 1 / rho[j];
    }
  };
  // in stages: where a wave steepens the march would take ever smaller steps
  std::vector<std::vector<double>> values{start};
  for (std::size_t first = 0; first < masses; first += stage) {
    std::vector<double> nodes;
    for (std::size_t i = first; i <= std::min(first + stage, std::size_t{masses}); ++i) {
      nodes.push_back(-setup_.depth * static_cast<double>(i) / masses);
    }
    auto const next = solve_ode(slope, values.back(), nodes, 1e-12, 1e-13);
    for (auto n = next.begin() + 1; n != next.end(); ++n) values.push_back(*n);
    std::vector<double> const &end = values.back(), rho(end.begin(), end.begin() + times),
                              u(end.begin() + times, end.begin() + 2 * times);
    truncation_ = std::max(high_share(rho), high_share(u));
    if (!(truncation_ < least_decay))
      throw NumericsError("a wave is about to break in the gas: give less depth or velocity");
  }
  std::vector<double> rates(3 * times);
  for (auto const& y : values) {
    slope(0, y.data(), rates.data());
    auto const part = [](std::vector<double> const& v, std::size_t k) {
      auto const from = v.begin() + static_cast<std::ptrdiff_t>(k * times);
      return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(times));
    };
    rho_node_.push_back(part(y, 0)), u_node_.push_back(part(y, 1)), x_node_.push_back(part(y, 2));
    rho_rate_.push_back(part(rates, 0)), u_rate_.push_back(part(rates, 1));
  }
}

ElasticPiston::Profile ElasticPiston::gas(double t) const {
  std::vector<double> const w = weights_at(t, setup_.period);
  auto const at = [&](std::vector<std::vector<double>> const& f) {
    std::vector<double> out(f.size(), 0.0);
    for (std::size_t i = 0; i < f.size(); ++i) {
      for (std::size_t j = 0; j < times; ++j) out[i] += w[j] * f[i][j];
    }
    return out;
  };
  Profile p;
  p.isentrope_ = &isentrope_;
  p.x_ = at(x_node_), p.rho_ = at(rho_node_), p.u_ = at(u_node_);
  p.rho_slope_ = at(rho_rate_), p.u_slope_ = at(u_rate_);
  p.step_ = -setup_.depth / masses;
  return p;
}

GasState<> ElasticPiston::Profile::at(double x) const {
  // x falls from node to node
  auto const after = std::partition_point(x_.begin(), x_.end(), [&](double v) { return v > x; });
  std::size_t const next = std::clamp<std::size_t>(static_cast<std::size_t>(after - x_.begin()), 1, x_.size() - 1);
  std::size_t const i = next - 1;
  auto const place = [&](double s) { return hermite(s, step_, x_[i], 1 / rho_[i], x_[next], 1 / rho_[next]) - x; };
  // a little beyond the interval on both sides, for what lies beyond the ends
  double const s = find_root(place, -2, 3);
  double const rho = hermite(s, step_, rho_[i], rho_slope_[i], rho_[next], rho_slope_[next]);
  return {rho, hermite(s, step_, u_[i], u_slope_[i], u_[next], u_slope_[next]), isentrope_->pressure(rho)};
}

ElasticPiston::Emission ElasticPiston::emission(double x, double t) const {
  auto const beyond = [&](double time) {
    double const w = velocity(time);
    return position(time) + (w + sound_speed(density(w))) * (t - time) - x;
  };
  double const distance = x - position(t), slowest = sound_speed(density(setup_.velocity)) - setup_.velocity;
  double const swing = setup_.velocity * setup_.period;
  double const reach = 1.5 * (std::fabs(distance) + swing) / slowest + 1e-9 * setup_.period;
  double const time = find_root(beyond, t - reach, t + (distance < 0 ? reach : 1e-9 * setup_.period));
  return {time, velocity(time)};
}

SolidPoint ElasticPiston::solid(double x, double t) const {
  double const w = emission(x, t).w, rho = density(w);
  double const sxx = -4.0 / 3 * setup_.mu * std::log(rho / setup_.law.rho0);
  SolidPoint out;
  out.rho = rho, out.u = {w, 0, 0}, out.p = setup_.law.pressure(rho, 0.0), out.e = setup_.law.energy(rho, 0.0);
  out.S = {sxx, -sxx / 2, -sxx / 2, 0, 0, 0};
  return out;
}

double ElasticPiston::particle(double x, double t) const {
  Emission const e = emission(x, t);
  double const rho = density(e.w);
  return sound_speed(rho) * rho / rho_base_ * (t - e.time);
}

double ElasticPiston::particle_velocity(double label, double t) const {
  auto const beyond = [&](double time) {
    double const rho = density(velocity(time));
    return sound_speed(rho) * rho / rho_base_ * (t - time) - label;
  };
  double const slowest = sound_speed(rho_.front()) * rho_.front() / rho_base_;
  double const reach = 1.5 * label / std::min(slowest, sound_speed(rho_.back()) * rho_.back() / rho_base_);
  return velocity(find_root(beyond, t - reach - 1e-9 * setup_.period, t + 1e-9 * setup_.period));
}

}  // namespace g27
