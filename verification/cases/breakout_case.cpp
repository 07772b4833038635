#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case breakout_case() {
  return riemann_case({.name = "breakout",
                       .title = "detonation products of TNT-RDX at the CJ point against air in the same law",
                       .source = "OG; CJ state of the paper's JWL set at 1650 kg/m3",
                       .left = {2198.643, 1893.214, 23.7e9},
                       .right = {1.2, 0.0, 1e5},
                       .x_jump = 0.3,
                       .t_end = 6e-5,
                       .eos = Jwl{708.6056e9, 13.16457e9, 4.94, 1.35, 0.28, 1650.0},
                       .exact = JwlLaw{708.6056e9, 13.16457e9, 4.94, 1.35, 0.28, 1650.0}});
}

}  // namespace g27
