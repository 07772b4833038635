#include "verification/cases/manufactured_problem.hpp"

namespace g27 {

Case mms_spherical_case() {
  return manufactured_case("mms-spherical", "manufactured waves in spherical symmetry", Symmetry::spherical);
}

}  // namespace g27
