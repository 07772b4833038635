#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_p_1d_case() {
  return solid_wave_case(
      {.name = "solid-p-1d", .title = "P wave of amplitude 1e-3 c over one period", .amplitude = 1e-3});
}

}  // namespace g27
