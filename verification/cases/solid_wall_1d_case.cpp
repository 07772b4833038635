#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_wall_1d_case() {
  return solid_wave_case({.name = "solid-wall-1d",
                          .title = "P wave driven by its normal velocity at both ends",
                          .amplitude = 1e-7,
                          .stress = 0,
                          .sides = SolidWaveCase::Sides::wall});
}

}  // namespace g27
