#include "verification/exact/sedov.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verification/exact/cell_average.hpp"
#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {
/// Inwards to r/R = exp(-12), then by power laws. Cubic interpolation in steps of 4e-4 keeps 12 digits at the shock.
constexpr double depth = 12;
constexpr int intervals = 30000;
}  // namespace

Sedov::Sedov(double gamma, int symmetry, double energy, double rho0)
    : gamma_(gamma), symmetry_(symmetry), energy_(energy), rho0_(rho0), delta_(2.0 / (symmetry + 3)) {
  int const j = symmetry + 1;
  // V runs from 2/(gamma + 1) at the shock to 1/gamma at the centre; beyond this gamma it would have to grow instead
  double const largest = j == 1 ? 1e300 : (3.0 * j - 2) / (j - 2 > 0 ? j - 2 : 1e-300);
  if (!(gamma > 1) || gamma >= largest || !(energy > 0) || !(rho0 > 0))
    throw NumericsError("Sedov: gamma must exceed 1 and stay below the vacuum limit; energy and density be positive");
  std::vector<double> lambda;
  for (int i = 0; i <= intervals; ++i) lambda.push_back(-depth * i / intervals);
  // fourth component: the energy inside, per rho0 delta^2 R^(j + 2)/t^2 and per steradian, counted inwards
  auto equations = [&](double x, double const* y, double* out) {
    Similarity const s{y[0], y[1], y[2]}, d = slope(s);
    double const G = std::exp(s.log_G), P = std::exp(s.log_P), V = 1 / gamma_ + std::exp(s.q);
    out[0] = d.q;
    out[1] = d.log_G;
    out[2] = d.log_P;
    out[3] = (G * V * V / 2 + P / (gamma_ - 1)) * std::exp((j + 2) * x);
  };
  double const V_shock = 2 / (gamma + 1), q_shock = std::log((gamma - 1) / (gamma * (gamma + 1)));
  for (auto const& y :
       solve_ode(equations, {q_shock, std::log((gamma + 1) / (gamma - 1)), std::log(V_shock), 0}, lambda)) {
    Similarity const s{y[0], y[1], y[2]};
    nodes_.push_back(s);
    slopes_.push_back(slope(s));
    double const V = 1 / gamma + std::exp(s.q), Z = gamma * std::exp(s.log_P - s.log_G);
    residual_ = std::max(residual_, std::fabs(Z * std::exp(s.q) / ((gamma - 1) * V * V * (1 - V) / 2) - 1));
    // inside the last node r^2 P is constant and the kinetic energy negligible
    alpha_ = -y[3] + std::exp(s.log_P - depth * (j + 2)) / ((gamma - 1) * j);
  }
  double const directions = j == 1 ? 2 : j == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi;
  alpha_ *= directions * delta_ * delta_;
}

Sedov::Similarity Sedov::slope(Similarity const& s) const {
  double const gap = std::exp(s.q), V = 1 / gamma_ + gap, w = V - 1, j = symmetry_ + 1;
  double const S = -(gamma_ - 1) * V * V * w / 2;
  double const dq = (j * S + w * V * (1 / delta_ - V)) / (w * w * gap - S), dV = gap * dq;
  double const dG = -(dV + j * V) / w;
  return {dq, dG, gamma_ * dG + (2 / delta_ - 2 * V) / w};
}

Sedov::Similarity Sedov::similarity(double lambda) const {
  double const h = -depth / intervals, place = lambda / h;
  if (place >= intervals) {
    // power laws reach to the centre
    Similarity const &last = nodes_.back(), &d = slopes_.back();
    double const rest = lambda + depth;
    return {last.q + d.q * rest, last.log_G + d.log_G * rest, last.log_P + d.log_P * rest};
  }
  auto const i = static_cast<std::size_t>(std::max(place, 0.0));
  double const s = std::max(place, 0.0) - static_cast<double>(i);
  Similarity const &a = nodes_[i], &b = nodes_[i + 1], &da = slopes_[i], &db = slopes_[i + 1];
  return {hermite(s, h, a.q, da.q, b.q, db.q), hermite(s, h, a.log_G, da.log_G, b.log_G, db.log_G),
          hermite(s, h, a.log_P, da.log_P, b.log_P, db.log_P)};
}

double Sedov::shock_radius(double t) const { return std::pow(energy_ * t * t / (alpha_ * rho0_), delta_ / 2); }

GasState<> Sedov::shocked(double t) const {
  double const speed = delta_ * shock_radius(t) / t;
  return {rho0_ * (gamma_ + 1) / (gamma_ - 1), 2 * speed / (gamma_ + 1), 2 * rho0_ * speed * speed / (gamma_ + 1)};
}

GasState<> Sedov::at(double r, double t) const {
  double const R = shock_radius(t);
  if (r > R) return {rho0_, 0, 0};
  // nothing below the smallest positive number: the density there is zero
  double const lambda = std::log(std::max(r / R, 1e-300));
  Similarity const s = similarity(lambda);
  // p is finite at the centre: r^2 and P in one exponent
  double const p_unit = rho0_ * delta_ * delta_ * R * R / (t * t);
  return {rho0_ * std::exp(s.log_G), delta_ * r / t * (1 / gamma_ + std::exp(s.q)),
          p_unit * std::exp(s.log_P + 2 * lambda)};
}

GasConserved<> Sedov::average(double r0, double r1, double t) const {
  std::array<double, 1> const shock{shock_radius(t)};
  return cell_average(
      IdealLaw{gamma_}, [&](double r) { return at(r, t); }, r0, r1, symmetry_, shock, 16);
}

}  // namespace g27
