/// What holds for every case in two and three dimensions: it runs, stays positive and conserves.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "scheme/grid/cell_place.hpp"
#include "tests/catch.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/grid_problem.hpp"

namespace {

using namespace g27;

CaseResult run(Case const& chosen, int cells, Predictor predictor) {
  CaseOptions options;
  options.cells = cells, options.predictor = predictor, options.fields = true;
  for (CaseParameter const& p : chosen.parameters) {
    if (p.name == "steps") options.values["steps"] = 50;
  }
  return chosen.run(options);
}

bool all_above(std::vector<float> const& values, float limit) {
  return std::all_of(values.begin(), values.end(), [=](float v) { return v > limit; });
}

}  // namespace

TEST_CASE("every case on a grid runs with every scheme, stays positive and conserves", "[cases][grid]") {
  int count = 0;
  for (Case const& c : all_cases()) {
    if (c.dimensions < 2 || c.solid || c.bodies) continue;
    ++count;
    for (Predictor const predictor : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
      // the step is 4 cells high where its tunnel is 60 long
      CaseResult const r = run(c, c.dimensions == 3 ? 12 : c.name == "forward-step" ? 60 : 24, predictor);
      INFO(c.name << " scheme " << r.scheme);
      CHECK(r.name == c.name);
      CHECK(r.dimensions == c.dimensions);
      CHECK(r.grid[2] > 0);
      CHECK((r.grid[2] == 1) == (c.dimensions == 2));
      CHECK(r.errors.empty() != c.has_reference);
      for (auto const& [variable, e] : r.errors) {
        INFO(variable);
        CHECK(std::isfinite(e.linf));
        CHECK(e.l1 <= e.linf);
      }
      for (auto const& [fact, value] : r.facts) {
        INFO(fact);
        CHECK(std::isfinite(value));
      }
      // a few thousand steps of round-off
      CHECK(std::fabs(r.ledger.mass.residual()) < 1e-13);
      CHECK(std::fabs(r.ledger.momentum.residual()) < 1e-13);
      CHECK(std::fabs(r.ledger.energy.residual()) < 1e-13);
      REQUIRE(r.fields.has_value());
      std::size_t const cells = cells_in(r.grid);
      CHECK(r.fields->density.size() == cells);
      CHECK(r.fields->cured.size() == cells);
      if (c.name != "forward-step") CHECK(all_above(r.fields->density, 0));
      if (c.name != "forward-step") CHECK(all_above(r.fields->pressure, 0));
    }
  }
  CHECK(count >= 24);
}

TEST_CASE("cells of a problem are cubic where the box allows", "[cases][grid]") {
  GridProblem problem{.dimensions = 3, .upper = {3, 1.5, 0.7}};
  CHECK(grid_cells(problem, 30) == Int3{30, 15, 7});
  problem.dimensions = 2;
  CHECK(grid_cells(problem, 31) == Int3{31, 16, 1});
  CHECK(grid_cells(problem, 6) == Int3{6, 4, 1});
}

// The parabolic scheme compresses contacts within bounds that hold at any angle: with the bounds of one direction
// oblique Shu-Osher waves overshoot by a third of the jump, without compression Sod's error is 0.85 of MUSCL-HLLC's.
TEST_CASE("oblique contacts are compressed and make no new extremum", "[cases][grid]") {
  auto const density = [](char const* name, int cells, Predictor predictor) {
    CaseOptions options;
    options.cells = cells, options.predictor = predictor;
    options.riemann = predictor == Predictor::muscl ? RiemannSolver::hllc : RiemannSolver::fast;
    for (Case const& c : all_cases()) {
      if (c.name == name) return c.run(options);
    }
    throw std::runtime_error("no such case");
  };
  double const parabolic = density("sod-angle-45", 128, Predictor::parabolic).errors.at("density").l1;
  double const muscl = density("sod-angle-45", 128, Predictor::muscl).errors.at("density").l1;
  CHECK(parabolic < 0.82 * muscl);
  CHECK(parabolic > 0.7 * muscl);
  CHECK(density("shu-osher-angle-45", 200, Predictor::parabolic).overshoot.at("density") < 1e-3);
}
