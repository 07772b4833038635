#include "verification/exact/arguments.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/superseismic.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  SuperseismicSetup const setup{.gamma = number(arguments, "gamma"),
                                .gas_density = positive_number(arguments, "rho"),
                                .gas_pressure = positive_number(arguments, "p"),
                                .solid_density = positive_number(arguments, "rho_solid"),
                                .lambda = number(arguments, "lambda"),
                                .mu = positive_number(arguments, "mu"),
                                .speed = positive_number(arguments, "speed"),
                                .normal = word(arguments, "normal", {"undeformed", "deformed"}) == "deformed"
                                              ? StressNormal::deformed
                                              : StressNormal::undeformed};
  if (!(setup.gamma > 1)) throw OracleError{"gamma", "is " + arguments.at("gamma"), "give a number above 1"};
  if (!(setup.lambda + setup.mu > 0)) throw OracleError{"lambda", "is too low", "give a number above -mu"};
  Superseismic const s(setup);
  auto const& behind = s.behind_s();
  return {{"shock_angle", s.shock_angle()},   {"interface_angle", s.interface_angle()},
          {"p_wave_angle", s.p_wave_angle()}, {"s_wave_angle", s.s_wave_angle()},
          {"p_behind", s.gas_behind().p},     {"rho_behind", s.gas_behind().rho},
          {"u_gas", s.gas_behind().u[0]},     {"v_gas", s.gas_behind().u[1]},
          {"u_solid_p", s.behind_p().u[0]},   {"v_solid_p", s.behind_p().u[1]},
          {"u_solid", behind.u[0]},           {"v_solid", behind.u[1]},
          {"sxx_solid", behind.stress[0][0]}, {"sxy_solid", behind.stress[0][1]},
          {"syy_solid", behind.stress[1][1]}, {"residual", s.residual()}};
}

}  // namespace

Oracle superseismic_oracle() {
  return {.name = "superseismic",
          .summary = "shock in a gas along the surface of an elastic solid, faster than its waves; angles in rad",
          .source = "Banks, Henshaw and Schwendeman, J. Comput. Phys. 231 (2012) 3518",
          .parameters = {{"gamma", "1.4", "1", "ratio of specific heats"},
                         {"rho", "0.1114827", "kg/m^3", "density of the gas ahead"},
                         {"p", "0.010451503125", "Pa", "its pressure"},
                         {"rho_solid", "1", "kg/m^3", "density of the solid"},
                         {"lambda", "0.1398307", "Pa", "Lame's first modulus"},
                         {"mu", "0.07203351", "Pa", "shear modulus"},
                         {"speed", "1", "m/s", "of the foot of the shock along the surface"},
                         {"normal", "deformed", "", "on which the pressure acts: deformed or undeformed"}},
          .evaluate = solve};
}

}  // namespace g27
