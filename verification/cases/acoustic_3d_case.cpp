#include "verification/cases/oblique_wave.hpp"

namespace g27 {

Case acoustic_3d_case() { return acoustic_case("acoustic-3d", 3); }

}  // namespace g27
