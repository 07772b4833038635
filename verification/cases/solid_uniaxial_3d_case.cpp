#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_uniaxial_3d_case() {
  return solid_wave_case({.name = "solid-uniaxial-3d",
                          .title = "smooth plastic loading, uniaxial strain",
                          .dimensions = 3,
                          .amplitude = 0.01,
                          .loading = SolidWaveCase::Loading::uniaxial});
}

}  // namespace g27
