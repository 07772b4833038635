#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_traction_1d_case() {
  return solid_wave_case({.name = "solid-traction-1d",
                          .title = "coupled wave driven by its stresses at both ends",
                          .family = 1,
                          .amplitude = 1e-7,
                          .stress = 0.05,
                          .sides = SolidWaveCase::Sides::traction});
}

}  // namespace g27
