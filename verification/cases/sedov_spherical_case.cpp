#include "verification/cases/blast_problem.hpp"

namespace g27 {

Case sedov_spherical_case() {
  return sedov_case("sedov-spherical", "Sedov's explosion, spherical", Symmetry::spherical);
}

}  // namespace g27
