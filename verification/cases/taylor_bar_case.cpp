/// A copper rod that strikes a rigid wall: a quarter of it, between two planes of symmetry and the wall, which is a
/// third one: it never lets go and has no friction.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/remesh.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{{"speed", 227, "m/s", "of the rod", 1, 400},
                                            {"end", 80e-6, "s", "time", 1e-7, 200e-6},
                                            {"closure", 0, "1", "1: momentum of the rod is kept exactly", 0, 1, true}};

constexpr double radius = 3.2e-3, rod = 32.4e-3;  ///< [m]

/// Largest distance from the axis of vertices up to `z` above the wall.
double reach(TriangleSurface const& s, double z) {
  double most = 0;
  for (Vec3 const& x : s.vertices) {
    if (x[2] <= z) most = std::max(most, std::hypot(x[0], x[1]));
  }
  return most;
}

}  // namespace

Case taylor_bar_case() {
  auto const run = [](CaseOptions const& options) {
    SolidMedium const copper = solid_medium("copper", true);
    double const speed = value_of(parameters, options, "speed"), ambient = 1e5;
    int const n = options.cells.value_or(3);
    double const h = radius / n;
    if (n < 3) throw std::invalid_argument("taylor-bar needs 3 cells along the radius or more");
    OversetProblem problem;
    // room for the foot, and around it
    Int3 const cells{static_cast<int>(std::ceil(3.25 * n)), static_cast<int>(std::ceil(3.25 * n)),
                     static_cast<int>(std::ceil(1.2 * rod / h))};
    problem.setup.gas = {.eos = IdealGas{1.4}, .lower = {0, 0, 0}, .upper = {}, .cells = cells};
    for (std::size_t a = 0; a < 3; ++a) {
      problem.setup.gas.upper[a] = cells[a] * h;
      problem.setup.gas.sides[2 * a].kind = GridBoundary::Kind::wall;
    }
    problem.gas = [=](Vec3 const&) { return GasPoint{1.2, {0, 0, 0}, ambient}; };
    problem.t_end = value_of(parameters, options, "end");
    problem.setup.closure = value_of(parameters, options, "closure") > 0;
    // of twice the length about the wall, of which the upper half is cut out
    BodySetup body{.surface = clip_at_origin(make_cylinder(radius, 2 * rod, h), 3, 0.3 * h),
                   .material = copper.scheme,
                   .cell = h,
                   .lower = {0, 0, 0},
                   .upper = {2.6 * radius, 2.6 * radius, rod + h},
                   .initial = [=](Vec3 const&) {
                     return solid_state(copper, copper.rho0 * (1 + ambient / copper.bulk), {0, 0, -speed}, ambient);
                   }};
    body.surface = remesh(body.surface, {.edge = 0.9 * h});
    problem.setup.bodies.push_back(std::move(body));
    auto const start = std::make_shared<BodyIntegrals>();
    auto const history = std::make_shared<std::map<std::string, std::vector<double>>>();
    problem.after_step = [=](OversetSolver const& solver) {
      Body const& b = *solver.bodies()[0];
      if (solver.counters().steps == 1) *start = integrals(b);
      (*history)["time"].push_back(solver.time());
      (*history)["length"].push_back(bounding_box(b.surface).upper[2] / rod);
      (*history)["foot"].push_back(reach(b.surface, 0) / radius);
      return std::fabs(enclosed(b).volume / start->volume - 1) < 0.3;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      Body const& b = *solver.bodies()[0];
      BodyIntegrals const now = integrals(b);
      r.profile = *history;
      r.facts["length"] = history->at("length").back(), r.facts["foot"] = history->at("foot").back();
      r.facts["widest"] = reach(b.surface, rod) / radius;
      r.facts["mass_change"] = now.mass / start->mass - 1, r.facts["volume_change"] = now.volume / start->volume - 1;
      r.facts["kinetic_left"] = now.kinetic / start->kinetic;
      double strain = 0;
      for (std::size_t i = 0; i < b.solid.kinds.count(); ++i) {
        if (b.solid.kinds.valid(i)) strain = std::max(strain, b.solid.states[i][solid_field_of::ep]);
      }
      r.facts["largest_plastic_strain"] = strain;
      auto const edges = edge_lengths(b.surface);
      auto const [shortest, longest] = std::minmax_element(edges.begin(), edges.end());
      r.facts["shortest_edge_in_cells"] = *shortest / h, r.facts["longest_edge_in_cells"] = *longest / h;
    };
    return run_problem("taylor-bar", 3, std::move(problem), options);
  };
  Case out = overset_case(
      "taylor-bar",
      "copper rod, 32.4 mm long, of radius 3.2 mm (--cells: its cells), strikes a rigid wall at 227 "
      "m/s: length and foot",
      "Foulk et al., Int. J. Numer. Meth. Eng. 122 (2021) 3845, sec. 4.4: no exact solution", 3, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
