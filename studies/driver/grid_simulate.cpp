#include "studies/driver/grid_simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include "scheme/step/map_line_to_grid.hpp"
#include "studies/driver/failure_capsule.hpp"
#include "studies/driver/grid_history.hpp"
#include "studies/driver/grid_mesh.hpp"
#include "studies/driver/input_error.hpp"

namespace g27 {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

GridBox box_of(GasGridSetup const& setup) { return {setup.lower, setup.upper, setup.cells}; }

double widest(GasGridSetup const& setup) {
  double h = 0;
  for (std::size_t d = 0; d < (setup.cells[2] > 1 ? 3U : 2U); ++d) {
    h = std::max(h, (setup.upper[d] - setup.lower[d]) / setup.cells[d]);
  }
  return h;
}

GridSnapshot snapshot(GasGrid const& grid, bool maps) {
  using Field = GasGrid::Field;
  GridSnapshot out{.time = grid.time(), .fields = {}, .bodies = {}};
  out.fields.push_back({"density", "kg/m3", grid.field(Field::density)});
  out.fields.push_back({"velocity_x", "m/s", grid.field(Field::velocity_x)});
  out.fields.push_back({"velocity_y", "m/s", grid.field(Field::velocity_y)});
  if (grid.cells()[2] > 1) {
    out.fields.push_back({"velocity_z", "m/s", grid.field(Field::velocity_z)});
  }
  out.fields.push_back({"pressure", "Pa", grid.field(Field::pressure)});
  if (maps) {
    out.fields.push_back({"switched", "1", grid.field(Field::switched)});
    out.fields.push_back({"cured", "1", grid.field(Field::cured)});
    out.fields.push_back({"repaired", "1", grid.field(Field::repaired)});
  }
  return out;
}

/// Counts per cell, with those of earlier pieces.
void capture_maps(GasGrid const& grid, GridRestart const& before, GridRestart& now) {
  GasGrid::Field const fields[] = {GasGrid::Field::switched, GasGrid::Field::cured, GasGrid::Field::repaired};
  for (std::size_t f = 0; f < 3; ++f) {
    now.maps[f] = grid.field(fields[f]);
    if (!before.maps[f].empty()) {
      std::transform(now.maps[f].begin(), now.maps[f].end(), before.maps[f].begin(), now.maps[f].begin(),
                     std::plus<>{});
    }
  }
}

/// The pieces of a run that the phases share.
class GridSimulation {
 public:
  GridSimulation(SceneRun const& run, RunRecord& record, RunHooks const& hooks)
      : run_(run), plan_(*run.grid), record_(record), state_(*record.grid), hooks_(hooks), mesh_(make_mesh(run)) {
    state_.cells = static_cast<double>(grid().cell_count());
    state_.tiles = static_cast<double>(grid().tile_count());
  }

  void run() {
    before_ = state_.restart;
    wall_before_ = record_.wall_s;
    if (state_.begun) {
      resume();
    } else if (!start()) {
      return;
    }
    advance();
  }

 private:
  [[nodiscard]] GasGrid const& grid() const { return mesh_->gas(); }

  void resume() {
    mesh_->resume(before_);
    resumed_ = true;
  }

  /// From the initial data, through the line where there is one. False: interrupted on the way.
  bool start() {
    // A record of an earlier process that never reached the grid starts over.
    record_ = RunRecord(run_);
    record_.wall_s = wall_before_;
    state_.cells = static_cast<double>(grid().cell_count());
    state_.tiles = static_cast<double>(grid().tile_count());
    if (plan_.line && !line_phase()) {
      return false;
    }
    if (!plan_.line) {
      mesh_->start([&](Int3 const& c) { return plan_.initial(grid().centre(c), grid().widths()); }, plan_.point,
                   run_.start);
    }
    state_.begun = true;
    record_row(*mesh_->view(), mesh_->time(), 0, true, false);
    if (!plan_.line) {
      keep_snapshot();
    }
    return true;
  }

