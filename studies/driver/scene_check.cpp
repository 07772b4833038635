#include "studies/driver/scene_check.hpp"

#include <chrono>
#include <cmath>

#include "studies/driver/simulate.hpp"

namespace g27 {

std::vector<RunEstimate> estimate(Scene const& scene, double budget_s) {
  using Clock = std::chrono::steady_clock;
  std::vector<RunEstimate> out;
  for (SceneRun const& run : scene.runs) {
    GasLine line = make_line(run);
    RunEstimate e{.name = run.name, .cells = line.cells()};
    auto const began = Clock::now();
    double elapsed = 0;
    int steps = 0;
    while (elapsed < budget_s && line.time() < run.end && line.step(run.end).status == StepStatus::ok) {
      elapsed = std::chrono::duration<double>(Clock::now() - began).count();
      ++steps;
    }
    double const covered = line.time() - run.start;
    e.steps = covered > 0 ? std::ceil(steps * (run.end - run.start) / covered) : 0;
    e.seconds = steps > 0 ? elapsed / steps * e.steps : 0;
    auto const cells = static_cast<double>(e.cells);
    double const rows = run.output.history_every > 0 ? (run.end - run.start) / run.output.history_every : e.steps;
    double const columns = 8 + 3 * static_cast<double>(run.output.probes.size());
    double const map = 3 * std::min(cells, 600.0) * run.output.map_times;
    e.bytes = 8 * (4 * cells * static_cast<double>(run.output.snapshots.size()) + 5 * cells + columns * rows + map);
    out.push_back(e);
  }
  return out;
}

}  // namespace g27
