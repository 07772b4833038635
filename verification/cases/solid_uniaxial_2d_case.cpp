#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_uniaxial_2d_case() {
  return solid_wave_case({.name = "solid-uniaxial-2d",
                          .title = "smooth plastic loading, uniaxial strain",
                          .dimensions = 2,
                          .amplitude = 0.01,
                          .loading = SolidWaveCase::Loading::uniaxial});
}

}  // namespace g27
