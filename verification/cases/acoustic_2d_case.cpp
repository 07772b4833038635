#include "verification/cases/oblique_wave.hpp"

namespace g27 {

Case acoustic_2d_case() { return acoustic_case("acoustic-2d", 2); }

}  // namespace g27
