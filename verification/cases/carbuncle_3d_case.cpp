#include "verification/cases/carbuncle.hpp"

namespace g27 {

Case carbuncle_3d_case() { return carbuncle_case("carbuncle-3d", 3); }

}  // namespace g27
