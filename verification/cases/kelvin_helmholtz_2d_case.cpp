#include <cmath>
#include <numbers>

#include "verification/cases/grid_probe.hpp"
#include "verification/cases/grid_problem.hpp"

namespace g27 {

namespace {

/// Smooth layers: density 1 and 2, velocity 0.5 and -0.5, both across 0.025 m (McNally, Lyra and Passy, eqs. 1-4).
GasPoint layers(Vec3 const& x) {
  double const width = 0.025;
  double const y = x[1] < 0.5 ? x[1] : 1 - x[1];  // mirrored in the middle
  double const edge = 0.25 - y;                   // > 0: in the light gas
  double const share = edge > 0 ? 1 - 0.5 * std::exp(-edge / width) : 0.5 * std::exp(edge / width);
  return {2 - share, {share - 0.5, 0.01 * std::sin(4 * std::numbers::pi * x[0]), 0}, 2.5};
}

/// Amplitude of the mode of the perturbation in the velocity across the layers (McNally, Lyra and Passy, eqs. 6-13).
double mode_amplitude(GasGrid const& grid, GridProbe const& v) {
  double const k = 4 * std::numbers::pi;
  double s = 0, c = 0, d = 0;
  for (int j = 0; j < grid.cells()[1]; ++j) {
    for (int i = 0; i < grid.cells()[0]; ++i) {
      Vec3 const x = grid.centre({i, j, 0});
      double const weight = std::exp(-k * std::fabs((x[1] < 0.5 ? x[1] : 1 - x[1]) - 0.25));
      s += weight * v.cell({i, j, 0}) * std::sin(k * x[0]);
      c += weight * v.cell({i, j, 0}) * std::cos(k * x[0]);
      d += weight;
    }
  }
  return 2 * std::hypot(s / d, c / d);
}

}  // namespace

Case kelvin_helmholtz_2d_case() {
  return {.name = "kelvin-helmholtz-2d",
          .title = "growth of a ripple on smooth shear layers, gamma = 5/3",
          .source = "McNally, Lyra and Passy, Astrophys. J. Suppl. 201 (2012) 18",
          .dimensions = 2,
          .default_cells = 128,
          .has_reference = false,
          .meshes = grid_meshes(),
          .run = [](CaseOptions const& options) {
            GridProblem grid{.eos = IdealGas{5.0 / 3}, .t_end = 1.5};
            make_periodic(grid);
            grid.initial = mean_of(grid.eos, 2, layers);
            grid.measure = [](GasGrid const& done, CaseResult& r) {
              GridProbe const v(done, GasGrid::Field::velocity_y), rho(done, GasGrid::Field::density);
              r.facts["mode_amplitude"] = mode_amplitude(done, v);
              r.facts["density_least"] = rho.least(), r.facts["density_most"] = rho.most();
              double kinetic = 0;
              for (int j = 0; j < done.cells()[1]; ++j) {
                for (int i = 0; i < done.cells()[0]; ++i)
                  kinetic = std::fmax(kinetic, 0.5 * rho.cell({i, j, 0}) * std::pow(v.cell({i, j, 0}), 2));
              }
              r.facts["kinetic_energy_across_most"] = kinetic;
            };
            return run_problem("kelvin-helmholtz-2d", 128, grid, options);
          }};
}

}  // namespace g27
