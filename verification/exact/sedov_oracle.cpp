#include "verification/exact/arguments.hpp"
#include "verification/exact/sedov.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  Sedov const blast(number(arguments, "gamma"), symmetry_argument(arguments), positive_number(arguments, "energy"),
                    positive_number(arguments, "rho"));
  double const t = positive_number(arguments, "t");
  GasState<> const behind = blast.shocked(t);
  OracleRecord out{{"alpha", blast.alpha()},      {"shock", blast.shock_radius(t)}, {"rho_shocked", behind.rho},
                   {"u_shocked", behind.u},       {"p_shocked", behind.p},          {"p_centre", blast.at(0, t).p},
                   {"residual", blast.residual()}};
  if (!given(arguments, "r")) return out;
  std::vector<double> const r = numbers(arguments, "r");
  std::vector<double> rho, u, p;
  for (double const radius : r) {
    if (radius < 0) throw OracleError{"r", "is negative", "give a radius of at least 0"};
    GasState<> const s = blast.at(radius, t);
    rho.push_back(s.rho);
    u.push_back(s.u);
    p.push_back(s.p);
  }
  out.insert(out.end(), {{"r", r}, {"rho", rho}, {"u", u}, {"p", p}});
  return out;
}

}  // namespace

Oracle sedov_oracle() {
  return {
      .name = "sedov",
      .summary = "point explosion in a cold ideal gas",
      .source = "Sedov, Similarity and Dimensional Methods in Mechanics (1959), ch. IV; Kamm and Timmes, LA-UR-07-2849",
      .parameters = {{"gamma", "1.4", "1", "ratio of specific heats"},
                     {"rho", "1", "kg/m^3", "initial density"},
                     {"energy", "0.851072", "J", "energy released (planar: J/m^2 on both sides; cylindrical: J/m)"},
                     symmetry_parameter("spherical"),
                     {"t", "1", "s", "time"},
                     {"r", not_given, "m", "where: a number, a list 0,0.5,1 or a range 0:1:101"}},
      .evaluate = solve};
}

}  // namespace g27
