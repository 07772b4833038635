#include <numbers>

#include "verification/exact/arguments.hpp"
#include "verification/exact/free_vibration.hpp"

namespace g27 {
namespace {

char const* const components[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
char const* const axes[] = {"x", "y", "z"};

int whole(OracleArguments const& arguments, std::string const& key) {
  double const value = number(arguments, key);
  int const out = static_cast<int>(value);
  if (out != value) throw OracleError{key, "is " + arguments.at(key), "give a whole number"};
  return out;
}

OracleRecord solve(OracleArguments const& arguments) {
  std::string const name = word(arguments, "body", {"bar", "disc", "sphere"});
  FreeBody const body = name == "bar" ? FreeBody::bar : name == "disc" ? FreeBody::disc : FreeBody::sphere;
  ElasticSolid const solid{.rho = positive_number(arguments, "rho"),
                           .lambda = number(arguments, "lambda"),
                           .mu = positive_number(arguments, "mu")};
  FreeVibration const wave(body, solid, positive_number(arguments, "size"), whole(arguments, "order"),
                           whole(arguments, "mode"), positive_number(arguments, "speed"));
  OracleRecord out{{"frequency", wave.frequency()},
                   {"period", 2 * std::numbers::pi / wave.frequency()},
                   {"wave_number_T", wave.wave_number()},
                   {"wave_number_L", wave.wave_number() * solid.transverse_speed() / solid.longitudinal_speed()},
                   {"residual", wave.residual()},
                   {"rayleigh_gap", wave.rayleigh_gap()}};
  SolidPoint const s =
      wave.at({number(arguments, "x"), number(arguments, "y"), number(arguments, "z")}, number(arguments, "t"));
  out.insert(out.end(), {{"rho", s.rho}, {"p", s.p}});
  for (std::size_t i = 0; i < 3; ++i) out.push_back({std::string("u") + axes[i], s.u[i]});
  for (std::size_t c = 0; c < 6; ++c) out.push_back({std::string("s") + components[c], s.S[c]});
  return out;
}

}  // namespace

Oracle free_vibration_oracle() {
  return {
      .name = "free-vibration",
      .summary = "standing waves of a free bar, disc (plane strain) or sphere in linear elasticity",
      .source = "Love, A Treatise on the Mathematical Theory of Elasticity, 4th ed. (1927), ch. XII",
      .parameters = {{"body", "disc", "", "bar, disc or sphere"},
                     {"order", "0", "1", "of the angle: 0 radial; disc: cos(order theta); sphere: torsional from 1 on"},
                     {"mode", "1", "1", "1, 2, ... by frequency"},
                     {"rho", "7800", "kg/m^3", "density"},
                     {"lambda", "121.15333333333333e9", "Pa", "Lame's first modulus"},
                     {"mu", "80.77e9", "Pa", "shear modulus"},
                     {"size", "1", "m", "length of the bar, else radius"},
                     {"speed", "1", "m/s", "largest velocity on the surface"},
                     {"x", "0.5", "m", "where"},
                     {"y", "0", "m", "where"},
                     {"z", "0", "m", "where"},
                     {"t", "0", "s", "when; at 0 the body passes its shape at rest"}},
      .evaluate = solve};
}

}  // namespace g27
