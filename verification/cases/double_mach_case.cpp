#include <cmath>

#include "verification/cases/grid_probe.hpp"
#include "verification/cases/grid_problem.hpp"

namespace g27 {

Case double_mach_case() {
  return {.name = "double-mach",
          .title = "double Mach reflection: a shock of Mach 10 meets a wall at 60 degrees",
          .source = "Woodward and Colella, J. Comput. Phys. 54 (1984) 115, section IV.C",
          .dimensions = 2,
          .default_cells = 480,
          .has_reference = false,
          .meshes = grid_meshes(),
          .run = [](CaseOptions const& options) {
            GridProblem grid{.eos = IdealGas{1.4}, .upper = {4, 1, 1}, .t_end = 0.2};
            // ahead of the shock c = 1; the wall begins at x = 1/6
            GasPoint const shocked{8.0, {8.25 * std::sqrt(0.75), -8.25 * 0.5, 0}, 116.5}, ahead{1.4, {0, 0, 0}, 1.0};
            Vec3 const normal{std::sqrt(0.75), -0.5, 0};
            double const start = 1.0 / 6, shock = normal[0] * start;
            auto const state = [=](Vec3 const& x, double t) {
              return normal[0] * x[0] + normal[1] * x[1] < shock + 10.0 * t ? shocked : ahead;
            };
            grid.sides = {inflow_side(state), outflow_side,  wall_side,
                          inflow_side(state), periodic_side, periodic_side};
            grid.patches = {{.side = Side::y_low, .upper = {start, 1e300, 1e300}, .condition = inflow_side(state)}};
            grid.initial =
                half_space_mean(2, normal, shock, densities_of(grid.eos, shocked), densities_of(grid.eos, ahead));
            grid.measure = [](GasGrid const& done, CaseResult& r) {
              GridProbe const p(done, GasGrid::Field::pressure), rho(done, GasGrid::Field::density);
              r.facts["density_most"] = rho.most(), r.facts["pressure_most"] = p.most();
              // the shock that arrived would stand at 1/6 + 20 t/sqrt 3 = 2.476 on the wall
              r.facts["mach_stem_foot"] = p.front({0, 0, 0}, {1, 0, 0}, 4.0, 50.0);
            };
            return run_problem("double-mach", 480, grid, options);
          }};
}

}  // namespace g27
