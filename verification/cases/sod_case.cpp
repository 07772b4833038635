#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case sod_case() {
  return riemann_case({.name = "sod",
                       .title = "Sod shock tube",
                       .source = "Sod, J. Comput. Phys. 27 (1978) 1",
                       .left = {1.0, 0.0, 1.0},
                       .right = {0.125, 0.0, 0.1},
                       .x_jump = 0.5,
                       .t_end = 0.2});
}

}  // namespace g27
