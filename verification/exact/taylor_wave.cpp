#include "verification/exact/taylor_wave.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {
/// u falls by exp(-range): beyond, u ln u is below round-off. Cubic interpolation in steps of 2e-3 errs by 4e-14.
constexpr double range = 40;
constexpr int intervals = 20000;
}  // namespace

TaylorWave::TaylorWave(ExactEos const& products, ChapmanJouguet const& front, int symmetry)
    : front_(front),
      isentrope_(products, front.state.rho, front.state.p),
      symmetry_(symmetry),
      log_u0_(std::log(front.state.u)),
      step_(-range / intervals) {
  double const rho_unit = front.state.rho;
  std::vector<double> nodes;
  for (int i = 0; i <= intervals; ++i) nodes.push_back(log_u0_ + i * step_);
  auto slope = [&](double log_u, double const* y, double* out) {
    double const xi = symmetry_ == 0 ? std::exp(log_u) + isentrope_.sound_speed(y[1] * rho_unit) : y[0] * front_.D;
    out[0] = symmetry_ == 0 ? 0 : xi_slope(log_u, xi, y[1] * rho_unit) / front_.D;
    out[1] = rho_slope(log_u, xi, y[1] * rho_unit) / rho_unit;
  };
  for (auto const& y : solve_ode(slope, {1, 1}, nodes)) {
    std::size_t const i = rho_.size();
    double const rho = y[1] * rho_unit;
    double const xi = symmetry_ == 0 ? std::exp(nodes[i]) + isentrope_.sound_speed(rho) : y[0] * front_.D;
    rho_.push_back(rho);
    xi_.push_back(xi);
    rho_slope_.push_back(rho_slope(nodes[i], xi, rho));
    xi_slope_.push_back(xi_slope(nodes[i], xi, rho));
  }
}

double TaylorWave::rho_slope(double log_u, double xi, double rho) const {
  double const u = std::exp(log_u), c = isentrope_.sound_speed(rho);
  return u * rho * (xi - u) / (c * c);
}

double TaylorWave::xi_slope(double log_u, double xi, double rho) const {
  double const u = std::exp(log_u), c = isentrope_.sound_speed(rho);
  if (symmetry_ > 0) return xi * ((xi - u - c) * (xi - u + c) / (c * c)) / symmetry_;
  // xi = u + c(rho): its slope by differences of c along the isentrope, d rho = rho du/c
  double const h = 1e-5;
  double const dc = (isentrope_.sound_speed(rho * (1 + h)) - isentrope_.sound_speed(rho * (1 - h))) / (2 * h);
  return u * (1 + dc / c);
}

double TaylorWave::xi_between(std::size_t i, double s) const {
  return hermite(s, step_, xi_[i], xi_slope_[i], xi_[i + 1], xi_slope_[i + 1]);
}
double TaylorWave::rho_between(std::size_t i, double s) const {
  return hermite(s, step_, rho_[i], rho_slope_[i], rho_[i + 1], rho_slope_[i + 1]);
}

std::pair<std::size_t, double> TaylorWave::place(double u) const {
  double const steps = (std::log(u) - log_u0_) / step_;
  auto const i = std::min(static_cast<std::size_t>(std::max(steps, 0.0)), xi_.size() - 2);
  return {i, std::clamp(steps - static_cast<double>(i), 0.0, 1.0)};
}

double TaylorWave::position(double u) const {
  auto const [i, s] = place(u);
  return xi_between(i, s) / front_.D;
}

GasState<> TaylorWave::state_of(double u) const {
  auto const [i, s] = place(u);
  double const rho = rho_between(i, s);
  return {rho, u, isentrope_.pressure(rho)};
}

GasState<> TaylorWave::at(double r_over_dt) const {
  double const xi = r_over_dt * front_.D;
  if (xi <= xi_.back()) return core_state();
  if (r_over_dt > 1) return {front_.rho0, 0, 0};
  // nodes run from the front inwards
  auto const below = std::upper_bound(xi_.begin(), xi_.end(), xi, std::greater<>());
  auto const i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(below - xi_.begin() - 1, 0, intervals - 1));
  double const inner = xi_[i + 1], outer = xi_[i];
  double const s = xi >= outer ? 0 : xi <= inner ? 1 : find_root([&](double q) { return xi_between(i, q) - xi; }, 0, 1);
  double const rho = rho_between(i, s);
  return {rho, std::exp(log_u0_ + step_ * (static_cast<double>(i) + s)), isentrope_.pressure(rho)};
}

GasConserved<> TaylorWave::average(double r0, double r1, double t) const {
  double const front = front_.D * t, edge = xi_.back() * t;
  auto measure = [&](double a, double b) {
    return (std::pow(b, symmetry_ + 1) - std::pow(a, symmetry_ + 1)) / (symmetry_ + 1);
  };
  GasConserved<> sum{0, 0, 0};
  if (r0 < front) {
    double const a = r0, b = std::min(r1, front);
    // y with r = front - y^2 takes out the square root at the front
    double const y0 = std::sqrt(front - b), y1 = std::sqrt(front - a);
    double const y_edge = edge > a && edge < b ? std::sqrt(front - edge) : y1;
    for (auto const& [from, to] : {std::pair{y0, y_edge}, std::pair{y_edge, y1}}) {
      if (!(to > from)) continue;
      auto integrand = [&](auto field) {
        return integrate(
            [&](double y) {
              double const r = front - y * y;
              return 2 * y * std::pow(r, symmetry_) * field(at(r / front));
            },
            from, to, 1e-11, measure(a, b) * 1e-3);
      };
      sum.mass += integrand([](GasState<> const& s) { return s.rho; });
      sum.momentum += front_.D * integrand([&](GasState<> const& s) { return s.rho * s.u / front_.D; });
      sum.energy += front_.E0 * integrand([&](GasState<> const& s) {
                      return s.rho * (energy(isentrope_.eos(), s.rho, s.p) + s.u * s.u / 2) / front_.E0;
                    });
    }
  }
  if (r1 > front) {
    double const outside = measure(std::max(r0, front), r1);
    sum.mass += front_.rho0 * outside;
    sum.energy += front_.E0 * outside;
  }
  double const whole = measure(r0, r1);
  return {sum.mass / whole, sum.momentum / whole, sum.energy / whole};
}

}  // namespace g27
