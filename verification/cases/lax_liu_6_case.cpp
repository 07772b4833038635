#include "verification/cases/quadrants.hpp"

namespace g27 {

Case lax_liu_6_case() {
  return quadrants_case(
      {.name = "lax-liu-6",
       .title = "four contacts in two dimensions, configuration 6 of Lax and Liu",
       .states = {{{1, {0.75, -0.5, 0}, 1}, {2, {0.75, 0.5, 0}, 1}, {1, {-0.75, 0.5, 0}, 1}, {3, {-0.75, -0.5, 0}, 1}}},
       .t_end = 0.3});
}

}  // namespace g27
