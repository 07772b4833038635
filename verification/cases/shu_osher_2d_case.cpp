#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case shu_osher_2d_case() { return shu_osher_aligned_case("shu-osher-2d"); }

}  // namespace g27
