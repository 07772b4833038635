#include "verification/cases/blast_problem.hpp"

namespace g27 {

Case sedov_cylindrical_case() {
  return sedov_case("sedov-cylindrical", "Sedov's explosion, cylindrical", Symmetry::cylindrical);
}

}  // namespace g27
