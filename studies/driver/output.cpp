#include "studies/driver/output.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riemann/eos/factory.hpp"
#include "studies/driver/grid_output.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/output_parts.hpp"

namespace g27 {
namespace {

constexpr std::array ledger_entries{std::pair{"mass", &GasLedger::mass}, std::pair{"momentum", &GasLedger::momentum},
                                    std::pair{"energy", &GasLedger::energy}};

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

}  // namespace

void write_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run, RunRecord const& record,
               int threads) {
  if (run.grid) {
    write_grid_run(file, scene, run, record, threads);
    return;
  }
  Hdf5Writer out;
  write_heading(out, scene, run, record);
  out.attribute("/run", "symmetry", symmetry_names()[static_cast<std::size_t>(run.setup.symmetry)]);
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
  write_history(out, record.history);
  for (auto const& [name, entry] : ledger_entries) {
    write_ledger(out, name, record.restart.ledger.*entry);
  }
  write_counters(out, record.restart.counters);
  write_restart(out, record);
  write_provenance(out, scene, run, threads);
  out.save(file);
  write_atomically(file.parent_path() / (file.stem().string() + ".xdmf"), xdmf(file.filename().string(), record));
}

void check_resumable(std::filesystem::path const& file, Scene const& scene, SceneRun const& run) {
  Hdf5Reader const in(file);
  check_identity(in, file, scene, run);
  in.verify();
  if (run.grid) check_states(in, file);
}

RunRecord read_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run) {
  Hdf5Reader const in(file);
  check_identity(in, file, scene, run);
  RunRecord record(run);
  record.complete = in.number_attribute("/run", "complete") != 0;
  record.wall_s = in.number_attribute("/run", "wall_s");
  read_history(in, record.history);
  if (run.grid) {
    read_grid_run(in, run, record);
    return record;
  }
  for (std::size_t i = 0; in.has(state_path(i)); ++i) {
    std::string const path = state_path(i);
    record.snapshots.push_back({in.number_attribute(path, "time"), in.read(path + "/faces"), in.read(path + "/density"),
                                in.read(path + "/velocity"), in.read(path + "/pressure")});
  }
  if (in.has("/map/time")) {
    record.map = {in.read("/map/time"), in.read("/map/x"), in.read("/map/density"), in.read("/map/pressure"), 0};
    record.map.points = in.shape("/map/x").at(1);
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
    r.ledger.*entry = read_ledger(in, name);
  }
  read_counters(in, r.counters);
  return record;
}

}  // namespace g27
