#include <cmath>

#include "verification/cases/fine_grid.hpp"

namespace g27 {

Case shu_osher_case() {
  return {.name = "shu-osher",
          .title = "Mach 3 shock into a density wave",
          .source = "Shu and Osher, J. Comput. Phys. 83 (1989) 32, example 8",
          .default_cells = 400,
          .run = [](CaseOptions const& options) {
            LineProblem line{.eos = IdealGas{1.4}, .x0 = -5.0, .x1 = 5.0, .t_end = 1.8};
            auto const upstream = mean_of(line.eos, Symmetry::planar, [](double x) -> GasState<> {
              return {1.0 + 0.2 * std::sin(5.0 * x), 0.0, 1.0};
            });
            auto const shocked = mean_of(line.eos, Symmetry::planar, [](double) -> GasState<> {
              return {3.857143, 2.629369, 10.33333};
            });
            line.initial = [=](double a, double b) {
              double const s = std::fmin(std::fmax((-4.0 - a) / (b - a), 0.0), 1.0);
              if (s >= 1.0) return shocked(a, b);
              if (s <= 0.0) return upstream(a, b);
              GasConserved<> const l = shocked(a, -4.0), r = upstream(-4.0, b);
              return GasConserved<>{s * l.mass + (1 - s) * r.mass, s * l.momentum + (1 - s) * r.momentum,
                                    s * l.energy + (1 - s) * r.energy};
            };
            line.reference = fine_grid_reference("shu-osher", line, 12800);
            return run_problem("shu-osher", 400, line, options);
          }};
}

}  // namespace g27
