#include "verification/cases/wave.hpp"

namespace g27 {

// The amplitude keeps round-off (1e-16 of the state) below the error of the finest grids in use.
Case acoustic_1d_case() {
  return wave_case("acoustic-1d", "sound wave of amplitude 1e-5 c over one period", 1e-5, 1.0);
}

}  // namespace g27
