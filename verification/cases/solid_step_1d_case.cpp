#include "verification/cases/solid_step.hpp"

namespace g27 {

Case solid_step_1d_case() { return solid_step_case("solid-step-1d", 1); }

}  // namespace g27
