#include "verification/cases/solid_wave.hpp"

namespace g27 {

Case solid_coupled_3d_case() {
  return solid_wave_case({.name = "solid-coupled-3d",
                          .title = "wave of finite amplitude, P and S coupled by pre-stress, over one period",
                          .dimensions = 3,
                          .family = 1,
                          .amplitude = 0.02,
                          .stress = 0.05});
}

}  // namespace g27
