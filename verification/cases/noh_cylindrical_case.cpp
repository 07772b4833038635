#include "verification/cases/blast_problem.hpp"

namespace g27 {

Case noh_cylindrical_case() {
  return noh_case("noh-cylindrical", "Noh's implosion, cylindrical", Symmetry::cylindrical);
}

}  // namespace g27
