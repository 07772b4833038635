#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_sheared_3d_case() {
  return solid_wave_case({.name = "solid-sheared-3d",
                          .title = "smooth plastic loading of sheared material, non-proportional",
                          .dimensions = 3,
                          .amplitude = 0.01,
                          .loading = SolidWaveCase::Loading::sheared});
}

}  // namespace g27
