#include "verification/exact/arguments.hpp"
#include "verification/exact/gas_solid.hpp"

namespace g27 {
namespace {

/// Steel of the paper unless the arguments say otherwise; rho_s is the density at rest, sxx_s the stress there.
SolidMaterial material_argument(OracleArguments const& arguments, std::string const& model) {
  SolidMaterial out{.law = LinearBulkLaw{positive_number(arguments, "K_s"), positive_number(arguments, "rho_s")},
                    .mu = number(arguments, "mu_s")};
  if (out.mu < 0) throw OracleError{"mu_s", "is negative", "give 0, a fluid, or more"};
  if (model != "elastoplastic") {
    for (std::string const key : {"Y_s", "H_s"}) {
      if (given(arguments, key))
        throw OracleError{key, "is of no use: a " + model + " solid does not yield", "add model=elastoplastic"};
    }
    return out;
  }
  out.yield = given(arguments, "Y_s") ? positive_number(arguments, "Y_s") : 340e6;
  out.hardening = given(arguments, "H_s") ? number(arguments, "H_s") : 240e6;
  if (out.hardening < 0) throw OracleError{"H_s", "is negative", "give 0 or more"};
  return out;
}

/// The solid in uniaxial strain from rho_s, p = 0, S = 0 until its normal stress is sxx: along the elastic path and,
/// beyond the yield stress, the plastic one.
SolidPoint solid_argument(OracleArguments const& arguments, SolidMaterial const& material, bool linear) {
  double const u = number(arguments, "u_s"), sxx = number(arguments, "sxx_s");
  double const rho0 = std::get<LinearBulkLaw>(material.law).rho0;
  SolidPoint const rest = axial_state(material, rho0, u, 0);
  if (linear || sxx == 0) {
    // the impedance is that of rho_s, whatever the stress, which is taken as a pressure
    SolidPoint out = rest;
    out.p = -sxx;
    return out;
  }
  SolidPoint out = AxialWaves(material, rest, -sxx, Direction::right).behind();
  out.u[0] = u;
  return out;
}

OracleRecord solve(OracleArguments const& arguments) {
  std::string const model = word(arguments, "model", {"linear", "elastic", "elastoplastic"});
  bool const linear = model == "linear";
  SolidMaterial const material = material_argument(arguments, model);
  GasState<> const gas{positive_number(arguments, "rho"), number(arguments, "u"), number(arguments, "p")};
  SolidPoint const solid = solid_argument(arguments, material, linear);
  GasSolid const solution(eos_argument(arguments), gas, material, solid,
                          linear ? SolidModel::linear : SolidModel::waves);
  SolidPoint const star = solution.solid_star();
  // sound speed of the solid without stress: its density has grown with the first stress as it does with more of it
  double const a = solution.solid_speeds().front() - solid.u[0];
  double const denser = linear ? solid.p / (a * a) : 0;
  OracleRecord out{{"p_star", solution.p_star()},
                   {"u_star", solution.u_star()},
                   {"rho_star_gas", solution.gas().rho_star_l()},
                   {"rho_star_solid", star.rho + denser},
                   {"ep_star", star.ep},
                   {"wave_gas", solution.gas().wave_l()},
                   {"vacuum", std::string(solution.vacuum() ? "yes" : "no")},
                   {"waves_solid", solution.solid_pattern()},
                   {"speeds_solid", solution.solid_speeds()},
                   {"residual", solution.residual()}};
  auto const samples = samples_argument(arguments);
  if (!samples) return out;
  std::vector<double> rho, u, p;
  for (double const position : samples->x) {
    double const xi = samples->speed(position);
    if (xi < solution.u_star()) {
      GasState<> const s = solution.gas().at(xi);
      rho.push_back(s.rho), u.push_back(s.u), p.push_back(s.p);
    } else {
      SolidPoint const s = solution.solid_at(xi);
      rho.push_back(s.rho + denser), u.push_back(s.u[0]), p.push_back(s.p - s.S[0]);
    }
  }
  out.insert(out.end(), {{"x", samples->x}, {"rho", rho}, {"u", u}, {"p", p}});
  return out;
}

}  // namespace

Oracle gas_solid_oracle() {
  std::vector<OracleParameter> parameters{
      {"rho", "", "kg/m^3", "density of the gas, on the left"},
      {"u", "", "m/s", "its velocity"},
      {"p", "", "Pa", "its pressure"},
      {"model", "linear", "",
       "of the solid, on the right: linear (constant impedance), elastic or elastoplastic (finite strain)"},
      {"rho_s", "7800", "kg/m^3", "density of the solid without stress"},
      {"K_s", "175e9", "Pa", "its bulk modulus, p = K (rho/rho_s - 1)"},
      {"mu_s", "80.77e9", "Pa", "its shear modulus"},
      {"Y_s", not_given, "Pa", "its yield stress in tension (elastoplastic; 340e6)"},
      {"H_s", not_given, "Pa", "linear hardening (elastoplastic; 240e6)"},
      {"u_s", "0", "m/s", "its velocity"},
      {"sxx_s", "0", "Pa", "its normal stress, in uniaxial strain; negative: compressed"},
      {"x", not_given, "m", "where to sample: a number, a list 0,0.5,1 or a range 0:1:101; p is -sxx in the solid"},
      {"t", not_given, "s", "when to sample"},
      {"x0", "0", "m", "position of the contact at first"}};
  for (auto const& p : eos_parameters()) parameters.push_back(p);
  return {
      .name = "gas-solid",
      .summary = "contact of a gas of any equation of state with an elastic or yielding solid: pressure and velocity",
      .source =
          "gas: Toro, Riemann Solvers, 3rd ed., ch. 4; solid: Wilkins, Methods in Computational Physics 3 (1964) "
          "211; general laws: Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75",
      .parameters = parameters,
      .evaluate = solve};
}

}  // namespace g27
