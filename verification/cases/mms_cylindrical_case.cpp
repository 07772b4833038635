#include "verification/cases/manufactured_problem.hpp"

namespace g27 {

Case mms_cylindrical_case() {
  return manufactured_case("mms-cylindrical", "manufactured waves in cylindrical symmetry", Symmetry::cylindrical);
}

}  // namespace g27
