#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case toro1_case() {
  return riemann_case(
      {.name = "toro1",
       .title = "modified Sod tube with a sonic rarefaction",
       .source = "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., table 4.1, test 1",
       .left = {1.0, 0.75, 1.0},
       .right = {0.125, 0.0, 0.1},
       .x_jump = 0.3,
       .t_end = 0.2});
}

}  // namespace g27
