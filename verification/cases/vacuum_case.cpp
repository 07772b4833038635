#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case vacuum_case() {
  return riemann_case({.name = "vacuum",
                       .title = "two rarefactions that leave a vacuum",
                       .source = "123 problem at twice its speed",
                       .left = {1.0, -4.0, 0.4},
                       .right = {1.0, 4.0, 0.4},
                       .x_jump = 0.5,
                       .t_end = 0.08});
}

}  // namespace g27
