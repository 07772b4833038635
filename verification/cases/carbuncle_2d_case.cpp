#include "verification/cases/carbuncle.hpp"

namespace g27 {

Case carbuncle_2d_case() { return carbuncle_case("carbuncle-2d", 2); }

}  // namespace g27
