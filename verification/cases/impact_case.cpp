#include "verification/cases/riemann_problem.hpp"

namespace g27 {

Case impact_case() {
  return riemann_case({.name = "impact",
                       .title = "aluminium at 2 km/s against aluminium at rest",
                       .source = "symmetric impact on the Hugoniot of Meyers (1994), table 5.1",
                       .left = {2785.0, 2000.0, 1e8},
                       .right = {2785.0, 0.0, 1e8},
                       .x_jump = 0.5,
                       .t_end = 6e-5,
                       .eos = MieGruneisen{2785.0, 5328.0, 1.338, 2.0},
                       .exact = MieGruneisenLaw{2785.0, 5328.0, 1.338, 2.0}});
}

}  // namespace g27
