#include <cmath>
#include <numbers>

#include "verification/cases/oblique_wave.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{{"mach_x", 0.4, "1", "velocity along x over the sound speed"},
                                            {"mach_y", 0.15, "1", "velocity along y over the sound speed"},
                                            {"time", 1, "1", "end, in sound periods of the wave"}};

}  // namespace

Case entropy_2d_case() {
  return {.name = "entropy-2d",
          .title = "oblique density wave of 20 % (JWL 5 %, Mie-Grueneisen 1 %) in a flow across it and along it",
          .source = "exact: advection at constant u and p, for every equation of state",
          .dimensions = 2,
          .default_cells = 128,
          .eos = media(),
          .meshes = grid_meshes(),
          .parameters = parameters,
          .run = [](CaseOptions const& options) {
            Medium const m = medium(options.eos.value_or("ideal"));
            ObliqueBox const box = oblique_box(2);
            Vec3 const flow{value_of(parameters, options, "mach_x") * m.sound,
                            value_of(parameters, options, "mach_y") * m.sound, 0};
            double const across = flow[0] * box.normal[0] + flow[1] * box.normal[1], k = 2.0 * std::numbers::pi;
            GridProblem grid{
                .eos = m.eos, .upper = box.upper, .t_end = value_of(parameters, options, "time") / m.sound};
            make_periodic(grid);
            auto const at = [=](double t) {
              return mean_of(m.eos, 2, [=](Vec3 const& x) -> GasPoint {
                double const s = x[0] * box.normal[0] + x[1] * box.normal[1] - across * t;
                return {m.base.rho * (1.0 + m.density_swing * std::sin(k * s)), flow, m.base.p};
              });
            };
            grid.initial = at(0.0), grid.reference = at(grid.t_end);
            return run_problem("entropy-2d", 128, grid, options);
          }};
}

}  // namespace g27
