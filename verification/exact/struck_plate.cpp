#include "verification/exact/struck_plate.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {

namespace {

struct State {
  double rho, u, p;
};

/// Pressure on a wall that moves away from the gas at u - gas.u (towards it: negative).
double wall_pressure(double gamma, State const& gas, double u) {
  double const c = std::sqrt(gamma * gas.p / gas.rho), push = (gas.u - u) / c;
  if (push <= 0) return gas.p * std::pow(std::max(0.0, 1 + 0.5 * (gamma - 1) * push), 2 * gamma / (gamma - 1));
  double const a = 0.25 * (gamma + 1) * push, mach = a + std::sqrt(1 + a * a);
  return gas.p * (1 + 2 * gamma / (gamma + 1) * (mach * mach - 1));
}

/// Density behind the shock that reaches this pressure; of an expansion, by its isentrope.
double density_at(double gamma, State const& gas, double p) {
  double const x = p / gas.p, g = (gamma - 1) / (gamma + 1);
  return x > 1 ? gas.rho * (x + g) / (g * x + 1) : gas.rho * std::pow(x, 1 / gamma);
}

/// u where pressure(u) = outgoing - Z u; pressure falls with u.
template <class F>
double meet(F const& pressure, double outgoing, double Z, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    double const u = 0.5 * (low + high);
    (pressure(u) + outgoing - Z * u > 0 ? low : high) = u;
  }
  return 0.5 * (low + high);
}

}  // namespace

StruckPlate::Front StruckPlate::behind_shock(Gas const& gas, double mach) {
  if (!(mach >= 1)) throw NumericsError("struck plate: the shock's Mach number is below 1");
  double const speed = mach * std::sqrt(gas.gamma * gas.p / gas.rho);
  NormalShock const shock = normal_shock(gas.gamma, mach);
  return {.rho = gas.rho * shock.density_ratio,
          .u = speed * (1 - 1 / shock.density_ratio),
          .p = gas.p * shock.pressure_ratio,
          .shock_speed = speed};
}

StruckPlate::StruckPlate(Front const& in_front, Gas const& back, Plate const& plate, double t_end) : p0_(back.p) {
  double const g = back.gamma;
  double const a = std::sqrt(plate.stiffness / plate.rho), Z = plate.rho * a;
  tau_ = plate.thickness / a;
  State const still{back.rho, 0, back.p};
  State front{in_front.rho, in_front.u, in_front.p};
  double const bound = 10 * (front.u + std::sqrt(g * front.p / front.rho));
  // Riemann invariants of the plate, with s the compressive stress: s + Z u runs to the back, s - Z u to the front
  double to_front = back.p, to_back = back.p;
  for (double t = 0; t < t_end + tau_; t += tau_) {
    Stage s{};
    bool const first = stages_.empty();
    // front: s = p(u), s - Z u = to_front
    s.u[0] = meet([&](double u) { return wall_pressure(g, front, u); }, -to_front, Z, -bound, bound);
    s.p[0] = wall_pressure(g, front, s.u[0]);
    if (first) front = {density_at(g, front, s.p[0]), s.u[0], s.p[0]};
    // back: s = p(-u), s + Z u = to_back
    s.u[1] = -meet([&](double u) { return wall_pressure(g, still, u); }, -to_back, Z, -bound, bound);
    s.p[1] = wall_pressure(g, still, -s.u[1]);
    to_front = s.p[1] - Z * s.u[1], to_back = s.p[0] + Z * s.u[0];
    stages_.push_back(s);
  }
}

std::size_t StruckPlate::stage(double t) const {
  return std::min(stages_.size() - 1, static_cast<std::size_t>(std::max(0.0, t) / tau_));
}

double StruckPlate::displacement(int face, double t) const {
  double sum = 0;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    double const from = static_cast<double>(k) * tau_;
    if (t > from) sum += stages_[k].u[face] * std::min(tau_, t - from);
  }
  return sum;
}
double StruckPlate::velocity(int face, double t) const { return t < 0 ? 0.0 : stages_[stage(t)].u[face]; }
double StruckPlate::pressure(int face, double t) const { return t < 0 ? p0_ : stages_[stage(t)].p[face]; }

}  // namespace g27
