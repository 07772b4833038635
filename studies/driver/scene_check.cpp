#include "studies/driver/scene_check.hpp"

#include <chrono>
#include <cmath>

#include "scheme/step/map_line_to_grid.hpp"
#include "studies/driver/grid_simulate.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/simulate.hpp"
#include "verification/measure/memory.hpp"

namespace g27 {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) { return std::chrono::duration<double>(Clock::now() - began).count(); }

/// Steps of a mesh from where it is, within the budget, extrapolated to the end of the run.
template <class Mesh>
void extrapolate(Mesh& mesh, SceneRun const& run, double budget_s, RunEstimate& e) {
  auto const began = Clock::now();
  double const from = mesh.time();
  double elapsed = 0;
  int steps = 0;
  while (elapsed < budget_s && mesh.time() < run.end && mesh.step(run.end).status == StepStatus::ok) {
    elapsed = seconds_since(began);
    ++steps;
  }
  double const covered = mesh.time() - from;
  e.steps = covered > 0 ? std::ceil(steps * (run.end - from) / covered) : 0;
  e.seconds += steps > 0 ? elapsed / steps * e.steps : 0;
}

void estimate_grid(SceneRun const& run, double budget_s, RunEstimate& e) {
  GridRun const& plan = *run.grid;
  GasGrid grid = make_grid(run);
  auto const began = Clock::now();
  if (plan.line) {
    // The first phase in full: it costs little, and the steps after it are those of the run.
    GasLine line = make_start_line(*plan.line, run.start);
    LinePhase phase;
    while (!line_phase_over(*plan.line, plan.setup, line, phase) && line.time() < run.end &&
           line.step(std::min(plan.line->until, run.end)).status == StepStatus::ok) {
    }
    e.line_steps = static_cast<double>(line.counters().steps);
    GridBox const box{plan.setup.lower, plan.setup.upper, plan.setup.cells};
    grid.set_cells(LineToGrid(line, plan.line->centre, box), line.time());
  } else {
    grid.set_averages(plan.initial, run.start);
  }
  e.seconds = seconds_since(began);
  extrapolate(grid, run, budget_s, e);
  e.memory = static_cast<double>(grid.bytes());
  auto const cells = static_cast<double>(e.cells);
  double const columns = 11 + 6 * static_cast<double>(run.output.probes.size());
  e.bytes = 8 * ((2 + run.dimensions()) * cells * static_cast<double>(run.output.snapshots.size()) +
                 columns * (run.end - run.start) / run.output.history_every);
}

void estimate_line(SceneRun const& run, double budget_s, RunEstimate& e) {
  GasLine line = make_line(run);
  extrapolate(line, run, budget_s, e);
  auto const cells = static_cast<double>(e.cells);
  double const rows = run.output.history_every > 0 ? (run.end - run.start) / run.output.history_every : e.steps;
  double const columns = 8 + 3 * static_cast<double>(run.output.probes.size());
  double const map = 3 * std::min(cells, 600.0) * run.output.map_times;
  e.bytes = 8 * (4 * cells * static_cast<double>(run.output.snapshots.size()) + 5 * cells + columns * rows + map);
}

}  // namespace

void require_memory(Scene const& scene) {
  constexpr double quiet_share = 0.9;  // of a scene's tiles, at most, that stay untouched
  for (SceneRun const& run : scene.runs) {
    if (!run.grid) continue;
    double const stored = run.grid->setup.options.skip ? 1 - quiet_share : 1.0;
    try {
      require_memory(static_cast<double>(run.cells()), gas_cell_bytes * stored);
    } catch (std::invalid_argument const& error) {
      throw InputError(scene.file.string(), "domain.cells", error.what(), "choose fewer cells");
    }
  }
}

std::vector<RunEstimate> estimate(Scene const& scene, double budget_s) {
  std::vector<RunEstimate> out;
  for (SceneRun const& run : scene.runs) {
    RunEstimate e{.name = run.name, .cells = run.cells()};
    if (run.grid) {
      estimate_grid(run, budget_s, e);
    } else {
      estimate_line(run, budget_s, e);
    }
    out.push_back(e);
  }
  return out;
}

}  // namespace g27
