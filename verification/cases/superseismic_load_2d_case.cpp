/// The solid under a superseismic shock: the pressure that the gas would leave runs along the surface faster than the P
/// waves. Angles of both fronts and of the surface behind the foot.
#include <algorithm>
#include <cmath>
#include <memory>

#include "verification/cases/solid_problem.hpp"
#include "verification/exact/superseismic.hpp"

namespace g27 {

namespace {

constexpr double length = 1, depth = 0.5;               ///< of the box [m]
constexpr double first_foot = 0.6, last_foot = 0.9;     ///< of the shock along the surface [m]
constexpr double load = 1e-6;                           ///< of the P waves' modulus: the reference is linear
constexpr double gamma = 1.4, mach = 3;                 ///< of the gas
constexpr double least_depth = 0.1, most_depth = 0.35;  ///< between which fronts are fitted [m]

/// A solid of that speed over its P waves, and a thin gas.
SuperseismicSetup setup_of(SolidMedium const& m, double speed) {
  double const K = bulk_modulus(m.exact.law, m.rho0, 0.0), mu = m.exact.mu;
  double const V = speed * m.sound, jump = 2 * gamma / (gamma + 1) * (mach * mach - 1);
  double const p = load * (K + 4.0 / 3 * mu) / jump;
  return {.gamma = gamma,
          .gas_density = gamma * p * mach * mach / (V * V),
          .gas_pressure = p,
          .solid_density = m.rho0,
          .lambda = K - 2.0 / 3 * mu,
          .mu = mu,
          .speed = V};
}

SolidPoint state_of(SolidMedium const& m, Superseismic::Solid const& s) {
  double const trace = s.grad[0][0] + s.grad[1][1], mu = m.exact.mu;
  Tensor6 const S{2 * mu * (s.grad[0][0] - trace / 3),
                  2 * mu * (s.grad[1][1] - trace / 3),
                  -2 * mu * trace / 3,
                  mu * (s.grad[0][1] + s.grad[1][0]),
                  0,
                  0};
  return solid_state(m, m.rho0 * (1 - trace), {s.u[0], s.u[1], 0}, -bulk_modulus(m.exact.law, m.rho0, 0.0) * trace, S);
}

/// Angle to the surface of the front, by least squares over rows: behind it, to the left end of the box, a field is
/// `behind`, ahead of it zero, so that the field's integral along a row over `behind` is where the front lies.
template <class Field>
double front_angle(SolidGrid const& grid, double behind, Field const& field) {
  Int3 const n = grid.cells();
  double count = 0, sum_x = 0, sum_y = 0, sum_yy = 0, sum_xy = 0;
  for (int j = 0; j < n[1]; ++j) {
    double const y = grid.centre({0, j, 0})[1] - depth;
    if (-y < least_depth || -y > most_depth) continue;
    double x = 0;
    for (int i = 0; i < n[0]; ++i) x += field(grid.primitive({i, j, 0})) / behind * grid.widths()[0];
    count += 1, sum_x += x, sum_y += y, sum_yy += y * y, sum_xy += x * y;
  }
  double const slope = (count * sum_xy - sum_x * sum_y) / (count * sum_yy - sum_y * sum_y);
  return std::atan2(1.0, slope);
}

void measure(Superseismic const& exact, SolidMedium const& m, double V, SolidGrid const& grid, CaseResult& r) {
  auto const hold = [&](std::string const& name, double found, double angle) {
    r.facts[name] = found, r.facts[name + "_error"] = found / angle - 1;
  };
  // an S wave leaves the pressure alone, a P wave what moves along it
  double const t[2]{std::cos(exact.p_wave_angle()), std::sin(exact.p_wave_angle())};
  hold("p_wave_angle", front_angle(grid, state_of(m, exact.behind_p()).p, [](SolidPoint const& s) { return s.p; }),
       exact.p_wave_angle());
  hold("s_wave_angle",
       front_angle(grid, t[0] * exact.behind_s().u[0] + t[1] * exact.behind_s().u[1],
                   [&](SolidPoint const& s) { return t[0] * s.u[0] + t[1] * s.u[1]; }),
       exact.s_wave_angle());
  // the surface behind the foot sinks by the velocity over V
  Int3 const n = grid.cells();
  double sum = 0, count = 0;
  for (int i = 0; i < n[0]; ++i) {
    double const behind = last_foot - grid.centre({i, 0, 0})[0];
    if (behind < 0.1 || behind > 0.4) continue;
    // linear to the surface
    double const a = grid.primitive({i, n[1] - 1, 0}).u[1], b = grid.primitive({i, n[1] - 2, 0}).u[1];
    sum += 1.5 * a - 0.5 * b, count += 1;
  }
  hold("interface_angle", -sum / count / V, exact.interface_angle());
}

}  // namespace

Case superseismic_load_2d_case() {
  Case out{.name = "superseismic-load-2d",
           .title = "pressure that runs along an elastic half-space faster than its waves: angles of the fronts",
           .source = "exact: verification/exact/superseismic.hpp; the gas is its exact pressure",
           .dimensions = 2,
           .default_cells = 128,
           .solid = true,
           .eos = {"steel"},
           .meshes = {"fixed"},
           .parameters = {{"speed", 1.25, "1", "of the load, over that of P waves", 1.05, 3}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium("steel");
    SuperseismicSetup const setup = setup_of(m, value_of(parameters, options, "speed"));
    auto const exact = std::make_shared<Superseismic const>(setup);
    double const V = setup.speed, pressure = exact->gas_behind().p - setup.gas_pressure;
    auto const state = [=](Vec3 const& x, double t) {
      return state_of(m, exact->solid(x[0] - first_foot - V * t, std::fmin(x[1] - depth, 0.0)));
    };
    SolidProblem problem{.solid = m.scheme, .dimensions = 2, .upper = {length, depth, 1}};
    problem.t_end = (last_foot - first_foot) / V;
    for (SolidBoundary& side : problem.sides) side = solid_inflow(state);
    double const h = length / options.cells.value_or(128);
    problem.sides[3] = {.kind = SolidBoundary::Kind::traction, .traction = [=](Vec3 const& x, double t) -> Vec3 {
                          // the part of the face that the foot has passed
                          double const share = std::clamp((first_foot + V * t - x[0]) / h + 0.5, 0.0, 1.0);
                          return {0, -pressure * share, 0};
                        }};
    auto const at = [=](double t) {
      return solid_mean(
          2, [=](Vec3 const& x) { return state(x, t); }, 8);
    };
    problem.initial = at(0), problem.reference = at(problem.t_end);
    problem.measure = [=](SolidGrid const& grid, CaseResult& r) { measure(*exact, m, V, grid, r); };
    return run_problem("superseismic-load-2d", 128, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
