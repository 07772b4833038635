#include "verification/exact/arguments.hpp"
#include "verification/exact/noh.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  Noh const noh{.gamma = number(arguments, "gamma"),
                .rho0 = positive_number(arguments, "rho"),
                .speed = positive_number(arguments, "speed"),
                .symmetry = symmetry_argument(arguments)};
  if (!(noh.gamma > 1)) throw OracleError{"gamma", "is " + arguments.at("gamma"), "give a number above 1"};
  double const t = positive_number(arguments, "t");
  GasState<> const inner = noh.shocked();
  OracleRecord out{{"shock", noh.shock_speed() * t}, {"rho_shocked", inner.rho}, {"p_shocked", inner.p}};
  if (!given(arguments, "r")) return out;
  std::vector<double> const r = numbers(arguments, "r");
  std::vector<double> rho, u, p;
  for (double const radius : r) {
    if (radius < 0) throw OracleError{"r", "is negative", "give a radius of at least 0"};
    GasState<> const s = noh.at(radius, t);
    rho.push_back(s.rho);
    u.push_back(s.u);
    p.push_back(s.p);
  }
  out.insert(out.end(), {{"r", r}, {"rho", rho}, {"u", u}, {"p", p}});
  return out;
}

}  // namespace

Oracle noh_oracle() {
  return {.name = "noh",
          .summary = "Noh's implosion of a cold ideal gas",
          .source = "Noh, J. Comput. Phys. 72 (1987) 78",
          .parameters = {{"gamma", "1.6666666666666667", "1", "ratio of specific heats"},
                         {"rho", "1", "kg/m^3", "initial density"},
                         {"speed", "1", "m/s", "inward speed"},
                         symmetry_parameter("spherical"),
                         {"t", "0.6", "s", "time"},
                         {"r", not_given, "m", "where: a number, a list 0,0.5,1 or a range 0:1:101"}},
          .evaluate = solve};
}

}  // namespace g27