  bool line_phase() {
    LineStart const& start = *plan_.line;
    GasLine line = make_start_line(start, run_.start);
    LinePhase& phase = state_.line;
    phase.cells = static_cast<double>(line.cells());
    auto const began = Clock::now();
    LineFieldView const view(line, start.centre, run_.dimensions());
    auto const map_now = [&] {
      LineToGrid const map(line, start.centre, box_of(plan_.setup));
      mesh_->start([&](Int3 const& c) { return map(c); }, [&](Vec3 const& x) { return view.at(x); }, line.time());
      phase.radius = map.radius(), phase.missing = map.missing();
    };
    map_now();
    record_row(view, line.time(), 0, false, false);
    keep_snapshot();
    while (!line_phase_over(start, plan_.setup, line, phase) && line.time() < run_.end) {
      StepReport const report = line.step(std::min(start.until, next_snapshot()));
      if (report.status != StepStatus::ok) {
        SceneRun of_line = run_;
        of_line.setup = start.setup;
        throw RunFailure(fmt::format("{}: {} in cell {} of the line of the first phase at t = {:.6g} s", run_.name,
                                     step_status_text(report.status), report.cell, line.time()),
                         failure_capsule(of_line, line, report));
      }
      record_row(view, line.time(), report.dt, false, false);
      if (line.time() >= next_snapshot()) {
        map_now();
        keep_snapshot();
      }
      report_progress(line.time());
      if (hooks_.interrupted()) {
        return false;
      }
    }
    phase.ended_by = phase.ended_by.empty() ? "end" : phase.ended_by;
    map_now();
    phase.time = line.time();
    phase.steps = static_cast<double>(line.counters().steps);
    // At least: steps go with the cells, and the grid's CFL condition counts every direction.
    phase.grid_steps = phase.steps * (line.faces()[1] - line.faces()[0]) / widest(plan_.setup);
    phase.wall_s = seconds_since(began);
    return true;
  }

  void advance() {
    double saved = seconds_since(began_);
    while (mesh_->time() < run_.end) {
      double const stop = next_snapshot();
      GridStepReport report = mesh_->step(stop);
      if (std::string const trouble = mesh_->trouble(); !trouble.empty()) {
        mesh_->capture_totals(before_, resumed_, state_.restart);
        throw RunFailure(fmt::format("{}: {} at t = {:.6g} s (step {})", run_.name, trouble, mesh_->time(),
                                     state_.restart.counters.steps),
                         failure_capsule(run_, trouble, mesh_->time()));
      }
      if (report.status == StepStatus::ok && mesh_->stable_dt() < least_step * (run_.end - run_.start)) {
        report.status = StepStatus::time_step_vanished;
      }
      if (report.status != StepStatus::ok) {
        mesh_->capture_totals(before_, resumed_, state_.restart);
        auto const& c = report.cell;
        throw RunFailure(fmt::format("{}: {} in cell ({}, {}, {}) at t = {:.6g} s (step {})", run_.name,
                                     step_status_text(report.status), c[0], c[1], c[2], mesh_->time(),
                                     state_.restart.counters.steps),
                         failure_capsule(run_, grid(), report));
      }
      record_row(*mesh_->view(), mesh_->time(), report.dt, true, mesh_->time() >= run_.end);
      if (mesh_->time() >= stop) {
        keep_snapshot();
      }
      report_progress(mesh_->time());
      double const elapsed = seconds_since(began_);
      bool const stopping = hooks_.interrupted();
      if (mesh_->time() < run_.end && (elapsed - saved > hooks_.checkpoint_s || stopping)) {
        saved = elapsed;
        mesh_->capture_totals(before_, resumed_, state_.restart);
        mesh_->capture_state(state_.restart);
        if (plan_.setup.options.maps) {
          capture_maps(grid(), before_, state_.restart);
        }
        record_.wall_s = wall_before_ + elapsed;
        hooks_.checkpoint(record_);
        if (stopping) {
          return;
        }
      }
    }
    mesh_->capture_totals(before_, resumed_, state_.restart);
    state_.restart.overset.clear();
    for (auto& field : state_.restart.averages) {
      field.clear();
    }
    record_.wall_s = wall_before_ + seconds_since(began_);
    record_.complete = true;
  }

