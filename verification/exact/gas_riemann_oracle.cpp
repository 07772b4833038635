#include "verification/exact/arguments.hpp"
#include "verification/exact/gas_riemann.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  auto state = [&](std::string const& side) {
    return GasState<>{positive_number(arguments, "rho" + side), number(arguments, "u" + side),
                      number(arguments, "p" + side)};
  };
  GasRiemann const solution(eos_argument(arguments, "_l"), state("_l"), eos_argument(arguments, "_r", "_l"),
                            state("_r"));
  OracleRecord out{{"p_star", solution.p_star()},         {"u_star", solution.u_star()},
                   {"rho_star_l", solution.rho_star_l()}, {"rho_star_r", solution.rho_star_r()},
                   {"wave_l", solution.wave_l()},         {"wave_r", solution.wave_r()},
                   {"pattern", solution.pattern()},       {"speeds", solution.speeds()}};
  auto const samples = samples_argument(arguments);
  if (!samples) return out;
  std::vector<double> rho, u, p;
  for (double const position : samples->x) {
    GasState<> const s = solution.at(samples->speed(position));
    rho.push_back(s.rho);
    u.push_back(s.u);
    p.push_back(s.p);
  }
  out.insert(out.end(), {{"x", samples->x}, {"rho", rho}, {"u", u}, {"p", p}});
  return out;
}

}  // namespace

Oracle gas_riemann_oracle() {
  std::vector<OracleParameter> parameters{
      {"rho_l", "", "kg/m^3", "density on the left"},
      {"u_l", "", "m/s", "velocity on the left"},
      {"p_l", "", "Pa", "pressure on the left"},
      {"rho_r", "", "kg/m^3", "density on the right"},
      {"u_r", "", "m/s", "velocity on the right"},
      {"p_r", "", "Pa", "pressure on the right"},
      {"x", not_given, "m", "where to sample: a number, a list 0,0.5,1 or a range 0:1:101"},
      {"t", not_given, "s", "when to sample"},
      {"x0", "0", "m", "position of the jump"}};
  for (auto const& p : eos_parameters("_l")) parameters.push_back(p);
  // on the right everything not given is as on the left
  for (auto const& p : eos_parameters("_r", not_given)) parameters.push_back(p);
  return {.name = "gas-riemann",
          .summary = "Riemann problem between two gases of any equation of state: star states, waves, samples",
          .source =
              "Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., ch. 4; general laws: "
              "Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
