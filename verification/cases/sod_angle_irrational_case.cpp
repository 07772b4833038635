#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case sod_angle_irrational_case() { return sod_oblique_case("sod-angle-irrational", irrational_tangent); }

}  // namespace g27
