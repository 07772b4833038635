#include <algorithm>
#include <cmath>

#include "verification/exact/arguments.hpp"
#include "verification/exact/isentrope.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  double const rho0 = positive_number(arguments, "rho"), p0 = number(arguments, "p"),
               to = positive_number(arguments, "rho_to");
  double const count = number(arguments, "points");
  if (count < 1 || count > 1e5) throw OracleError{"points", "is out of range", "give a number from 1 to 100000"};
  if (to == rho0) throw OracleError{"rho_to", "equals rho", "give the density at the other end"};
  ExactEos const eos = eos_argument(arguments);
  std::vector<double> rho;
  for (int i = 1; i <= static_cast<int>(count); ++i) rho.push_back(rho0 + (to - rho0) * i / count);
  Isentrope const closed(eos, rho0, p0);
  std::vector<double> p, c, invariant;
  double worst = 0;
  for (auto const& point : integrate_isentrope(eos, rho0, p0, rho)) {
    p.push_back(closed.pressure(point.rho));
    c.push_back(closed.sound_speed(point.rho));
    invariant.push_back(closed.invariant(point.rho));
    worst = std::max(worst, std::fabs(point.p - p.back()) / (point.rho * point.c * point.c));
  }
  return {{"rho", rho}, {"p", p}, {"c", c}, {"invariant", invariant}, {"gap_to_first_law", worst}};
}

}  // namespace

Oracle isentrope_oracle() {
  std::vector<OracleParameter> parameters = eos_parameters();
  parameters.insert(parameters.begin(), {{"rho", "", "kg/m^3", "density at the start"},
                                         {"p", "", "Pa", "pressure at the start"},
                                         {"rho_to", "", "kg/m^3", "density at the end"},
                                         {"points", "10", "1", "number of equidistant densities"}});
  return {.name = "isentrope",
          .summary =
              "pressure, sound speed and Riemann invariant along an isentrope; gap_to_first_law compares the "
              "closed form with an integration of de = p d rho/rho^2, relative to rho c^2",
          .source = "first law; Lee, Hornig and Kury 1968 for JWL; Meyers 1994, 5.2 for Mie-Grueneisen",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
