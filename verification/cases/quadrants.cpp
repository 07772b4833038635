#include "verification/cases/quadrants.hpp"

#include <algorithm>
#include <cmath>

#include "verification/cases/grid_probe.hpp"

namespace g27 {

namespace {

/// Largest |rho(x, y) - rho(y, x)| over the largest density.
double asymmetry(GridProbe const& rho, Int3 const& cells) {
  double most = 0;
  for (int j = 0; j < cells[1]; ++j) {
    for (int i = 0; i < j; ++i) most = std::max(most, std::fabs(rho.cell({i, j, 0}) - rho.cell({j, i, 0})));
  }
  return most / rho.most();
}

}  // namespace

Case quadrants_case(Quadrants const& problem) {
  auto const run = [=](CaseOptions const& options) {
    GridProblem grid{.eos = IdealGas{1.4}, .t_end = problem.t_end};
    std::array<GasDensities, 4> q;
    for (std::size_t k = 0; k < 4; ++k) q[k] = densities_of(grid.eos, problem.states[k]);
    grid.initial = [=](Vec3 const& x, Vec3 const& h) {
      auto const above = [&](std::size_t d) { return std::clamp((x[d] - 0.5) / h[d] + 0.5, 0.0, 1.0); };
      double const r = above(0), t = above(1);
      std::array<double, 4> const share{r * t, (1 - r) * t, (1 - r) * (1 - t), r * (1 - t)};
      GasDensities sum{};
      for (std::size_t k = 0; k < 4; ++k) {
        sum.mass += share[k] * q[k].mass, sum.energy += share[k] * q[k].energy;
        for (std::size_t d = 0; d < 3; ++d) sum.momentum[d] += share[k] * q[k].momentum[d];
      }
      return sum;
    };
    grid.measure = [=](GasGrid const& done, CaseResult& r) {
      GridProbe const rho(done, GasGrid::Field::density);
      r.facts["density_least"] = rho.least(), r.facts["density_most"] = rho.most();
      if (problem.symmetric) r.facts["asymmetry"] = asymmetry(rho, done.cells());
    };
    return run_problem(problem.name, 200, grid, options);
  };
  return {.name = problem.name,
          .title = problem.title,
          .source = "Lax and Liu, SIAM J. Sci. Comput. 19 (1998) 319",
          .dimensions = 2,
          .default_cells = 200,
          .has_reference = false,
          .meshes = grid_meshes(),
          .run = run};
}

}  // namespace g27
