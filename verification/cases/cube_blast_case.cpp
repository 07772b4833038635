/// A steel cube, or tetrahedron, of 1 cm beside a ball of gas at 10 GPa: thrown and crushed.
#include <algorithm>
#include <cmath>
#include <memory>

#include "fsi/surface/polygon_mesh.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"end", 4e-6, "s", "time", 1e-7, 60e-6},
    {"angle", 0, "rad", "by which the body is turned about (0.3, 0.5, 1)", 0, 3.2},
    {"closure", 0, "1", "1: momentum of the body is kept exactly", 0, 1, true},
    {"body", 0, "1", "0 cube, 1 tetrahedron of the same edge", 0, 1, true},
    {"elastic", 0, "1", "1: without yield stress", 0, 1, true},
    {"remeshing", 1, "1", "0: the surface keeps its triangles", 0, 1, true},
    literal_parameter()};

/// Along x [m].
double thickness(TriangleSurface const& surface) {
  auto const [low, high] = std::minmax_element(surface.vertices.begin(), surface.vertices.end(),
                                               [](Vec3 const& a, Vec3 const& b) { return a[0] < b[0]; });
  return (*high)[0] - (*low)[0];
}

}  // namespace

Case cube_blast_case() {
  auto const run = [](CaseOptions const& options) {
    bool const elastic = value_of(parameters, options, "elastic") > 0;
    SolidMedium const steel = solid_medium("steel", !elastic);
    // gas of gamma 3 stands for detonation products; its cells are 1.4 times the body's
    double const edge = 0.01, size = 0.042, ambient = 1e6;
    int const n = options.cells.value_or(24);
    double const h = size / n / 1.4;
    Vec3 const middle{0.022, 0.5 * size + 1.3e-4, 0.5 * size - 1.7e-4}, charge{0.007, 0.5 * size, 0.5 * size};
    OversetProblem problem;
    problem.setup.gas = gas_cube(IdealGas{3.0}, size, n);
    problem.gas = [=](Vec3 const& x) {
      return length(x - charge) < 0.009 ? GasPoint{1650, {0, 0, 0}, 1e10} : GasPoint{1.3, {0, 0, 0}, ambient};
    };
    problem.t_end = value_of(parameters, options, "end");
    problem.setup.closure = value_of(parameters, options, "closure") > 0;
    problem.setup.remeshing.on = value_of(parameters, options, "remeshing") > 0;
    problem.setup.literal = literal_reading(value_of(parameters, options, "literal"));
    bool const cube = value_of(parameters, options, "body") < 1;
    TriangleSurface const shape = cube ? make_box({edge, edge, edge}, h) : make_tetrahedron(edge, h);
    BodySetup body{.surface = placed(shape, {0.3, 0.5, 1}, value_of(parameters, options, "angle"), middle),
                   .material = steel.scheme,
                   .cell = h,
                   .initial = [=](Vec3 const&) {
                     return solid_state(steel, steel.rho0 * (1 + ambient / 175e9), {0, 0, 0}, ambient);
                   }};
    double const reach = 0.011;
    body.lower = middle - Vec3{reach, reach, reach}, body.upper = middle + Vec3{reach + 0.004, reach, reach};
    problem.setup.bodies.push_back(std::move(body));
    MassProperties const first = mass_properties(problem.setup.bodies[0].surface);
    double const thick = thickness(problem.setup.bodies[0].surface);
    auto const mass = std::make_shared<double>(0);
    problem.after_step = [=](OversetSolver const& solver) {
      if (solver.counters().steps == 1) *mass = integrals(*solver.bodies()[0]).mass;
      return std::fabs(mass_properties(solver.bodies()[0]->surface).volume / first.volume - 1) < 0.3;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      Body const& b = *solver.bodies()[0];
      BodyIntegrals const now = integrals(b);
      Vec3 const held = solver.momenta()[0].linear;
      r.facts["velocity"] = now.momentum[0] / now.mass, r.facts["velocity_by_impulse"] = held[0] / *mass;
      r.facts["momentum_less_impulse"] = now.momentum[0] / held[0] - 1;
      r.facts["mass_change"] = now.mass / *mass - 1;
      MassProperties const last = mass_properties(b.surface);
      r.facts["thickness"] = thickness(b.surface) / thick;
      r.facts["displacement"] = last.centroid[0] - first.centroid[0];
      double shortest = 1e300, longest = 0;
      for (std::size_t t = 0; t < b.surface.size(); ++t) {
        auto const c = b.surface.corners(t);
        for (std::size_t k = 0; k < 3; ++k) {
          double const e = length(c[(k + 1) % 3] - c[k]);
          shortest = std::min(shortest, e), longest = std::max(longest, e);
        }
      }
      r.facts["self_intersections"] = static_cast<double>(self_intersections(b.surface).size());
      r.facts["volume_change"] = last.volume / first.volume - 1;
      r.facts["shortest_edge_in_cells"] = shortest / h, r.facts["longest_edge_in_cells"] = longest / h;
      r.facts["cells_an_edge"] = edge / h;
    };
    return run_problem("cube-blast", 24, std::move(problem), options);
  };
  Case out =
      overset_case("cube-blast",
                   "steel cube or tetrahedron of 1 cm beside a ball of gas of 9 mm radius at 10 GPa: momentum against "
                   "impulse",
                   "momentum is the impulse of the pressures; no exact solution", 24, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
