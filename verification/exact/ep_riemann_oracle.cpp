#include "verification/exact/ep_riemann.hpp"
#include "verification/exact/solid_arguments.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  auto state = [&](SolidMaterial const& material, std::string const& side) {
    SolidPoint const s = solid_state_argument(arguments, material, side);
    return axial_state(material, s.rho, number(arguments, "u" + side), s.p, number(arguments, "sxx" + side),
                       number(arguments, "ep" + side));
  };
  SolidMaterial const left = solid_material_argument(arguments, "_l"),
                      right = solid_material_argument(arguments, "_r", "_l");
  EpRiemann const solution(left, state(left, "_l"), right, state(right, "_r"));
  SolidPoint const l = solution.left().behind(), r = solution.right().behind();
  OracleRecord out{{"sigma_star", solution.sigma_star()},
                   {"u_star", solution.u_star()},
                   {"rho_star_l", l.rho},
                   {"rho_star_r", r.rho},
                   {"p_star_l", l.p},
                   {"p_star_r", r.p},
                   {"ep_star_l", l.ep},
                   {"ep_star_r", r.ep},
                   {"waves_l", solution.left().pattern()},
                   {"waves_r", solution.right().pattern()},
                   {"speeds", solution.speeds()},
                   {"residual", solution.residual()}};
  auto const samples = samples_argument(arguments);
  if (!samples) return out;
  SolidColumns columns;
  for (double const position : samples->x) columns.add(solution.at(samples->speed(position)));
  out.push_back({"x", samples->x});
  columns.append_to(out);
  return out;
}

}  // namespace

Oracle ep_riemann_oracle() {
  std::vector<OracleParameter> parameters{
      {"x", not_given, "m", "where to sample: a number, a list 0,0.5,1 or a range 0:1:101"},
      {"t", not_given, "s", "when to sample"},
      {"x0", "0", "m", "position of the jump"}};
  for (auto const& [side, name] : {std::pair{"_l", "left"}, {"_r", "right"}}) {
    std::string const suffix = side, where = std::string(" on the ") + name;
    parameters.push_back({"u" + suffix, "0", "m/s", "velocity" + where});
    parameters.push_back({"sxx" + suffix, "0", "Pa", "deviator along x" + where});
    parameters.push_back({"ep" + suffix, "0", "1", "plastic strain" + where});
    for (auto const& p : solid_state_parameters(suffix)) parameters.push_back(p);
  }
  for (auto const& p : solid_parameters("_l")) parameters.push_back(p);
  // on the right everything not given is as on the left
  for (auto const& p : solid_parameters("_r", not_given)) parameters.push_back(p);
  return {.name = "ep-riemann",
          .summary = "Riemann problem of uniaxial strain between two elastoplastic solids, or a solid and a fluid",
          .source =
              "Wilkins, Methods in Computational Physics 3 (1964) 211; general laws: Menikoff and Plohr, Rev. Mod. "
              "Phys. 61 (1989) 75",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
