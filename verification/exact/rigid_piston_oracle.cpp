#include <cmath>

#include "verification/exact/arguments.hpp"
#include "verification/exact/rigid_piston.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  std::vector<double> const t = numbers(arguments, "t");
  double last = 0;
  for (double const time : t) {
    if (!(time >= 0)) throw OracleError{"t", "is negative", "give times of 0 or more"};
    last = std::max(last, time);
  }
  double const gamma = number(arguments, "gamma"), ahead = number(arguments, "p_ahead");
  if (!(gamma > 1)) throw OracleError{"gamma", "is not above 1", "give a number above 1"};
  if (!(ahead >= 0)) throw OracleError{"p_ahead", "is negative", "give 0, a vacuum, or more"};
  RigidPiston::Setup const setup{.behind = {gamma, positive_number(arguments, "rho"), positive_number(arguments, "p")},
                                 .ahead = {gamma, positive_number(arguments, "rho_ahead"), ahead},
                                 .mass_per_area = positive_number(arguments, "mass_per_area"),
                                 .t_end = last > 0 ? last : 1};
  if (!(setup.behind.p > ahead)) throw OracleError{"p", "is not above p_ahead", "give a higher pressure behind"};
  RigidPiston const piston(setup);
  if (last > piston.breaking_time())
    throw OracleError{"t", "the wave ahead breaks at " + std::to_string(piston.breaking_time()), "give less than that"};
  std::vector<double> x, u, behind, before;
  for (double const time : t) {
    x.push_back(piston.position(time)), u.push_back(piston.velocity(time));
    behind.push_back(piston.pressure_behind(time)), before.push_back(piston.pressure_ahead(time));
  }
  return {{"breaking_time", piston.breaking_time()}, {"t", t}, {"x", x}, {"u", u}, {"p", behind}, {"p_ahead", before}};
}

}  // namespace

Oracle rigid_piston_oracle() {
  return {.name = "rigid-piston",
          .summary = "rigid piston of finite mass that ideal gas drives into another, or into a vacuum",
          .source = "Courant and Friedrichs, Supersonic Flow and Shock Waves (1948), sections 40 and 42",
          .parameters = {{"gamma", "1.4", "1", "ratio of specific heats of both gases"},
                         {"rho", "1.4", "kg/m^3", "density behind the piston"},
                         {"p", "1", "Pa", "pressure behind it"},
                         {"rho_ahead", "0.7", "kg/m^3", "density ahead of it"},
                         {"p_ahead", "0.5", "Pa", "pressure ahead of it; 0: a vacuum"},
                         {"mass_per_area", "1", "kg/m^2", "of the piston"},
                         {"t", "0:1:11", "s", "times: a number, a list 0,0.5,1 or a range 0:1:101"}},
          .evaluate = solve};
}

}  // namespace g27
