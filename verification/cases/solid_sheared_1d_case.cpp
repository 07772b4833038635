#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_sheared_1d_case() {
  return solid_wave_case({.name = "solid-sheared-1d",
                          .title = "smooth plastic loading of sheared material, non-proportional",
                          .dimensions = 1,
                          .amplitude = 0.01,
                          .loading = SolidWaveCase::Loading::sheared});
}

}  // namespace g27
