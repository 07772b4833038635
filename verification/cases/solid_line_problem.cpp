#include "verification/cases/solid_line_problem.hpp"

#include <chrono>
#include <stdexcept>

#include "verification/cases/grid_run.hpp"
#include "verification/cases/line_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_problem.hpp"

namespace g27 {

SolidSchemeOptions solid_line_options(CaseOptions const& options) {
  return {.predictor = options.predictor.value_or(Predictor::linear),
          .monotonicity = options.monotonicity.value_or(Switch::graded),
          .cfl = options.cfl.value_or(0)};
}

CaseResult run_problem(std::string const& name, int cells, SolidLineProblem const& problem,
                       CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  SolidLineSetup setup{.material = problem.solid,
                       .faces = mesh_faces("uniform", problem.x0, problem.x1, n),
                       .symmetry = problem.symmetry,
                       .left = problem.left,
                       .right = problem.right,
                       .options = solid_line_options(options)};
  SolidLine line(std::move(setup));
  line.set_state(problem.initial, 5);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  while (line.time() < problem.t_end && !(problem.finished && problem.finished(line))) {
    if (line.step(problem.t_end).status != StepStatus::ok) {
      throw std::runtime_error(name + ": the step at t = " + std::to_string(line.time()) + " failed");
    }
    if (options.progress) options.progress(line.time() / problem.t_end);
  }
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.cells = n, r.grid = {n, 1, 1}, r.time = line.time();
  SolidSchemeOptions const& used = line.setup().options;
  r.order = order_of(used.predictor), r.scheme = name_of(used.predictor), r.monotonicity = name_of(used.monotonicity);
  r.mesh = "lagrangian";
  r.eos = std::visit([](auto const& eos) { return std::string(eos.name); }, problem.solid.eos);
  SolidCounters const& c = line.counters();
  r.counters.steps = c.steps, r.counters.faces = c.faces, r.counters.cell_updates = c.cell_updates;
  r.counters.switched = c.switched, r.counters.retried = c.retried;
  r.ledger = case_ledger(line.ledger());
  for (std::size_t i = 0; i < line.cells(); ++i) r.x.push_back(0.5 * (line.faces()[i] + line.faces()[i + 1]));
  auto const& names = solid_variables();
  for (std::size_t v = 0; v < names.size(); ++v) r.profile[names[v]] = line.field(static_cast<SolidGrid::Field>(v));
  r.profile["plastic_strain"] = line.field(SolidGrid::Field::plastic_strain);
  r.rho = r.profile["density"], r.u = r.profile["velocity_x"], r.p = r.profile["pressure"];
  if (problem.measure) problem.measure(line, r);
  return r;
}

}  // namespace g27
