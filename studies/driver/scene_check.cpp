#include "studies/driver/scene_check.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fsi/surface/diagnosis.hpp"
#include "scheme/step/map_line_to_grid.hpp"
#include "studies/driver/body_history.hpp"
#include "studies/driver/grid_mesh.hpp"
#include "studies/driver/grid_simulate.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/simulate.hpp"
#include "verification/measure/memory.hpp"

namespace g27 {
namespace {

using Clock = std::chrono::steady_clock;

/// Of a body's grid: with the state that its overset window keeps.
constexpr double body_cell_bytes = solid_cell_bytes + sizeof(SolidFields);

double window_cells(SceneBody const& body) {
  auto const& size = solid_window(body.setup).size;
  return static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(size[2]);
}

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

/// With bodies the time step starts small and grows: their number goes by the one that is stable.
void extrapolate_bodies(GridMesh& mesh, SceneRun const& run, double budget_s, RunEstimate& e) {
  constexpr double steps_of_growth = 13;  // from a tenth, by 1.2 each
  auto const began = Clock::now();
  double elapsed = 0;
  int steps = 0;
  while (elapsed < budget_s && mesh.time() < run.end && mesh.step(run.end).status == StepStatus::ok) {
    elapsed = seconds_since(began);
    ++steps;
  }
  e.steps = std::ceil((run.end - mesh.time()) / mesh.stable_dt()) + steps_of_growth;
  e.seconds += steps > 0 ? elapsed / steps * e.steps : 0;
}

void estimate_grid(SceneRun const& run, double budget_s, RunEstimate& e) {
  GridRun const& plan = *run.grid;
  auto const mesh = make_mesh(run);
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
    LineToGrid const map(line, plan.line->centre, box);
    LineFieldView const view(line, plan.line->centre, run.dimensions());
    mesh->start([&](Int3 const& c) { return map(c); }, [&](Vec3 const& x) { return view.at(x); }, line.time());
  } else {
    mesh->start([&](Int3 const& c) { return plan.initial(mesh->gas().centre(c), mesh->gas().widths()); }, plan.point,
                run.start);
  }
  e.seconds = seconds_since(began);
  e.bodies = body_estimates(run);
  if (e.bodies.empty()) {
    extrapolate(*mesh, run, budget_s, e);
  } else {
    extrapolate_bodies(*mesh, run, budget_s, e);
  }
  e.memory = mesh->bytes();
  auto const cells = static_cast<double>(e.cells);
  auto const rows = (run.end - run.start) / run.output.history_every;
  double const columns =
      11 + 6 * static_cast<double>(run.output.probes.size()) + static_cast<double>(body_columns(run).size());
  double fields = (2 + run.dimensions()) * cells;
  if (!e.bodies.empty()) fields += cells;
  for (BodyEstimate const& body : e.bodies) fields += 7 * body.window + 7 * body.triangles;
  e.bytes = 8 * (fields * static_cast<double>(run.output.snapshots.size()) + columns * rows);
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
    for (SceneBody const& body : run.grid->bodies) {
      try {
        require_memory(window_cells(body), body_cell_bytes);
      } catch (std::invalid_argument const& error) {
        throw InputError(scene.file.string(), body.key + ".cell", error.what(),
                         "take larger cells, or a smaller extent");
      }
    }
  }
}

std::vector<BodyEstimate> body_estimates(SceneRun const& run) {
  std::vector<BodyEstimate> out;
  for (std::size_t n = 0; run.grid && n < run.grid->bodies.size(); ++n) {
    SceneBody const& body = run.grid->bodies[n];
    BodySetup const& setup = body.setup;
    BoundingBox const box = bounding_box(setup.surface);
    auto const lengths = edge_lengths(setup.surface);
    auto const [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    BodyEstimate e{.name = body.name, .lower = setup.lower, .upper = setup.upper, .from = box.lower, .to = box.upper};
    e.triangles = static_cast<double>(setup.surface.size());
    // a body under pressure is denser than its material without
    double const density = setup.rigid ? body.density : setup.initial(0.5 * (box.lower + box.upper)).rho;
    e.volume = enclosed(setup.surface, body.cut).volume, e.mass = density * e.volume;
    if (!setup.rigid) e.cells = e.volume / std::pow(setup.cell, 3), e.window = window_cells(body);
    e.shortest = *least / setup.cell, e.longest = *most / setup.cell;
    e.bytes = e.window * body_cell_bytes;
    out.push_back(e);
  }
  return out;
}

std::vector<RunEstimate> estimate(Scene const& scene, double budget_s) {
  std::vector<RunEstimate> out;
  for (SceneRun const& run : scene.runs) {
    RunEstimate e;
    e.name = run.name, e.cells = run.cells();
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
