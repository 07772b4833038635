#include "verification/cases/wave.hpp"

namespace g27 {

// It would break at t = 1/(2 pi a G), G the fundamental derivative (1.2 ideal, 2 to 3 condensed): with a = 0.1 c it
// has travelled less than half of that way even in aluminium.
Case simple_wave_1d_case() {
  return wave_case("simple-wave-1d", "nonlinear simple wave of amplitude 0.1 c before it breaks", 0.1, 0.3);
}

}  // namespace g27
