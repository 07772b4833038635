#include "verification/exact/vortex.hpp"

#include <cmath>

#include "verification/exact/arguments.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  Vortex const vortex{.gamma = positive_number(arguments, "gamma"),
                      .rho0 = positive_number(arguments, "rho"),
                      .p0 = positive_number(arguments, "p"),
                      .u0 = number(arguments, "u"),
                      .v0 = number(arguments, "v"),
                      .radius = positive_number(arguments, "radius"),
                      .strength = number(arguments, "strength")};
  if (!(vortex.gamma > 1)) throw OracleError{"gamma", "is " + arguments.at("gamma"), "give a number above 1"};
  double const t = number(arguments, "t"), y = number(arguments, "y");
  PlaneState const centre = vortex.at(vortex.u0 * t, vortex.v0 * t, t);
  if (!(centre.p > 0)) throw OracleError{"strength", "opens a vacuum in the centre", "give less"};
  std::vector<double> const x = numbers(arguments, "x");
  std::vector<double> rho, u, v, p;
  for (double const position : x) {
    PlaneState const s = vortex.at(position, y, t);
    rho.push_back(s.rho);
    u.push_back(s.u);
    v.push_back(s.v);
    p.push_back(s.p);
  }
  return {{"rho_centre", centre.rho}, {"p_centre", centre.p}, {"x", x}, {"rho", rho}, {"u", u}, {"v", v}, {"p", p}};
}

}  // namespace

Oracle vortex_oracle() {
  return {.name = "vortex",
          .summary = "isentropic vortex of an ideal gas, carried by a uniform flow",
          .source = "Yee, Sandham and Djomehri, J. Comput. Phys. 150 (1999) 199",
          .parameters = {{"gamma", "1.4", "1", "ratio of specific heats"},
                         {"rho", "1", "kg/m^3", "density far away"},
                         {"p", "0.7142857142857143", "Pa", "pressure far away"},
                         {"u", "0", "m/s", "velocity that carries it, along x"},
                         {"v", "0", "m/s", "velocity that carries it, along y"},
                         {"radius", "1", "m", "of the largest speed"},
                         {"strength", "0.5", "m/s", "largest speed around the centre"},
                         {"t", "0", "s", "time; the centre starts at the origin"},
                         {"y", "0", "m", "where"},
                         {"x", "0:4:9", "m", "where: a number, a list 0,0.5,1 or a range 0:1:101"}},
          .evaluate = solve};
}

}  // namespace g27
