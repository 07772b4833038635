/// A plate of aluminium that strikes a thicker one: elastic precursor and plastic shock, then the elastic and plastic
/// rarefactions of the free surface that overtake them.
#include "verification/cases/solid_line_problem.hpp"
#include "verification/cases/solid_media.hpp"
#include "verification/exact/axial_waves.hpp"

namespace g27 {

namespace {

constexpr double flyer = 0.005, length = 0.05;  ///< [m]

/// State between the elastic release and the plastic one that follow the shock: the material is shocked to half of the
/// flyer's velocity, by symmetry, and expands elastically until it yields.
SolidPoint released(SolidMaterial const& m, double rho0, double u) {
  SolidPoint const shocked = axial_piston(m, axial_state(m, rho0, 0, 0), 0.5 * u, Direction::right).behind();
  AxialWaves const release(m, shocked, 0.5 * (shocked.p - shocked.S[0]), Direction::right);
  return release.waves().empty() ? shocked : release.waves().front().behind;
}

}  // namespace

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
           .parameters = {
               {.name = "velocity", .value = 800, .unit = "m/s", .what = "of the flyer", .least = 1, .most = 2000},
               {.name = "end", .value = 5e-6, .unit = "s", .what = "time of the profile"}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("aluminium"), true);
    double const u = value_of(parameters, options, "velocity");
    SolidLineProblem problem{.solid = m.scheme, .x1 = length};
    problem.t_end = value_of(parameters, options, "end");
    problem.initial = [=](double x) { return SolidPoint{.rho = m.rho0, .u = {x < flyer ? u : 0.0, 0, 0}}; };
    problem.measure = [exact = released(m.exact, m.rho0, u)](SolidLine const& line, CaseResult& r) {
      // material 27 to 28 mm from the flyer's free surface is between the two releases after 5 us
      std::size_t const from = line.cells() * 27 / 50, to = line.cells() * 28 / 50;
      double velocity = 0, stress = 0, deviator = 0;
      for (std::size_t i = from; i < to; ++i) {
        SolidPoint const s = line.primitive(i);
        velocity += s.u[0], stress += s.stress(0, 0), deviator += s.S[0];
      }
      double const count = static_cast<double>(to - from);
      r.facts["release_velocity"] = velocity / count;
      r.facts["release_velocity_error"] = velocity / count / exact.u[0] - 1;
      r.facts["release_stress_error"] = stress / count / exact.stress(0, 0) - 1;
      r.facts["release_sxx_error"] = deviator / count / exact.S[0] - 1;
      r.facts["left_surface"] = line.faces().front(), r.facts["right_surface"] = line.faces().back();
      r.facts["plastic_work"] = line.ledger().plastic_work;
      r.facts["momentum_residual"] = line.ledger().momentum[0].residual();
    };
    return run_problem("wilkins-plate", 1000, problem, options);
  };
  return out;
}

}  // namespace g27
