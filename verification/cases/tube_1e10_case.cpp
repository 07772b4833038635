#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case tube_1e10_case() {
  return riemann_case({.name = "tube-1e10",
                       .title = "tube with a pressure ratio of 1e10",
                       .source = "strength test",
                       .left = {1.0, 0.0, 1e10},
                       .right = {1.0, 0.0, 1.0},
                       .x_jump = 0.5,
                       .t_end = 3e-6});
}

}  // namespace g27
