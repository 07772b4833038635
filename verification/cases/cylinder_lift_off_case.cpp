/// A shock lifts a light rigid cylinder off the floor of a channel.
#include <cmath>
#include <memory>
#include <numbers>

#include "fsi/overset/gas_integrals.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"gap", 0.01, "m", "between cylinder and floor at the start; published: none", 1e-3, 0.05},
    {"density", 10.77, "kg/m^3", "of the cylinder", 1, 1e5}};

constexpr double radius = 0.05, height = 0.2, length_x = 1, gamma = 1.4, mach = 3, shock_at = 0.08;
constexpr int across = 4;                                    ///< cells between the planes of symmetry
constexpr double middle_time = 0.1641, last_time = 0.30085;  ///< at which positions are published [s]

struct Path {
  std::vector<double> time, x, y, u, v;
  GasIntegrals gas;  ///< at the start
};

/// By cubics through places and velocities.
double at(std::vector<double> const& t, std::vector<double> const& x, std::vector<double> const& u, double when) {
  std::size_t n = 1;
  while (n + 1 < t.size() && t[n] < when) ++n;
  double const h = t[n] - t[n - 1];
  return hermite((when - t[n - 1]) / h, h, x[n - 1], u[n - 1], x[n], u[n]);
}

}  // namespace

Case cylinder_lift_off_case() {
  auto const run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(40);  // across the channel
    double const h = height / n;
    NormalShock const shock = normal_shock(gamma, mach);
    double const speed = mach * std::sqrt(gamma), behind = speed * (1 - 1 / shock.density_ratio);
    auto const gas_at = [=](Vec3 const& x, double t) {
      return x[0] < shock_at + speed * t ? GasPoint{shock.density_ratio, {behind, 0, 0}, shock.pressure_ratio}
                                         : GasPoint{1, {0, 0, 0}, 1};
    };
    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{gamma};
    gas.lower = {0, 0, 0}, gas.upper = {length_x, height, across * h}, gas.cells = {5 * n, n, across};
    for (std::size_t side = 2; side < 6; ++side) gas.sides[side].kind = GridBoundary::Kind::wall;
    gas.sides[0] = {.kind = GridBoundary::Kind::inflow, .state = gas_at};
    gas.sides[1].kind = GridBoundary::Kind::outflow;
    problem.gas = [=](Vec3 const& x) { return gas_at(x, 0); };
    problem.t_end = last_time;
    Vec3 const start{0.15, radius + value("gap"), 0};
    TriangleSurface surface = placed(make_cylinder(radius, 12 * across * h, 0.9 * h), {0, 0, 1}, 0, start);
    surface = clip_surface(std::move(surface), 2, 0, true, 0.3 * h);
    surface = clip_surface(std::move(surface), 2, gas.upper[2], false, 0.3 * h);
    // the polygon has the cylinder's mass
    Mirrors planes{.lower = gas.lower, .upper = gas.upper};
    planes.low[2] = planes.high[2] = true;
    double const volume = std::numbers::pi * radius * radius * across * h;
    double const density = value("density") * volume / enclosed(surface, planes).volume;
    problem.setup.bodies.push_back({.surface = std::move(surface),
                                    .cell = h,
                                    .lower = {0, 0, 0},
                                    .upper = {length_x, height, across * h},
                                    .initial = {},
                                    .rigid = RigidSetup{.density = density}});
    auto const path = std::make_shared<Path>();
    // at the start the gas outside of the cylinder is in two uniform states
    double const slice = height * across * h, left = shock_at * slice;
    path->gas.momentum[0] = shock.density_ratio * behind * left;
    path->gas.mass = shock.density_ratio * left + (length_x - shock_at) * slice - volume;
    problem.after_step = [=](OversetSolver const& solver) {
      RigidBody const& rigid = *solver.bodies()[0]->rigid;
      auto const motion = rigid.motion();
      path->time.push_back(solver.time()), path->x.push_back(rigid.state.centre[0]);
      path->y.push_back(rigid.state.centre[1]), path->u.push_back(motion.velocity[0]);
      path->v.push_back(motion.velocity[1]);
      return true;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      Path const& p = *path;
      r.facts["x_middle"] = at(p.time, p.x, p.u, middle_time), r.facts["y_middle"] = at(p.time, p.y, p.v, middle_time);
      r.facts["x"] = p.x.back(), r.facts["y"] = p.y.back(), r.facts["u"] = p.u.back(), r.facts["v"] = p.v.back();
      RigidBody::State const& state = solver.bodies()[0]->rigid->state;
      r.facts["turned"] = 2 * std::atan2(state.rotation[3], state.rotation[0]);
      r.facts["radius_in_cells"] = radius / h;
      BodyMomentum const& held = solver.momenta()[0];
      r.facts["momentum_less_impulse"] =
          std::hypot(state.momentum[0] - held.linear[0], state.momentum[1] - held.linear[1]);
      // what the gas holds less what came through the sides and the contact
      GasIntegrals const now = gas_integrals(solver);
      GridLedger const ledger = solver.gas().ledger();
      double const momentum = now.momentum[0] - p.gas.momentum[0] - ledger.momentum[0].through_boundary;
      r.facts["gas_momentum_rest_over_impulse"] = momentum / held.linear[0] + 1;
      r.facts["gas_mass_rest"] = (now.mass - ledger.mass.through_boundary) / p.gas.mass - 1;
      r.profile["time"] = p.time, r.profile["x"] = p.x, r.profile["y"] = p.y;
    };
    return run_problem("cylinder-lift-off", 40, std::move(problem), options);
  };
  Case out = overset_case(
      "cylinder-lift-off", "shock of Mach 3 lifts a light rigid cylinder off the floor of a channel: its path",
      "Forrer and Berger, Hyperbolic Problems: Theory, Numerics, Applications (1999) 315; Arienti et al., J. Comput. "
      "Phys. 185 (2003) 213",
      40, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
