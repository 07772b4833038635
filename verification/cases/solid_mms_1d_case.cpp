#include "verification/cases/solid_manufactured.hpp"

namespace g27 {

Case solid_mms_1d_case() { return solid_manufactured_case("solid-mms-1d", 1); }

}  // namespace g27
