#include "verification/cases/quadrants.hpp"

namespace g27 {

Case lax_liu_12_case() {
  return quadrants_case(
      {.name = "lax-liu-12",
       .title = "two shocks and two contacts in two dimensions, configuration 12 of Lax and Liu",
       .states = {{{0.5313, {0, 0, 0}, 0.4}, {1, {0.7276, 0, 0}, 1}, {0.8, {0, 0, 0}, 1}, {1, {0, 0.7276, 0}, 1}}},
       .t_end = 0.25,
       .symmetric = true});
}

}  // namespace g27
