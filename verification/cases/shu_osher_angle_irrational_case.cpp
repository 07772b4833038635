#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case shu_osher_angle_irrational_case() {
  return shu_osher_oblique_case("shu-osher-angle-irrational", irrational_tangent);
}

}  // namespace g27
