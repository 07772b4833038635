#include "verification/cases/solid_step.hpp"

namespace g27 {

Case solid_step_2d_case() { return solid_step_case("solid-step-2d", 2); }

}  // namespace g27
