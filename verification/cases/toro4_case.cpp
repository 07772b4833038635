#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case toro4_case() {
  return riemann_case(
      {.name = "toro4",
       .title = "collision of two strong shocks",
       .source = "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., table 4.1, test 4",
       .left = {5.99924, 19.5975, 460.894},
       .right = {5.99242, -6.19633, 46.0950},
       .x_jump = 0.4,
       .t_end = 0.035});
}

}  // namespace g27
