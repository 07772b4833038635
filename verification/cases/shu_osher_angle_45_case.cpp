#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case shu_osher_angle_45_case() { return shu_osher_oblique_case("shu-osher-angle-45", 1.0); }

}  // namespace g27
