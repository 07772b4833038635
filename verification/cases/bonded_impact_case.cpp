/// A solid that runs into another and stays bonded to it; both yield: elastic and plastic waves in both, exact.
#include <cmath>
#include <memory>

#include "verification/cases/bonded_problem.hpp"
#include "verification/exact/ep_riemann.hpp"

namespace g27 {

namespace {

constexpr double length = 0.1;  ///< of each solid [m]

}  // namespace

Case bonded_impact_case() {
  Case out{.name = "bonded-impact",
           .title = "a solid runs into another, both yield: elastic and plastic waves in both",
           .source = "exact waves of uniaxial strain: verification/exact/ep_riemann.hpp",
           .dimensions = 1,
           .default_cells = 800,
           .solid = true,
           .eos = bonded_pairs(),
           .meshes = {"lagrangian"},
           .parameters = {{"velocity", 300, "m/s", "of the solid on the left", 1, 2000},
                          {"yields", 1, "1", "1: both solids yield; 0: both are elastic", 0, 1, true}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    std::string const pair = options.eos.value_or("steel-aluminium");
    auto const [l, r] = bonded_media(pair, value_of(parameters, options, "yields") != 0);
    SolidPoint const before_l = axial_state(l.exact, l.rho0, value_of(parameters, options, "velocity"), 0);
    SolidPoint const before_r = axial_state(r.exact, r.rho0, 0, 0);
    auto const exact = std::make_shared<EpRiemann>(l.exact, before_l, r.exact, before_r);
    BondedProblem problem{.left = {.medium = l, .length = length}, .right = {.medium = r, .length = length}};
    double fastest = 0;
    for (double const s : exact->speeds()) fastest = std::fmax(fastest, std::fabs(s));
    fastest = std::fmax(fastest, before_l.u[0] + exact->left().sound_speed());
    double const t_end = problem.t_end = 0.8 * length / fastest;
    auto const at_start = [](SolidPoint const& s) { return [q = densities(s)](double, double) { return q; }; };
    problem.left.initial = at_start(before_l), problem.right.initial = at_start(before_r);
    // each solid by its own waves: a cell beside the contact may reach over it by round-off
    auto const at_end = [=](AxialWaves const& waves) {
      return [=](double a, double b) {
        std::vector<double> breaks = waves.speeds();
        for (double& s : breaks) s *= t_end;
        return solid_average([&](double x) { return waves.at(x / t_end); }, a, b, breaks);
      };
    };
    problem.left.reference = at_end(exact->left()), problem.right.reference = at_end(exact->right());
    SolidPoint met;
    met.u[0] = exact->u_star(), met.p = exact->sigma_star();
    problem.contact = [=](double) { return met; };
    CaseResult result = run_problem("bonded-impact", 800, problem, options);
    result.eos = pair;
    result.facts["exact_contact_stress"] = exact->sigma_star();
    result.facts["exact_contact_velocity"] = exact->u_star();
    result.facts["contact_stress_error"] = result.facts["contact_stress"] / exact->sigma_star() - 1;
    result.facts["contact_velocity_error"] = result.facts["contact_velocity"] / exact->u_star() - 1;
    return result;
  };
  return out;
}

}  // namespace g27
