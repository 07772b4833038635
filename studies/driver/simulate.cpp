#include "studies/driver/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "studies/driver/failure_capsule.hpp"
#include "studies/driver/grid_simulate.hpp"

namespace g27 {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<double> copy(std::span<double const> values) { return {values.begin(), values.end()}; }

GasLine resumed_line(SceneRun const& run, Restart const& restart) {
  GasLineSetup setup = run.setup;
  setup.faces = restart.faces;
  if (setup.motion.kind == MeshMotion::Kind::prescribed) {
    // The line takes its faces for those at t = 0: lead each back to where it truly started.
    setup.motion.position = [now = restart.faces, start = run.setup.faces, position = run.setup.motion.position](
                                double x, double t) {
      auto const face = std::lower_bound(now.begin(), now.end(), x) - now.begin();
      return position(start[static_cast<std::size_t>(face)], t);
    };
  }
  GasLine line(setup);
  std::vector<GasConserved<>> averages(restart.mass.size());
  for (std::size_t i = 0; i < averages.size(); ++i) {
    averages[i] = {restart.mass[i], restart.momentum[i], restart.energy[i]};
  }
  line.set_averages(averages, restart.time);
  return line;
}

/// The state to resume from: totals of the earlier pieces (`before`) plus those of this line.
Restart capture(GasLine const& line, Restart const& before) {
  Restart now = before;
  now.time = line.time();
  now.faces = copy(line.faces());
  for (auto* column : {&now.mass, &now.momentum, &now.energy}) {
    column->resize(line.cells());
  }
  for (std::size_t i = 0; i < line.cells(); ++i) {
    auto const average = line.average(i);
    now.mass[i] = average.mass, now.momentum[i] = average.momentum, now.energy[i] = average.energy;
  }
  auto const switched = line.switch_map();
  now.switched.resize(switched.size(), 0.0);
  std::transform(switched.begin(), switched.end(), now.switched.begin(), now.switched.begin(), std::plus<>{});
  GasCounters const& c = line.counters();
  GasCounters& total = now.counters;
  total.steps += c.steps, total.faces += c.faces, total.cell_updates += c.cell_updates, total.switched += c.switched;
  total.linear_star += c.linear_star, total.repaired += c.repaired, total.floored += c.floored;
  total.retried += c.retried;
  GasLedger const ledger = line.ledger();
  if (before.faces.empty()) {
    now.ledger = ledger;
  } else {
    add(now.ledger.mass, ledger.mass);
    add(now.ledger.momentum, ledger.momentum);
    add(now.ledger.energy, ledger.energy);
  }
  return now;
}

Snapshot snapshot(GasLine const& line) {
  return {line.time(), copy(line.faces()), copy(line.density()), copy(line.velocity()), copy(line.pressure())};
}

void add_slice(SpaceTimeMap& map, GasLine const& line) {
  constexpr std::size_t most_points = 600;
  std::size_t const stride = (line.cells() + most_points - 1) / most_points;
  map.time.push_back(line.time());
  map.points = 0;
  for (std::size_t i = stride / 2; i < line.cells(); i += stride, ++map.points) {
    map.x.push_back((line.faces()[i] + line.faces()[i + 1]) / 2);
    map.density.push_back(line.density()[i]);
    map.pressure.push_back(line.pressure()[i]);
  }
}

}  // namespace

GasLine make_line(SceneRun const& run) {
  GasLine line(run.setup);
  line.set_state(run.initial);
  if (run.start > 0) {
    std::vector<GasConserved<>> averages(line.cells());
    for (std::size_t i = 0; i < averages.size(); ++i) {
      averages[i] = line.average(i);
    }
    line.set_averages(averages, run.start);
  }
  return line;
}

void simulate(SceneRun const& run, RunRecord& record, RunHooks const& hooks) {
  if (record.complete) {
    return;
  }
  if (run.grid) {
    simulate_grid(run, record, hooks);
    return;
  }
  bool const fresh = record.restart.faces.empty();
  Restart const before = record.restart;
  GasLine line = fresh ? make_line(run) : resumed_line(run, before);
  if (fresh) {
    record.history.record(line, run.output, 0, false);
    record.snapshots.push_back(snapshot(line));
    if (run.output.map_times > 0) {
      add_slice(record.map, line);
    }
  }
  double const slice = run.output.map_times > 0 ? (run.end - run.start) / run.output.map_times : 0;
  auto const next_slice = [&] { return run.start + slice * static_cast<double>(record.map.time.size()); };
  auto const began = Clock::now();
  double const wall_before = record.wall_s;
  double reported = 0, saved = 0;
  auto const capture_here = [&] {
    record.restart = capture(line, before);
    record.wall_s = wall_before + seconds_since(began);
  };
  while (line.time() < run.end) {
    double const stop = run.output.snapshots[record.snapshots.size()];
    StepReport report = line.step(stop);
    if (report.status == StepStatus::ok && line.stable_dt() < least_step * (run.end - run.start)) {
      report.status = StepStatus::time_step_vanished;
    }
    if (report.status != StepStatus::ok) {
      capture_here();
      throw RunFailure(
          fmt::format("{}: {} in cell {} at t = {:.6g} s (step {})", run.name, step_status_text(report.status),
                      report.cell, line.time(), record.restart.counters.steps),
          failure_capsule(run, line, report));
    }
    record.history.record(line, run.output, report.dt, line.time() >= run.end);
    if (line.time() >= stop) {
      record.snapshots.push_back(snapshot(line));
    }
    if (slice > 0 && line.time() >= next_slice()) {
      add_slice(record.map, line);
    }
    double const elapsed = seconds_since(began);
    if (elapsed - reported > 0.1) {
      reported = elapsed;
      hooks.progress((line.time() - run.start) / (run.end - run.start));
    }
    if (line.time() < run.end && (elapsed - saved > hooks.checkpoint_s || hooks.interrupted())) {
      saved = elapsed;
      capture_here();
      hooks.checkpoint(record);
      if (hooks.interrupted()) {
        return;
      }
    }
  }
  capture_here();
  record.complete = true;
}

std::string step_status_text(StepStatus status) {
  switch (status) {
    case StepStatus::ok:
      return "ok";
    case StepStatus::inadmissible_state:
      return "inadmissible state";
    case StepStatus::mesh_tangled:
      return "mesh tangled";
    case StepStatus::time_step_vanished:
      return fmt::format("time step below {:g} of the run's duration (end it sooner, or take larger cells)",
                         least_step);
  }
  return "unknown status";
}

}  // namespace g27
