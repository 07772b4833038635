/// A steel body that spins in thin gas: its angular momentum stays.
#include <cmath>
#include <memory>
#include <numbers>

#include "fsi/overset/body_integrals.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"body", 0, "1", "0 cube, 1 sphere, 2 tetrahedron", 0, 2, true},
    {"turns", 0.25, "1", "revolutions", 1e-3, 10},
    {"mach", 0.05, "1", "speed of a cube's edge over that of P waves", 1e-3, 0.3},
    literal_parameter()};

}  // namespace

Case body_spin_case() {
  auto const run = [](CaseOptions const& options) {
    SolidMedium const steel = solid_medium("steel");
    double const K = 175e9, p = 1e-5 * K, size = 1, edge = 0.4;
    int const n = options.cells.value_or(20),
              body = static_cast<int>(std::lround(value_of(parameters, options, "body")));
    double const h = size / n, rate = value_of(parameters, options, "mach") * steel.sound / (0.5 * edge);
    double const end = value_of(parameters, options, "turns") * 2 * std::numbers::pi / rate;
    Vec3 const middle{0.503, 0.507, 0.493}, axis = (1 / length(Vec3{0.3, 0.5, 1})) * Vec3{0.3, 0.5, 1};
    TriangleSurface const shape = body == 1   ? make_sphere(0.5 * edge, h)
                                  : body == 2 ? make_tetrahedron(1.5 * edge, h)
                                              : make_box({edge, edge, edge}, h);
    OversetProblem problem;
    problem.setup.gas = gas_cube(IdealGas{1.4}, size, n);
    problem.gas = [=](Vec3 const&) { return GasPoint{1e-5 * steel.rho0, {0, 0, 0}, p}; };
    problem.t_end = end;
    problem.setup.literal = literal_reading(value_of(parameters, options, "literal"));
    BodySetup b{.surface = placed(shape, {1, 2, -1}, 0.4, middle), .material = steel.scheme, .cell = h, .initial = {}};
    double reach = 0;
    for (Vec3 const& x : b.surface.vertices) reach = std::max(reach, length(x - middle));
    b.lower = middle - Vec3{reach, reach, reach}, b.upper = middle + Vec3{reach, reach, reach};
    b.initial = [=](Vec3 const& x) {
      return solid_state(steel, steel.rho0 * (1 + p / K), rate * cross(axis, x - middle), p);
    };
    problem.setup.bodies.push_back(std::move(b));
    auto const start = std::make_shared<BodyIntegrals>();
    problem.after_step = [=](OversetSolver const& solver) {
      if (solver.counters().steps == 1) *start = integrals(*solver.bodies()[0]);
      return std::fabs(mass_properties(solver.bodies()[0]->surface).volume / start->volume - 1) < 0.2;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      BodyIntegrals const now = integrals(*solver.bodies()[0]);
      r.facts["angular_momentum"] = dot(now.angular, axis) / dot(start->angular, axis);
      r.facts["mass_change"] = now.mass / start->mass - 1, r.facts["volume_change"] = now.volume / start->volume - 1;
      r.facts["turns_done"] = solver.time() * rate / (2 * std::numbers::pi);
    };
    return run_problem("body-spin", 20, std::move(problem), options);
  };
  Case out = overset_case("body-spin", "steel body that spins in thin gas: angular momentum over that at the start",
                          "angular momentum is kept", 20, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
