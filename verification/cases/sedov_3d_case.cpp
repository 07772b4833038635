#include "verification/cases/blast_grid.hpp"

namespace g27 {

Case sedov_3d_case() { return sedov_grid_case("sedov-3d", 3); }

}  // namespace g27
