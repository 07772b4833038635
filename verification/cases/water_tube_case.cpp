#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case water_tube_case() {
  return riemann_case({.name = "water-tube",
                       .title = "water tube: stiffened gas, 1 GPa against 1 bar",
                       .source = "after Saurel and Abgrall, J. Comput. Phys. 150 (1999) 425",
                       .left = {1000.0, 0.0, 1e9},
                       .right = {1000.0, 0.0, 1e5},
                       .x_jump = 0.5,
                       .t_end = 1.5e-4,
                       .eos = StiffenedGas{4.4, 6e8},
                       .exact = StiffenedLaw{4.4, 6e8}});
}

}  // namespace g27
