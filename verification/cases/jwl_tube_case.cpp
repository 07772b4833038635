#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case jwl_tube_case() {
  return riemann_case({.name = "jwl-tube",
                       .title = "JWL tube of Shyue",
                       .source = "Shyue, J. Comput. Phys. 171 (2001) 678; units cm, us, Mbar",
                       .left = {1.7, 0.0, 10.0},
                       .right = {1.0, 0.0, 0.5},
                       .x_jump = 50.0,
                       .t_end = 12.0,
                       .x0 = 0.0,
                       .x1 = 100.0,
                       .eos = Jwl{8.545, 0.205, 4.6, 1.35, 0.25, 1.84},
                       .exact = JwlLaw{8.545, 0.205, 4.6, 1.35, 0.25, 1.84}});
}

}  // namespace g27
