#include "verification/exact/arguments.hpp"
#include "verification/exact/taylor_wave.hpp"

namespace g27 {
namespace {

ChapmanJouguet front(OracleArguments const& arguments, ExactEos const& eos) {
  auto const* jwl = std::get_if<JwlLaw>(&eos);
  auto const* ideal = std::get_if<IdealLaw>(&eos);
  int const ways = given(arguments, "E0") + given(arguments, "C") + given(arguments, "D");
  if (ways != 1)
    throw OracleError{"E0", "the explosive is not defined", "give exactly one of E0, C (jwl) and D (ideal)"};
  if (given(arguments, "C")) {
    if (!jwl) throw OracleError{"C", "belongs to jwl", "give E0 instead"};
    return chapman_jouguet_of_isentrope(*jwl, number(arguments, "C"));
  }
  double rho0 = 0;
  if (jwl && !given(arguments, "rho_explosive"))
    rho0 = jwl->rho0;
  else
    rho0 = positive_number(arguments, "rho_explosive");
  if (given(arguments, "E0")) return chapman_jouguet(eos, rho0, positive_number(arguments, "E0"));
  if (!ideal) throw OracleError{"D", "defines the explosive of an ideal gas only", "give E0 instead"};
  return chapman_jouguet_of_speed(*ideal, rho0, positive_number(arguments, "D"));
}

OracleRecord solve(OracleArguments const& arguments) {
  ExactEos const eos = eos_argument(arguments);
  TaylorWave const wave(eos, front(arguments, eos), symmetry_argument(arguments));
  ChapmanJouguet const& cj = wave.front();
  GasState<> const core = wave.core_state();
  OracleRecord out{{"D", cj.D},   {"p_CJ", cj.state.p},  {"rho_CJ", cj.state.rho}, {"u_CJ", cj.state.u},
                   {"E0", cj.E0}, {"core", wave.core()}, {"rho_core", core.rho},   {"p_core", core.p}};
  if (!given(arguments, "r")) return out;
  std::vector<double> const r = numbers(arguments, "r");
  std::vector<double> rho, u, p;
  for (double const ratio : r) {
    if (ratio < 0) throw OracleError{"r", "is negative", "give r/(D t) from 0 to 1"};
    GasState<> const s = wave.at(ratio);
    rho.push_back(s.rho);
    u.push_back(s.u);
    p.push_back(s.p);
  }
  out.insert(out.end(), {{"r", r}, {"rho", rho}, {"u", u}, {"p", p}});
  return out;
}

}  // namespace

Oracle taylor_wave_oracle() {
  std::vector<OracleParameter> parameters = eos_parameters("", "jwl");
  parameters.insert(
      parameters.begin(),
      {{"E0", not_given, "J/m^3", "energy released per initial volume"},
       {"C", not_given, "Pa", "third coefficient of the isentrope through the CJ state, instead of E0 (jwl)"},
       {"D", not_given, "m/s", "detonation speed, instead of E0 (ideal)"},
       {"rho_explosive", not_given, "kg/m^3", "density of the explosive (jwl: rho0)"},
       symmetry_parameter("spherical"),
       {"r", not_given, "1", "where: r/(D t) as a number, a list 0.5,0.9 or a range 0:1:101"}});
  return {.name = "taylor-wave",
          .summary = "Chapman-Jouguet state and the self-similar flow behind the detonation",
          .source = "Taylor, Proc. R. Soc. A 200 (1950) 235; Fickett and Davis, Detonation (1979), 2A",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
