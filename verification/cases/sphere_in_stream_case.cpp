/// A rigid sphere held in a supersonic stream: pressure at its nose, drag.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"mach", 3, "1", "of the stream", 1.5, 10},
    {"passes", 12, "1", "end: when the stream has gone so many radii", 1, 100},
    {"moves", 0, "1", "1: the sphere moves through the gas at rest, 0: the stream comes to it", 0, 1, true}};

constexpr double gamma = 1.4;

/// Pressure where the gas comes to rest behind a normal shock, over that ahead: Rayleigh's pitot formula.
double stagnation(double mach) {
  NormalShock const s = normal_shock(gamma, mach);
  return s.pressure_ratio * std::pow(1 + 0.5 * (gamma - 1) * s.mach_behind * s.mach_behind, gamma / (gamma - 1));
}

}  // namespace

Case sphere_in_stream_case() {
  auto const run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(8);  // a radius
    // units: radius, density and pressure of the stream
    double const h = 1.0 / n, mach = value("mach"), speed = mach * std::sqrt(gamma), end = value("passes") / speed;
    bool const moves = value("moves") > 0.5;
    double const way = moves ? speed * end : 0;
    Vec3 const u{moves ? 0 : speed, 0, 0};
    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{gamma};
    // a quarter about the x axis
    int const front = 2 * n + static_cast<int>(std::ceil(way * n)), behind = 2 * n, aside = 3 * n;
    gas.lower = {-front * h, 0, 0}, gas.upper = {behind * h, aside * h, aside * h};
    gas.cells = {front + behind, aside, aside};
    for (GridBoundary& side : gas.sides) side.kind = GridBoundary::Kind::outflow;
    gas.sides[2].kind = gas.sides[4].kind = GridBoundary::Kind::wall;
    auto const stream = [=](Vec3 const&) { return GasPoint{1, u, 1}; };
    if (!moves)
      gas.sides[0] = {.kind = GridBoundary::Kind::inflow, .state = [=](Vec3 const& x, double) { return stream(x); }};
    problem.gas = stream, problem.t_end = end;
    TriangleSurface surface = make_sphere(1, 0.9 * h);
    // on the axis, with the planes y = 0 and z = 0 through it
    surface = clip_surface(clip_surface(std::move(surface), 1, 0, true, 0.3 * h), 2, 0, true, 0.3 * h);
    problem.setup.bodies.push_back({.surface = std::move(surface),
                                    .cell = h,
                                    .lower = {-1.2 - way, 0, 0},
                                    .upper = {1.2, 1.2, 1.2},
                                    .initial = {},
                                    .rigid = RigidSetup{.density = 1, .velocity = {moves ? -speed : 0, 0, 0}}});
    double const v = moves ? -speed : 0;
    problem.setup.bodies[0].rigid->given = [=](double) { return Vec3{v, 0, 0}; };
    struct Mean {
      double time = 0, drag = 0, nose = 0;
    };
    auto const mean = std::make_shared<Mean>();
    auto const last = std::make_shared<double>(0);
    // over the last third of the run
    problem.after_step = [=](OversetSolver const& solver) {
      double const dt = solver.time() - *last;
      *last = solver.time();
      if (solver.time() < 2 * end / 3) return true;
      double force = 0, area = 0, nose = 0;
      for (TriangleState const& t : solver.bodies()[0]->triangles) {
        force -= 4 * (t.pressure - 1) * t.area * t.frame.n[0];
        if (t.frame.n[0] < -std::cos(0.15)) area += t.area, nose += t.area * t.pressure;
      }
      mean->time += dt, mean->drag += dt * force, mean->nose += dt * nose / area;
      return true;
    };
    problem.measure = [=](OversetSolver const&, CaseResult& r) {
      double const push = 0.5 * gamma * mach * mach * std::numbers::pi;
      r.facts["drag_coefficient"] = mean->drag / mean->time / push;
      r.facts["nose_pressure_over_exact"] = mean->nose / mean->time / stagnation(mach);
    };
    return run_problem("sphere-in-stream", 8, std::move(problem), options);
  };
  Case out = overset_case("sphere-in-stream", "rigid sphere in a supersonic stream: pressure at its nose, drag",
                          "Rayleigh's pitot formula: NACA Report 1135, eq. 100", 8, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
