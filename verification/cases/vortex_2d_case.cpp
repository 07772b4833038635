#include <cmath>

#include "verification/cases/grid_problem.hpp"
#include "verification/exact/vortex.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{{"time", 8, "s", "end"}};

}  // namespace

// The box is 16 radii wide: at its sides the vortex turns at 0.5 c 8 exp(-31.5) = 8e-14 c, so that its periodic images
// do not show.
Case vortex_2d_case() {
  return {.name = "vortex-2d",
          .title = "isentropic vortex of 0.5 c carried along the diagonal at 0.5 c for 8 s",
          .source = "Yee, Sandham and Djomehri, J. Comput. Phys. 150 (1999) 199",
          .dimensions = 2,
          .default_cells = 128,
          .meshes = grid_meshes(true),
          .parameters = parameters,
          .run = [](CaseOptions const& options) {
            double const flow = options.mesh.value_or("fixed") == "frame" ? 0.0 : 0.5, half = 8;
            Vortex const vortex{
                .u0 = flow, .v0 = flow, .x0 = -0.5 * half * (flow > 0), .y0 = -0.25 * half * (flow > 0)};
            AnyEos const eos = IdealGas{vortex.gamma};
            GridProblem grid{.eos = eos,
                             .lower = {-half, -half, 0},
                             .upper = {half, half, 1},
                             .t_end = value_of(parameters, options, "time")};
            make_periodic(grid);
            auto const at = [=](double t) {
              return mean_of(eos, 2, [=](Vec3 const& x) -> GasPoint {
                // the nearest of the periodic images
                double const cx = vortex.x0 + flow * t, cy = vortex.y0 + flow * t;
                PlaneState const s =
                    vortex.at(cx + std::remainder(x[0] - cx, 2 * half), cy + std::remainder(x[1] - cy, 2 * half), t);
                return {s.rho, {s.u, s.v, 0}, s.p};
              });
            };
            grid.initial = at(0.0), grid.reference = at(grid.t_end);
            return run_problem("vortex-2d", 128, grid, options);
          }};
}

}  // namespace g27
