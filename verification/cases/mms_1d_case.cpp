#include "verification/cases/manufactured_problem.hpp"

namespace g27 {

Case mms_1d_case() {
  return manufactured_case("mms-1d", "manufactured waves in all variables, driven by their source terms",
                           Symmetry::planar);
}

}  // namespace g27