  [[nodiscard]] double next_snapshot() const { return run_.output.snapshots[state_.snapshot_times.size()]; }

  void keep_snapshot() {
    GridSnapshot shot = snapshot(grid(), plan_.setup.options.maps);
    for (std::size_t f = 0; resumed_ && f < 3; ++f) {  // counts of the earlier pieces
      if (!before_.maps[f].empty()) {
        auto& values = shot.fields[shot.fields.size() - 3 + f].values;
        std::transform(values.begin(), values.end(), before_.maps[f].begin(), values.begin(), std::plus<>{});
      }
    }
    mesh_->complete(shot);
    for (BodySnapshot const& body : shot.bodies) {
      state_.surface_sizes.push_back(static_cast<double>(body.vertices.size() / 3));
      state_.surface_sizes.push_back(static_cast<double>(body.pressure.size()));
    }
    if (hooks_.snapshot) {
      hooks_.snapshot(state_.snapshot_times.size(), shot);
    }
    state_.snapshot_times.push_back(mesh_->time());
  }

  void record_row(GridView const& view, double time, double dt, bool on_grid, bool last) {
    GridRowFacts facts{.time = time, .dt = dt, .total_mass = none, .total_energy = none};
    if (on_grid) {
      auto const stored = static_cast<double>(grid().cells_stored());
      state_.cells_stored = std::max(state_.cells_stored, stored);
      state_.bytes = std::max(state_.bytes, mesh_->bytes());
      facts.stored_share = stored / state_.cells;
    }
    if (!record_.history.due(time, run_.output.history_every, last)) {
      return;
    }
    if (on_grid) {
      auto const updates = static_cast<double>(before_.counters.cell_updates + grid().counters().cell_updates);
      auto const skipped = static_cast<double>(before_.counters.cells_skipped + grid().counters().cells_skipped);
      double const done = updates - state_.seen_updates, left_out = skipped - state_.seen_skipped;
      facts.active_share = done + left_out > 0 ? done / (done + left_out) : 1.0;
      state_.seen_updates = updates, state_.seen_skipped = skipped;
      std::tie(facts.total_mass, facts.total_energy) = mesh_->totals();
    }
    std::vector<double> row = grid_row(view, plan_, run_.output, facts);
    mesh_->complete(row);
    record_.history.append(row);
  }

  void report_progress(double time) {
    double const elapsed = seconds_since(began_);
    if (elapsed - reported_ > 0.1) {
      reported_ = elapsed;
      hooks_.progress((time - run_.start) / (run_.end - run_.start));
    }
  }

  SceneRun const& run_;
  GridRun const& plan_;
  RunRecord& record_;
  GridRecord& state_;
  RunHooks const& hooks_;
  std::unique_ptr<GridMesh> mesh_;
  GridRestart before_;
  bool resumed_ = false;
  double wall_before_ = 0, reported_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

GasGrid make_grid(SceneRun const& run) {
  try {
    return GasGrid(run.grid->setup);
  } catch (std::invalid_argument const& flaw) {
    throw InputError(run.name, "domain", flaw.what(), "correct the scene");
  }
}

GasLine make_start_line(LineStart const& start, double time) {
  GasLine line(start.setup);
  line.set_averages(start.averages, time);
  return line;
}

bool line_phase_over(LineStart const& start, GasGridSetup const& grid, GasLine const& line, LinePhase& phase) {
  if (line.time() < start.earliest) {
    return false;
  }
  double const front = disturbed_radius(line);
  // One step moves the wave's foot by a cell or two of the line, which are finer than those of the grid.
  bool const obstacle = front + 2 * widest(grid) >= start.clearance;
  phase.ended_by = line.time() >= start.until ? "time" : front >= start.radius ? "radius" : obstacle ? "obstacle" : "";
  return !phase.ended_by.empty();
}

void simulate_grid(SceneRun const& run, RunRecord& record, RunHooks const& hooks) {
  GridSimulation(run, record, hooks).run();
}

}  // namespace g27
