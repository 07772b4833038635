#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case contact_case() {
  return riemann_case({.name = "contact",
                       .title = "moving contact",
                       .source = "density jump 10:1 carried at u = 0.5",
                       .left = {1.0, 0.5, 1.0},
                       .right = {0.1, 0.5, 1.0},
                       .x_jump = 0.3,
                       .t_end = 0.8});
}

}  // namespace g27
