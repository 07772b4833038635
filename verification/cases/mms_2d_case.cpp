#include "verification/cases/manufactured_grid.hpp"

namespace g27 {

Case mms_2d_case() { return manufactured_grid_case("mms-2d", 2); }

}  // namespace g27
