#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case slow_shock_case() {
  return riemann_case({.name = "slow-shock",
                       .title = "Mach 3 shock that hardly moves over the grid",
                       .source = "after Quirk, Int. J. Numer. Meth. Fluids 18 (1994) 555",
                       .left = {3.86, -0.81, 10.33},
                       .right = {1.0, -3.44, 1.0},
                       .x_jump = 0.5,
                       .t_end = 1.0});
}

}  // namespace g27
