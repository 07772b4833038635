#include "verification/cases/blast_problem.hpp"

namespace g27 {

Case noh_spherical_case() { return noh_case("noh-spherical", "Noh's implosion, spherical", Symmetry::spherical); }

}  // namespace g27
