#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case toro5_case() {
  return riemann_case(
      {.name = "toro5",
       .title = "strong shock with a stationary contact",
       .source = "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., table 4.1, test 5",
       .left = {1.0, -19.59745, 1000.0},
       .right = {1.0, -19.59745, 0.01},
       .x_jump = 0.8,
       .t_end = 0.012});
}

}  // namespace g27
