#include "verification/cases/manufactured_grid.hpp"

namespace g27 {

Case mms_3d_case() { return manufactured_grid_case("mms-3d", 3); }

}  // namespace g27
