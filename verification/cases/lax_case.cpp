#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case lax_case() {
  return riemann_case({.name = "lax",
                       .title = "Lax shock tube",
                       .source = "Lax, Comm. Pure Appl. Math. 7 (1954) 159",
                       .left = {0.445, 0.698, 3.528},
                       .right = {0.5, 0.0, 0.571},
                       .x_jump = 0.5,
                       .t_end = 0.14});
}

}  // namespace g27
