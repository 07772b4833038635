/// A stressed body that turns rigidly by a quarter: Jaumann's rate has to turn its stress with it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/cases/solid_problem.hpp"
#include "verification/exact/rigid_rotation.hpp"

namespace g27 {

namespace {

double invariant(Sym3 const& S) {
  double sum = 0;
  for (std::size_t c = 0; c < 6; ++c) sum += (c < 3 ? 1 : 2) * S[c] * S[c];
  return sum;
}

}  // namespace

Case solid_rotation_2d_case() {
  Case out{.name = "solid-rotation-2d",
           .title = "stressed body in rigid rotation about the axis of the box, a quarter turn",
           .source = "exact solution of the hypoelastic equations: verification/exact/rigid_rotation.hpp",
           .dimensions = 2,
           .default_cells = 48,
           .solid = true,
           .eos = {"steel"},
           .meshes = {"fixed"},
           .parameters = {{"mach", 0.1, "1", "speed of the middle of a side over that of P waves", 1e-3, 0.5},
                          {"turns", 0.25, "1", "revolutions", 1e-3, 100}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium("steel");
    double const size = 1, K = bulk_modulus(m.exact.law, m.rho0, 0.0), T = 0.01 * K;
    RigidRotation const body{.law = m.exact.law,
                             .rho = m.rho0,
                             .p = 0,
                             .S = {0.6 * T, -0.4 * T, -0.2 * T, 0.5 * T, -0.4 * T, 0.3 * T},
                             .rate = value_of(parameters, options, "mach") * m.sound / (0.5 * size)};
    SolidProblem problem{.solid = m.scheme,
                         .dimensions = 2,
                         .lower = {-0.5 * size, -0.5 * size, 0},
                         .upper = {0.5 * size, 0.5 * size, 1}};
    problem.t_end = value_of(parameters, options, "turns") * 2 * std::numbers::pi / body.rate;
    auto const at = [=](Vec3 const& x, double t) { return body.at(x, t); };
    for (SolidBoundary& side : problem.sides) side = solid_inflow(at);
    auto const mean = [=](double t) { return solid_mean(2, [=](Vec3 const& x) { return at(x, t); }); };
    problem.initial = mean(0), problem.reference = mean(problem.t_end);
    problem.measure = [=, t = problem.t_end](SolidGrid const& grid, CaseResult& r) {
      double error = 0, drift = 0, kinetic = 0, exact = 0;
      double const first = invariant(body.S);
      for (int j = 0; j < grid.cells()[1]; ++j) {
        for (int i = 0; i < grid.cells()[0]; ++i) {
          Vec3 const x = grid.centre({i, j, 0});
          SolidPoint const s = grid.primitive({i, j, 0}), e = body.at(x, t);
          double gap = 0;
          for (std::size_t c = 0; c < 6; ++c) gap += (c < 3 ? 1 : 2) * (s.S[c] - e.S[c]) * (s.S[c] - e.S[c]);
          error = std::max(error, std::sqrt(gap / first));
          drift = std::max(drift, std::fabs(invariant(s.S) / first - 1));
          for (std::size_t c = 0; c < 3; ++c) kinetic += s.rho * s.u[c] * s.u[c], exact += e.rho * e.u[c] * e.u[c];
        }
      }
      r.facts["stress_error"] = error;     // largest |S - S_exact|/|S|
      r.facts["invariant_drift"] = drift;  // largest change of S:S, relative
      r.facts["kinetic_energy_error"] = kinetic / exact - 1;
    };
    return run_problem("solid-rotation-2d", 48, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
