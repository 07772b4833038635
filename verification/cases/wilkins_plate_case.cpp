/// A plate of aluminium that strikes a thicker one: elastic precursor and plastic shock, then the elastic and plastic
/// rarefactions of the free surface that overtake them.
#include "verification/cases/solid_line_problem.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

Case wilkins_plate_case() {
  Case out{.name = "wilkins-plate",
           .title = "5 mm of aluminium at 800 m/s onto 45 mm at rest, as one body with free surfaces",
           .source =
               "after Wilkins, Calculation of Elastic-Plastic Flow, UCRL-7322 (1963); no exact solution after the "
               "rarefactions meet: judged by a finer run (study solid-lagrange)",
           .dimensions = 1,
           .default_cells = 1000,
           .has_reference = false,
           .solid = true,
           .eos = {"aluminium"},
           .meshes = {"lagrangian"},
           .parameters = {{.name = "velocity", .value = 800, .unit = "m/s", .what = "of the flyer"},
                          {.name = "end", .value = 5e-6, .unit = "s", .what = "time of the profile"}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("aluminium"), true);
    double const u = value_of(parameters, options, "velocity"), flyer = 0.005;
    SolidLineProblem problem{.solid = m.scheme, .x1 = 0.05};
    problem.t_end = value_of(parameters, options, "end");
    problem.initial = [=](double x) { return SolidPoint{.rho = m.rho0, .u = {x < flyer ? u : 0.0, 0, 0}}; };
    problem.measure = [](SolidLine const& line, CaseResult& r) {
      r.facts["left_surface"] = line.faces().front(), r.facts["right_surface"] = line.faces().back();
      r.facts["plastic_work"] = line.ledger().plastic_work;
      r.facts["momentum_residual"] = line.ledger().momentum[0].residual();
    };
    return run_problem("wilkins-plate", 1000, problem, options);
  };
  return out;
}

}  // namespace g27
