#include "verification/cases/detonation_problem.hpp"

namespace g27 {

Case detonation_spherical_case() { return detonation_line_case("detonation-spherical"); }

}  // namespace g27
