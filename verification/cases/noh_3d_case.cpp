#include "verification/cases/blast_grid.hpp"

namespace g27 {

Case noh_3d_case() { return noh_grid_case("noh-3d", 3); }

}  // namespace g27
