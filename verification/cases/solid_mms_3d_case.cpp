#include "verification/cases/solid_manufactured.hpp"

namespace g27 {

Case solid_mms_3d_case() { return solid_manufactured_case("solid-mms-3d", 3); }

}  // namespace g27
