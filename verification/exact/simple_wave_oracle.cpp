#include <cmath>
#include <numbers>

#include "verification/exact/arguments.hpp"
#include "verification/exact/simple_wave.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  GasState<> const base{positive_number(arguments, "rho"), number(arguments, "u"), number(arguments, "p")};
  double const amplitude = number(arguments, "amplitude"), length = positive_number(arguments, "wavelength"),
               t = number(arguments, "t");
  bool const right = word(arguments, "running", {"right", "left"}) == "right";
  SimpleWave const wave(
      eos_argument(arguments), base, [&](double x) { return amplitude * std::sin(2 * std::numbers::pi * x / length); },
      amplitude, right ? Running::right : Running::left);
  double const breaking = wave.breaking_time(0, length);
  if (t < 0 || t >= breaking)
    throw OracleError{"t", "the wave breaks at " + std::to_string(breaking), "give 0 <= t below that"};
  std::vector<double> const x = numbers(arguments, "x");
  std::vector<double> rho, u, p;
  for (double const position : x) {
    GasState<> const s = wave.at(position, t);
    rho.push_back(s.rho);
    u.push_back(s.u);
    p.push_back(s.p);
  }
  return {{"breaking_time", breaking}, {"x", x}, {"rho", rho}, {"u", u}, {"p", p}};
}

}  // namespace

Oracle simple_wave_oracle() {
  std::vector<OracleParameter> parameters = eos_parameters();
  parameters.insert(parameters.begin(),
                    {{"rho", "1", "kg/m^3", "density of the base state"},
                     {"u", "0", "m/s", "its velocity"},
                     {"p", "1", "Pa", "its pressure"},
                     {"amplitude", "0.1", "m/s", "of the velocity, u + amplitude sin(2 pi x/wavelength)"},
                     {"wavelength", "1", "m", "period of the wave"},
                     {"running", "right", "", "right or left"},
                     {"t", "0", "s", "time, before the wave breaks"},
                     {"x", "0:1:11", "m", "where: a number, a list 0,0.5,1 or a range 0:1:101"}});
  return {.name = "simple-wave",
          .summary = "nonlinear simple wave before breaking, any equation of state",
          .source = "Courant and Friedrichs, Supersonic Flow and Shock Waves (1948), section 40",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
