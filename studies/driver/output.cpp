#include "studies/driver/output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "riemann/eos/factory.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/provenance.hpp"

namespace g27 {
namespace {

constexpr std::array counter_fields{std::pair{"steps", &GasCounters::steps},
                                    std::pair{"faces", &GasCounters::faces},
                                    std::pair{"cell_updates", &GasCounters::cell_updates},
                                    std::pair{"switched", &GasCounters::switched},
                                    std::pair{"linear_star", &GasCounters::linear_star},
                                    std::pair{"repaired", &GasCounters::repaired},
                                    std::pair{"floored", &GasCounters::floored},
                                    std::pair{"retried", &GasCounters::retried}};

constexpr std::array ledger_fields{std::pair{"initial", &LedgerEntry::initial},
                                   std::pair{"current", &LedgerEntry::current},
                                   std::pair{"through_boundary", &LedgerEntry::through_boundary},
                                   std::pair{"from_source", &LedgerEntry::from_source},
                                   std::pair{"from_floor", &LedgerEntry::from_floor},
                                   std::pair{"scale", &LedgerEntry::scale}};

constexpr std::array ledger_entries{std::pair{"mass", &GasLedger::mass}, std::pair{"momentum", &GasLedger::momentum},
                                    std::pair{"energy", &GasLedger::energy}};

/// A record can be resumed only by the same run: scene text, overrides and the name (variant and scheme) fix it.
std::string identity(Scene const& scene, SceneRun const& run) {
  return fmt::format("{}\n{}\n{}", run.name, fmt::join(scene.overrides, "\n"), scene.text);
}

std::string state_path(std::size_t i) { return fmt::format("/state/{:04}", i); }

void write_restart(Hdf5Writer& out, RunRecord const& record) {
  Restart const& r = record.restart;
  auto const& totals = record.history.totals;
  out.write("/restart/faces", r.faces, "m");
  out.write("/restart/mass", r.mass, "kg/m3");
  out.write("/restart/momentum", r.momentum, "kg/(m2 s)");
  out.write("/restart/energy", r.energy, "J/m3");
  out.write("/restart/switched", r.switched, "1");
  out.attribute("/restart", "time", r.time);
  out.attribute("/restart", "left_impulse", totals.left_impulse);
  out.attribute("/restart", "right_impulse", totals.right_impulse);
  out.attribute("/restart", "next_history", totals.next);
}

void write_provenance(Hdf5Writer& out, Scene const& scene, SceneRun const& run, int threads) {
  for (auto const& [name, value] : provenance(threads)) {
    out.write_text("/provenance/" + name, value);
  }
  out.write_text("/provenance/scene", scene.text);
  out.write_text("/provenance/overrides", fmt::format("{}", fmt::join(scene.overrides, "\n")));
  out.write_text("/provenance/identity", identity(scene, run));
}

}  // namespace

void write_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run, RunRecord const& record,
               int threads) {
  Hdf5Writer out;
  out.group("/run");
  out.attribute("/run", "title", scene.title);
  out.attribute("/run", "name", run.name);
  out.attribute("/run", "variant", run.variant);
  out.attribute("/run", "scheme", run.scheme);
  out.attribute("/run", "eos", eos_name(run.setup.eos));
  out.attribute("/run", "symmetry", symmetry_names()[static_cast<std::size_t>(run.setup.symmetry)]);
  out.attribute("/run", "complete", record.complete ? 1.0 : 0.0);
  out.attribute("/run", "wall_s", record.wall_s);
  for (std::size_t i = 0; i < record.snapshots.size(); ++i) {
    Snapshot const& s = record.snapshots[i];
    out.write(state_path(i) + "/faces", s.faces, "m");
    out.write(state_path(i) + "/density", s.density, "kg/m3");
    out.write(state_path(i) + "/velocity", s.velocity, "m/s");
    out.write(state_path(i) + "/pressure", s.pressure, "Pa");
    out.attribute(state_path(i), "time", s.time);
  }
  SpaceTimeMap const& map = record.map;
  if (!map.time.empty()) {
    std::vector<std::uint64_t> const shape{map.time.size(), map.points};
    out.write("/map/time", map.time, "s");
    out.write("/map/x", map.x, "m", shape);
    out.write("/map/density", map.density, "kg/m3", shape);
    out.write("/map/pressure", map.pressure, "Pa", shape);
  }
  for (auto const& column : record.history.columns()) {
    out.write("/history/" + column.name, column.values, column.unit);
  }
  for (auto const& [name, entry] : ledger_entries) {
    std::string const path = fmt::format("/ledger/{}", name);
    out.group(path);
    for (auto const& [field, member] : ledger_fields) {
      out.attribute(path, field, record.restart.ledger.*entry.*member);
    }
    out.attribute(path, "residual", (record.restart.ledger.*entry).residual());
  }
  out.group("/counters");
  for (auto const& [name, member] : counter_fields) {
    out.attribute("/counters", name, static_cast<double>(record.restart.counters.*member));
  }
  write_restart(out, record);
  write_provenance(out, scene, run, threads);
  out.save(file);
  write_atomically(file.parent_path() / (file.stem().string() + ".xdmf"), xdmf(file.filename().string(), record));
}

RunRecord read_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run) {
  Hdf5Reader const in(file);
  if (in.read_text("/provenance/identity") != identity(scene, run)) {
    throw InputError(file.string(), "--resume", "was written by another scene or with other settings",
                     "restore the scene and --set as they were, or run without --resume");
  }
  RunRecord record(run);
  record.complete = in.number_attribute("/run", "complete") != 0;
  record.wall_s = in.number_attribute("/run", "wall_s");
  for (std::size_t i = 0; in.has(state_path(i)); ++i) {
    std::string const path = state_path(i);
    record.snapshots.push_back({in.number_attribute(path, "time"), in.read(path + "/faces"), in.read(path + "/density"),
                                in.read(path + "/velocity"), in.read(path + "/pressure")});
  }
  if (in.has("/map/time")) {
    record.map = {in.read("/map/time"), in.read("/map/x"), in.read("/map/density"), in.read("/map/pressure"), 0};
    record.map.points = in.shape("/map/x").at(1);
  }
  for (auto& column : record.history.columns()) {
    column.values = in.read("/history/" + column.name);
  }
  record.history.totals = {in.number_attribute("/restart", "left_impulse"),
                           in.number_attribute("/restart", "right_impulse"),
                           in.number_attribute("/restart", "next_history")};
  Restart& r = record.restart;
  r.time = in.number_attribute("/restart", "time");
  r.faces = in.read("/restart/faces");
  r.mass = in.read("/restart/mass");
  r.momentum = in.read("/restart/momentum");
  r.energy = in.read("/restart/energy");
  r.switched = in.read("/restart/switched");
  for (auto const& [name, entry] : ledger_entries) {
    for (auto const& [field, member] : ledger_fields) {
      r.ledger.*entry.*member = in.number_attribute(fmt::format("/ledger/{}", name), field);
    }
  }
  for (auto const& [name, member] : counter_fields) {
    r.counters.*member = static_cast<std::uint64_t>(in.number_attribute("/counters", name));
  }
  return record;
}

}  // namespace g27
