#include "verification/cases/quadrants.hpp"

namespace g27 {

Case lax_liu_3_case() {
  return quadrants_case({.name = "lax-liu-3",
                         .title = "four shocks in two dimensions, configuration 3 of Lax and Liu",
                         .states = {{{1.5, {0, 0, 0}, 1.5},
                                     {0.5323, {1.206, 0, 0}, 0.3},
                                     {0.138, {1.206, 1.206, 0}, 0.029},
                                     {0.5323, {0, 1.206, 0}, 0.3}}},
                         .t_end = 0.3,
                         .symmetric = true});
}

}  // namespace g27
