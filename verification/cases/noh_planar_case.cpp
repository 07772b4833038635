#include "verification/cases/blast_problem.hpp"

namespace g27 {

Case noh_planar_case() { return noh_case("noh-planar", "Noh's implosion, planar", Symmetry::planar); }

}  // namespace g27
