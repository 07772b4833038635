#include "verification/exact/superseismic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {
namespace {

using Vector = Superseismic::Vector;
using Tensor = Superseismic::Tensor;

double dot(Vector const& a, Vector const& b) { return a[0] * b[0] + a[1] * b[1]; }
Tensor outer(Vector const& a, Vector const& b) { return {{{a[0] * b[0], a[0] * b[1]}, {a[1] * b[0], a[1] * b[1]}}}; }
Vector times(Tensor const& T, Vector const& v) { return {dot(T[0], v), dot(T[1], v)}; }
Tensor sum(double a, Tensor const& A, double b, Tensor const& B) {
  Tensor out{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) out[i][j] = a * A[i][j] + b * B[i][j];
  }
  return out;
}

/// Of a front that runs into the solid below and, with the foot, along +x.
Vector front_normal(double angle) { return {std::sin(angle), -std::cos(angle)}; }

Tensor stress_of(SuperseismicSetup const& s, Tensor const& grad) {
  double const bulk = s.lambda * (grad[0][0] + grad[1][1]), shear = s.mu * (grad[0][1] + grad[1][0]);
  return {{{bulk + 2 * s.mu * grad[0][0], shear}, {shear, bulk + 2 * s.mu * grad[1][1]}}};
}

Superseismic::Solid solid_of(SuperseismicSetup const& s, Tensor const& grad) {
  return {{-s.speed * grad[0][0], -s.speed * grad[1][0]}, grad, stress_of(s, grad)};
}

double slope(Superseismic::Solid const& s) { return s.grad[1][0] / (1 + s.grad[0][0]); }

Vector surface_normal(double theta) { return {-std::sin(theta), std::cos(theta)}; }

}  // namespace

Superseismic::Superseismic(SuperseismicSetup const& setup) : setup_(setup) {
  SuperseismicSetup const& s = setup_;
  double const c_p = std::sqrt((s.lambda + 2 * s.mu) / s.solid_density), c_s = std::sqrt(s.mu / s.solid_density);
  double const c = std::sqrt(s.gamma * s.gas_pressure / s.gas_density);
  if (!(s.speed > c_p)) throw NumericsError("the foot must be faster than the P waves of the solid");
  if (!(s.speed > c)) throw NumericsError("the foot must be faster than the sound of the gas");
  p_wave_ = std::asin(c_p / s.speed), s_wave_ = std::asin(c_s / s.speed);
  auto const gap = [&](double xi) {
    double const theta = turn(xi);
    load(gas_.p - s.gas_pressure, theta);
    return std::tan(theta) - slope(behind_s_);
  };
  // upright the gas is not turned at all; beyond detachment less and less
  double const most = std::numbers::pi / 2 - detachment_angle(s.gamma, s.speed / c);
  if (!(gap(most) > 0)) throw NumericsError("the solid is too soft: no shock turns the gas as far as its surface does");
  xi_ = find_root(gap, 0, most);
  theta_ = turn(xi_);
  load(gas_.p - s.gas_pressure, theta_);
}

double Superseismic::turn(double xi) {
  SuperseismicSetup const& s = setup_;
  double const across = s.speed * std::cos(xi), along = s.speed * std::sin(xi);
  NormalShock const n = normal_shock(s.gamma, across / std::sqrt(s.gamma * s.gas_pressure / s.gas_density));
  // the gas flows in along -x, past a front whose normal, into the gas ahead, is (cos xi, -sin xi)
  double const out = across / n.density_ratio;
  gas_ = {s.gas_density * n.density_ratio,
          s.gas_pressure * n.pressure_ratio,
          {s.speed - out * std::cos(xi) - along * std::sin(xi), out * std::sin(xi) - along * std::cos(xi)}};
  return std::atan(n.density_ratio * std::tan(xi)) - xi;
}

void Superseismic::load(double P, double theta) {
  Vector const n_p = front_normal(p_wave_), n_s = front_normal(s_wave_), t{-n_s[1], n_s[0]};
  Tensor const p = outer(n_p, n_p), sh = outer(t, n_s);
  Vector const n = surface_normal(theta);
  Vector const on = setup_.normal == StressNormal::deformed ? n : Vector{0, 1};
  Vector const a = times(stress_of(setup_, p), on), b = times(stress_of(setup_, sh), on);
  double const det = a[0] * b[1] - a[1] * b[0];
  double const A = -P * (n[0] * b[1] - n[1] * b[0]) / det, B = -P * (a[0] * n[1] - a[1] * n[0]) / det;
  behind_p_ = solid_of(setup_, sum(A, p, 0, sh)), behind_s_ = solid_of(setup_, sum(A, p, B, sh));
}

bool Superseismic::in_gas(double x, double y) const { return y > (x < 0 ? x * std::tan(theta_) : 0); }

Superseismic::Gas Superseismic::gas(double x, double y) const {
  if (x * std::cos(xi_) < y * std::sin(xi_)) return gas_;
  return {setup_.gas_density, setup_.gas_pressure, {0, 0}};
}

Superseismic::Solid Superseismic::solid(double x, double y) const {
  if (dot({x, y}, front_normal(s_wave_)) < 0) return behind_s_;
  return dot({x, y}, front_normal(p_wave_)) < 0 ? behind_p_ : Solid{};
}

double Superseismic::residual() const {
  Vector const n = surface_normal(theta_);
  // the line behind the foot moves with it
  double const wall = setup_.speed * n[0], P = gas_.p - setup_.gas_pressure;
  Vector const s = times(behind_s_.stress, setup_.normal == StressNormal::deformed ? n : Vector{0, 1});
  return std::max({std::fabs(dot(gas_.u, n) - wall) / setup_.speed,
                   std::fabs(dot(behind_s_.u, n) - wall) / setup_.speed,
                   std::hypot(s[0] + P * n[0], s[1] + P * n[1]) / P});
}

}  // namespace g27
