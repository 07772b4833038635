#include "verification/exact/be_shell.hpp"

#include <cmath>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

double full_angle(int symmetry) { return (symmetry == 2 ? 4 : 2) * std::numbers::pi; }
double strain_factor(int symmetry) { return symmetry == 2 ? 2 : 2 / std::numbers::sqrt3; }

}  // namespace

double Shell::outer_radius(double a) const {
  int const n = symmetry + 1;
  return std::pow(std::pow(outer, n) - std::pow(inner, n) + std::pow(a, n), 1.0 / n);
}

double Shell::kinetic_energy(double a, double speed) const {
  double const b = outer_radius(a), shape = symmetry == 2 ? 1 / a - 1 / b : std::log(b / a);
  return rho / 2 * speed * speed * std::pow(a, 2 * symmetry) * full_angle(symmetry) * shape;
}

double Shell::plastic_work(double a) const {
  int const n = symmetry + 1;
  double const start = std::pow(inner, n), now = std::pow(a, n);
  // over the volume inside a particle, s = r0^n - R_i^n = r^n - a^n
  auto density = [&](double s) {
    double const e = strain_factor(symmetry) / n * std::log((start + s) / (now + s));
    return (yield + hardening * e / 2) * e;
  };
  return full_angle(symmetry) / n * integrate(density, 0, std::pow(outer, n) - start);
}

double Shell::retarding_force(double a) const {
  int const n = symmetry + 1;
  double const lost = std::pow(inner, n) - std::pow(a, n);
  auto density = [&](double r) {
    double const e = strain_factor(symmetry) / n * std::log1p(lost / std::pow(r, n));
    return (yield + hardening * e) / r;
  };
  return full_angle(symmetry) * strain_factor(symmetry) * std::pow(a, symmetry) *
         integrate(density, a, outer_radius(a));
}

double Shell::work_between(double a0, double a1) const {
  return integrate([&](double a) { return retarding_force(a); }, a1, a0, 1e-12);
}

double Shell::stop_radius(double u0) const {
  double const energy = kinetic_energy(inner, u0), smallest = 0.01 * inner;
  if (energy > plastic_work(smallest))
    throw NumericsError("the shell is so fast that its cavity closes, to a hundredth of its radius at least");
  return find_root([&](double a) { return plastic_work(a) - energy; }, smallest, inner);
}

double Shell::launch_speed(double radius) const { return std::sqrt(plastic_work(radius) / kinetic_energy(inner, 1)); }

double Shell::stop_time(double u0) const {
  double const stop = stop_radius(u0), way = inner - stop;
  // a = stop + way s^2 takes out the square root at the end
  auto slowness = [&](double s) {
    double const a = stop + way * s * s;
    double const speed = std::sqrt(work_between(a, stop) / kinetic_energy(a, 1));
    return 2 * way * s / speed;
  };
  return integrate(slowness, 0, 1, 1e-10);
}

double Shell::residual(double a) const { return std::fabs(work_between(inner, a) / plastic_work(a) - 1); }

}  // namespace g27
