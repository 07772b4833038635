#include "verification/cases/shu_osher.hpp"

namespace g27 {

Case shu_osher_case() {
  return {.name = "shu-osher",
          .title = "Mach 3 shock into a density wave",
          .source = "Shu and Osher, J. Comput. Phys. 83 (1989) 32, example 8",
          .default_cells = 400,
          .run = [](CaseOptions const& options) {
            LineProblem line = shu_osher_problem();
            line.reference = shu_osher_reference();
            return run_problem("shu-osher", 400, line, options);
          }};
}

}  // namespace g27
