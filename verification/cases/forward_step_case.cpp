#include "verification/cases/grid_probe.hpp"
#include "verification/cases/grid_problem.hpp"

namespace g27 {

Case forward_step_case() {
  return {.name = "forward-step",
          .title = "Mach 3 wind tunnel with a step",
          .source = "Woodward and Colella, J. Comput. Phys. 54 (1984) 115, section IV.B",
          .dimensions = 2,
          .default_cells = 240,
          .has_reference = false,
          .meshes = grid_meshes(),
          .run = [](CaseOptions const& options) {
            GridProblem grid{.eos = IdealGas{1.4}, .upper = {3, 1, 1}, .t_end = 4.0};
            GasPoint const inflow{1.4, {3, 0, 0}, 1};
            grid.sides = {inflow_side([=](Vec3 const&, double) { return inflow; }),
                          outflow_side,
                          wall_side,
                          wall_side,
                          periodic_side,
                          periodic_side};
            grid.blocks = {{{0.6, 0, 0}, {3, 0.2, 1}}};
            grid.initial = [q = densities_of(grid.eos, inflow)](Vec3 const&, Vec3 const&) { return q; };
            grid.measure = [](GasGrid const& done, CaseResult& r) {
              GridProbe const p(done, GasGrid::Field::pressure), rho(done, GasGrid::Field::density);
              r.facts["density_most"] = rho.most(), r.facts["pressure_most"] = p.most();
              // where the bow shock meets the floor and the roof
              auto const shock = [&](double y) { return 0.6 - p.front({0.6, y, 0}, {-1, 0, 0}, 0.6, 5.0); };
              r.facts["bow_shock_floor"] = shock(0.0);
              r.facts["mach_stem_roof"] = 3.0 - p.front({3, 1, 0}, {-1, 0, 0}, 3.0, 5.0);
            };
            return run_problem("forward-step", 240, grid, options);
          }};
}

}  // namespace g27
