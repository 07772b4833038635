#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case sod_angle_45_case() { return sod_diagonal_case("sod-angle-45"); }

}  // namespace g27
