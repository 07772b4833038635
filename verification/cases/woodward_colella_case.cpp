#include <cmath>

#include "verification/cases/fine_grid.hpp"

namespace g27 {

Case woodward_colella_case() {
  return {.name = "woodward-colella",
          .title = "two interacting blast waves between walls",
          .source = "Woodward and Colella, J. Comput. Phys. 54 (1984) 115, IV.a",
          .default_cells = 400,
          .run = [](CaseOptions const& options) {
            LineProblem line{.eos = IdealGas{1.4}, .t_end = 0.038};
            line.left.kind = line.right.kind = GasBoundary::Kind::wall;
            // mean over a cell of a piecewise constant pressure: energies add
            line.initial = [](double a, double b) {
              double const inner = std::fmax(0.0, std::fmin(b, 0.9) - std::fmax(a, 0.1));
              double const left = std::fmax(0.0, std::fmin(b, 0.1) - a), right = std::fmax(0.0, b - std::fmax(a, 0.9));
              return GasConserved<>{1.0, 0.0, (1000.0 * left + 0.01 * inner + 100.0 * right) / (0.4 * (b - a))};
            };
            line.reference = fine_grid_reference("woodward-colella", line, 12800);
            return run_problem("woodward-colella", 400, line, options);
          }};
}

}  // namespace g27
