#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case toro2_case() {
  return riemann_case(
      {.name = "toro2",
       .title = "123 problem: two rarefactions, near vacuum",
       .source = "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., table 4.1, test 2",
       .left = {1.0, -2.0, 0.4},
       .right = {1.0, 2.0, 0.4},
       .x_jump = 0.5,
       .t_end = 0.15});
}

}  // namespace g27
