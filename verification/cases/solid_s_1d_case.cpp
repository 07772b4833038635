#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_s_1d_case() {
  return solid_wave_case(
      {.name = "solid-s-1d", .title = "S wave of amplitude 1e-3 c over one period", .family = 1, .amplitude = 1e-3});
}

}  // namespace g27
