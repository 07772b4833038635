#include "verification/exact/arguments.hpp"
#include "verification/exact/blake.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  Blake const blake{.lambda = number(arguments, "lambda"),
                    .mu = positive_number(arguments, "mu"),
                    .rho = positive_number(arguments, "rho"),
                    .radius = positive_number(arguments, "radius"),
                    .pressure = number(arguments, "pressure")};
  if (!(3 * blake.lambda > -2 * blake.mu))
    throw OracleError{"lambda", "gives no bulk modulus above 0", "give more than -2 mu/3"};
  double const t = number(arguments, "t");
  std::vector<double> const r = numbers(arguments, "r");
  std::vector<double> displacement, velocity, stress_rr, stress_tt, p;
  for (double const radius : r) {
    if (radius < blake.radius) throw OracleError{"r", "lies inside the cavity", "give at least the cavity's radius"};
    Blake::Point const s = blake.at(radius, t);
    displacement.push_back(s.displacement);
    velocity.push_back(s.velocity);
    stress_rr.push_back(s.stress_rr);
    stress_tt.push_back(s.stress_tt);
    p.push_back(-(s.stress_rr + 2 * s.stress_tt) / 3);
  }
  return {{"speed", blake.sound_speed()},
          {"front", blake.front(t)},
          {"static_displacement", blake.static_displacement()},
          {"r", r},
          {"displacement", displacement},
          {"velocity", velocity},
          {"stress_rr", stress_rr},
          {"stress_tt", stress_tt},
          {"p", p}};
}

}  // namespace

Oracle blake_oracle() {
  return {.name = "blake",
          .summary = "pressurised spherical cavity in an infinite elastic solid",
          .source = "Blake, J. Acoust. Soc. Am. 24 (1952) 211; ExactPack 1.7.11, Blake's problem",
          .parameters = {{"lambda", "25e9", "Pa", "Lame's first modulus"},
                         {"mu", "25e9", "Pa", "shear modulus"},
                         {"rho", "3000", "kg/m^3", "density"},
                         {"radius", "0.1", "m", "of the cavity"},
                         {"pressure", "1e6", "Pa", "in the cavity, from t = 0 on"},
                         {"t", "160e-6", "s", "time"},
                         {"r", "0.1:1:10", "m", "where: a number, a list 0.1,0.5 or a range 0.1:1:10"}},
          .evaluate = solve};
}

}  // namespace g27
