#include "verification/exact/axial_waves.hpp"
#include "verification/exact/solid_arguments.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  SolidMaterial const material = solid_material_argument(arguments);
  SolidPoint const state = solid_state_argument(arguments, material);
  SolidPoint const ahead =
      axial_state(material, state.rho, 0, state.p, number(arguments, "sxx"), number(arguments, "ep"));
  AxialWaves const waves = axial_piston(material, ahead, number(arguments, "u"), Direction::right);
  OracleRecord out{{"pattern", waves.pattern()}, {"residual", waves.residual()}};
  std::vector<double> head, tail, sigma;
  SolidColumns behind;
  for (auto const& wave : waves.waves()) {
    head.push_back(wave.head);
    tail.push_back(wave.tail);
    sigma.push_back(wave.behind.p - wave.behind.S[0]);
    behind.add(wave.behind);
  }
  out.insert(out.end(), {{"head", head},
                         {"tail", tail},
                         {"sigma_behind", sigma},
                         {"rho_behind", behind.rho},
                         {"u_behind", behind.u},
                         {"p_behind", behind.p},
                         {"e_behind", behind.e},
                         {"sxx_behind", behind.sxx},
                         {"ep_behind", behind.ep}});
  auto const samples = samples_argument(arguments);
  if (!samples) return out;
  SolidColumns columns;
  for (double const position : samples->x) columns.add(waves.at(samples->speed(position)));
  out.push_back({"x", samples->x});
  columns.append_to(out);
  return out;
}

}  // namespace

Oracle ep_piston_oracle() {
  std::vector<OracleParameter> parameters{
      {"u", "50", "m/s", "velocity of the piston, which pushes to the right if positive"},
      {"sxx", "0", "Pa", "deviator ahead, along x"},
      {"ep", "0", "1", "plastic strain ahead"},
      {"x", not_given, "m", "where to sample, from the piston's start: a number, a list 0,0.5,1 or a range 0:1:101"},
      {"t", not_given, "s", "when to sample"}};
  for (auto const& p : solid_state_parameters()) parameters.push_back(p);
  for (auto const& p : solid_parameters()) parameters.push_back(p);
  return {.name = "ep-piston",
          .summary = "piston in an elastoplastic solid: elastic precursor and plastic wave",
          .source = "Wilkins, Methods in Computational Physics 3 (1964) 211; ExactPack 1.7.11, elastic-plastic piston",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
