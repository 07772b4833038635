#include "verification/cases/oblique_tube.hpp"

namespace g27 {

Case sod_2d_case() { return sod_aligned_case("sod-2d"); }

}  // namespace g27
