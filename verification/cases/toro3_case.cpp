#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case toro3_case() {
  return riemann_case(
      {.name = "toro3",
       .title = "left half of the blast wave problem, pressure ratio 1e5",
       .source = "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., table 4.1, test 3",
       .left = {1.0, 0.0, 1000.0},
       .right = {1.0, 0.0, 0.01},
       .x_jump = 0.5,
       .t_end = 0.012});
}

}  // namespace g27
