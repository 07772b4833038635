/// A smooth pressure pulse in gas that passes over a free elastic sphere: what it does to the sphere, in time.
#include <cmath>
#include <memory>
#include <numbers>

#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"

namespace g27 {

namespace {

// in units of the gas ahead: density and pressure 1
constexpr double gamma = 1.4, density = 4, bulk = 12, shear = 6;  ///< of gas and solid
constexpr double size = 1, radius = 0.225;                        ///< of the box across, of the sphere [m]
constexpr double centre = -0.26, half_width = 0.5;                ///< of the pulse [m]

std::vector<CaseParameter> const parameters{
    {"amplitude", 0.1, "1", "of the gas's velocity over its sound speed", 1e-4, 0.5},
    {"end", 0.5, "s", "time; sound needs 0.85 s for the length of the box behind the pulse", 0.01, 2}};

/// Simple wave that runs along x, by the velocity.
GasPoint pulse(double amplitude, double x) {
  double const c0 = std::sqrt(gamma), y = (x - centre) / half_width;
  double const u = std::fabs(y) < 1 ? amplitude * c0 * std::pow(std::cos(0.5 * std::numbers::pi * y), 4) : 0.0;
  double const c = c0 + 0.5 * (gamma - 1) * u, p = std::pow(c / c0, 2 * gamma / (gamma - 1));
  return {std::pow(p, 1 / gamma), {u, 0, 0}, p};
}

struct History {
  std::vector<double> time, momentum, position, velocity, volume;
};

void add(History& history, OversetSolver const& solver, MassProperties const& start) {
  Body const& body = *solver.bodies()[0];
  MassProperties const now = mass_properties(body.surface);
  double area = 0, velocity = 0;
  for (TriangleState const& t : body.triangles) area += t.area, velocity += t.area * t.velocity[0];
  history.time.push_back(solver.time());
  history.momentum.push_back(solver.momenta()[0].linear[0]);
  history.position.push_back(now.centroid[0] - start.centroid[0]);
  history.velocity.push_back(velocity / area);
  history.volume.push_back(now.volume / start.volume - 1);
}

}  // namespace

Case elastic_sphere_pulse_case() {
  Case out = overset_case("elastic-sphere-pulse",
                          "smooth pressure pulse over a free elastic sphere: momentum, position and velocity in time",
                          "no exact solution: the same on finer grids", 30, parameters);
  out.run = [](CaseOptions const& options) {
    int const n = options.cells.value_or(30);
    double const h = size / n, amplitude = value_of(parameters, options, "amplitude");
    Vec3 const middle{0.503, 0.507, 0.493};
    OversetProblem problem;
    problem.setup.gas = gas_cube(IdealGas{gamma}, size, n);
    for (std::size_t side = 2; side < 6; ++side) problem.setup.gas.sides[side].kind = GridBoundary::Kind::wall;
    // room for the pulse before it reaches the sphere, whole cells of it
    int const ahead = 3 * n / 4;
    problem.setup.gas.lower[0] = -h * ahead, problem.setup.gas.cells[0] = n + ahead;
    problem.gas = [=](Vec3 const& x) { return pulse(amplitude, x[0]); };
    problem.t_end = value_of(parameters, options, "end");
    // with cells in multiples of four the surfaces of all grids are similar: an icosahedron, cells/4 parts an edge
    BodySetup body{.surface = placed(make_sphere(radius, h), {0.3, 0.5, 1}, 0.6, middle),
                   .material = {.eos = BulkModulus{density, bulk}, .mu = shear},
                   .cell = h,
                   .initial = [](Vec3 const&) {
                     return SolidPoint{.rho = density * (1 + 1 / bulk), .p = 1};  // at the gas's pressure
                   }};
    double const reach = 1.2 * radius;
    body.lower = middle - Vec3{reach, reach, reach}, body.upper = middle + Vec3{reach, reach, reach};
    problem.setup.bodies.push_back(std::move(body));
    auto const start = mass_properties(problem.setup.bodies[0].surface);
    auto const history = std::make_shared<History>();
    *history = {{0}, {0}, {0}, {0}, {0}};
    problem.after_step = [=](OversetSolver const& solver) {
      add(*history, solver, start);
      return true;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      r.profile["time"] = history->time, r.profile["momentum"] = history->momentum;
      r.profile["position"] = history->position, r.profile["velocity"] = history->velocity;
      r.profile["volume"] = history->volume;
      BodyIntegrals const now = integrals(*solver.bodies()[0]);
      r.facts["momentum"] = history->momentum.back(), r.facts["position"] = history->position.back();
      r.facts["velocity"] = history->velocity.back(), r.facts["volume_change"] = history->volume.back();
      r.facts["momentum_less_impulse"] = now.momentum[0] / history->momentum.back() - 1;
      r.facts["radius_in_cells"] = radius / h;
    };
    return run_problem("elastic-sphere-pulse", 30, std::move(problem), options);
  };
  return out;
}

}  // namespace g27
