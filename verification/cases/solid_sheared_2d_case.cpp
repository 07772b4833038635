#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_sheared_2d_case() {
  return solid_wave_case({.name = "solid-sheared-2d",
                          .title = "smooth plastic loading of sheared material, non-proportional",
                          .dimensions = 2,
                          .amplitude = 0.01,
                          .loading = SolidWaveCase::Loading::sheared});
}

}  // namespace g27
