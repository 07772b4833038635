#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case leblanc_case() {
  return riemann_case({.name = "leblanc",
                       .title = "LeBlanc tube: density ratio 1e3, energy ratio 1e6",
                       .source = "Loubere and Shashkov, J. Comput. Phys. 209 (2005) 105",
                       .left = {1.0, 0.0, 0.2 / 3.0},
                       .right = {1e-3, 0.0, 2e-10 / 3.0},
                       .x_jump = 3.0,
                       .t_end = 6.0,
                       .x0 = 0.0,
                       .x1 = 9.0,
                       .eos = IdealGas{5.0 / 3.0},
                       .exact = IdealLaw{5.0 / 3.0}});
}

}  // namespace g27
