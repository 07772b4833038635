#include "verification/cases/blast_grid.hpp"

namespace g27 {

Case noh_2d_case() { return noh_grid_case("noh-2d", 2); }

}  // namespace g27
