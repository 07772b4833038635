#include "verification/cases/detonation_problem.hpp"

namespace g27 {

Case detonation_3d_case() { return detonation_grid_case("detonation-3d"); }

}  // namespace g27
