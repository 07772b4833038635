#include "verification/cases/blast_grid.hpp"

namespace g27 {

Case sedov_2d_case() { return sedov_grid_case("sedov-2d", 2); }

}  // namespace g27
