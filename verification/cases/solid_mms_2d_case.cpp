#include "verification/cases/solid_manufactured.hpp"

namespace g27 {

Case solid_mms_2d_case() { return solid_manufactured_case("solid-mms-2d", 2); }

}  // namespace g27
