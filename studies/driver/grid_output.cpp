#include "studies/driver/grid_output.hpp"

#include <fmt/format.h>

#include <array>

#include "studies/driver/body_ledger.hpp"
#include "studies/driver/body_output.hpp"
#include "studies/driver/output_parts.hpp"

namespace g27 {
namespace {

constexpr std::array momentum_names{"momentum_x", "momentum_y", "momentum_z"};
constexpr std::array averages{std::pair{"mass", "kg/m3"}, std::pair{"momentum_x", "kg/(m2 s)"},
                              std::pair{"momentum_y", "kg/(m2 s)"}, std::pair{"momentum_z", "kg/(m2 s)"},
                              std::pair{"energy", "J/m3"}};
constexpr std::array map_names{"switched", "cured", "repaired"};
constexpr std::array phase_fields{
    std::pair{"time", &LinePhase::time},      std::pair{"radius", &LinePhase::radius},
    std::pair{"cells", &LinePhase::cells},    std::pair{"steps", &LinePhase::steps},
    std::pair{"wall_s", &LinePhase::wall_s},  std::pair{"grid_steps", &LinePhase::grid_steps},
    std::pair{"missing", &LinePhase::missing}};
constexpr std::array size_fields{
    std::pair{"cells", &GridRecord::cells},
    std::pair{"cells_stored", &GridRecord::cells_stored},
    std::pair{"bytes", &GridRecord::bytes},
    std::pair{"tiles", &GridRecord::tiles},
    std::pair{"seen_updates", &GridRecord::seen_updates},
    std::pair{"seen_skipped", &GridRecord::seen_skipped},
};

constexpr std::array problem_fields{std::pair{"problems", &ProblemCounts::solved},
                                    std::pair{"problems_first_order", &ProblemCounts::first_order},
                                    std::pair{"problems_kept", &ProblemCounts::kept},
                                    std::pair{"problems_skipped", &ProblemCounts::skipped},
                                    std::pair{"cores_renewed", &ProblemCounts::renewed},
                                    std::pair{"vertices_untangled", &ProblemCounts::untangled},
                                    std::pair{"steps_tangled", &ProblemCounts::tangled},
                                    std::pair{"wall_s_local", &ProblemCounts::local_s},
                                    std::pair{"wall_s_gas", &ProblemCounts::gas_s},
                                    std::pair{"wall_s_bodies", &ProblemCounts::bodies_s},
                                    std::pair{"wall_s_geometry", &ProblemCounts::geometry_s},
                                    std::pair{"wall_s_interpolation", &ProblemCounts::interpolation_s}};

std::vector<std::uint64_t> grid_shape(SceneRun const& run) {
  auto const& n = run.grid->setup.cells;
  return {static_cast<std::uint64_t>(n[2]), static_cast<std::uint64_t>(n[1]), static_cast<std::uint64_t>(n[0])};
}

std::vector<double> faces(GasGridSetup const& setup, std::size_t d) {
  std::vector<double> out;
  for (int i = 0; i <= setup.cells[d]; ++i) {
    out.push_back(setup.lower[d] + (setup.upper[d] - setup.lower[d]) * i / setup.cells[d]);
  }
  return out;
}

std::string state_folder(std::filesystem::path const& file) { return file.stem().string() + ".state"; }
std::string state_file(std::size_t index) { return fmt::format("{:04}.h5", index); }

void write_restart(Hdf5Writer& out, SceneRun const& run, RunRecord const& record) {
  GridRestart const& r = record.grid->restart;
  out.group("/restart");
  out.attribute("/restart", "time", r.time);
  out.attribute("/restart", "next_history", record.history.totals.next);
  write_overset(out, r);
  for (std::size_t f = 0; f < map_names.size(); ++f) {
    if (!r.maps[f].empty()) {
      out.write(fmt::format("/restart/{}", map_names[f]), r.maps[f], "1", grid_shape(run));
    }
  }
  if (r.averages[0].empty()) {
    return;
  }
  for (std::size_t f = 0; f < averages.size(); ++f) {
    out.write(fmt::format("/restart/{}", averages[f].first), r.averages[f], averages[f].second, grid_shape(run));
  }
}

}  // namespace

void write_grid_state(std::filesystem::path const& file, SceneRun const& run, std::size_t index,
                      GridSnapshot const& state) {
  Hdf5Writer out;
  std::string const path = state_path(index);
  char const* const axes[] = {"x", "y", "z"};
  for (std::size_t d = 0; d < static_cast<std::size_t>(run.dimensions()); ++d) {
    out.write(fmt::format("{}/{}", path, axes[d]), faces(run.grid->setup, d), "m");
  }
  for (HistoryColumn const& field : state.fields) {
    out.write(fmt::format("{}/{}", path, field.name), field.values, field.unit, grid_shape(run));
  }
  write_bodies(out, path, run, state);
  out.attribute(path, "time", state.time);
  auto const folder = file.parent_path() / state_folder(file);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw OutputError(fmt::format("cannot create {}: {}", folder.string(), error.message()));
  }
  out.save(folder / state_file(index));
}

void write_grid_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run, RunRecord const& record,
                    int threads) {
  GridRecord const& grid = *record.grid;
  Hdf5Writer out;
  write_heading(out, scene, run, record);
  out.attribute("/run", "dimensions", static_cast<double>(run.dimensions()));
  for (auto const& [name, member] : size_fields) {
    out.attribute("/run", name, grid.*member);
  }
  out.attribute("/run", "begun", grid.begun ? 1.0 : 0.0);
  out.group("/line_phase");
  out.attribute("/line_phase", "ended_by", grid.line.ended_by);
  for (auto const& [name, member] : phase_fields) {
    out.attribute("/line_phase", name, grid.line.*member);
  }
  out.group("/state");
  for (std::size_t i = 0; i < grid.snapshot_times.size(); ++i) {
    out.external(state_path(i), state_folder(file) + "/" + state_file(i));
  }
  out.write("/times", grid.snapshot_times, "s");
  if (!run.grid->bodies.empty()) out.write("/surface_sizes", grid.surface_sizes, "1");
  write_history(out, record.history);
  write_ledger(out, "mass", grid.restart.ledger.mass);
  write_ledger(out, "energy", grid.restart.ledger.energy);
  for (std::size_t d = 0; d < 3; ++d) {
    write_ledger(out, momentum_names[d], grid.restart.ledger.momentum[d]);
  }
  write_body_ledgers(out, run, grid.restart);
  write_counters(out, grid.restart.counters);
  for (auto const& [name, member] : problem_fields) {
    if (!run.grid->bodies.empty()) out.attribute("/counters", name, grid.restart.problems.*member);
  }
  out.attribute("/counters", "cured", static_cast<double>(grid.restart.counters.cured));
  out.attribute("/counters", "cells_skipped", static_cast<double>(grid.restart.counters.cells_skipped));
  write_restart(out, run, record);
  write_provenance(out, scene, run, threads);
  out.save(file);
  write_atomically(file.parent_path() / (file.stem().string() + ".xdmf"), grid_xdmf(file.stem().string(), run, grid));
}

void check_states(Hdf5Reader const& in, std::filesystem::path const& file) {
  std::vector<double> const times = in.read("/times");
  for (std::size_t i = 0; i < times.size(); ++i) {
    auto const of_state = file.parent_path() / state_folder(file) / state_file(i);
    if (Hdf5Reader(of_state).number_attribute(state_path(i), "time") != times[i]) {
      throw OutputError(fmt::format("{} is the state of another run", of_state.string()));
    }
  }
}

void read_grid_run(Hdf5Reader const& in, SceneRun const& run, RunRecord& record) {
  GridRecord& grid = *record.grid;
  GridRestart& r = grid.restart;
  for (auto const& [name, member] : size_fields) {
    grid.*member = in.number_attribute("/run", name);
  }
  grid.begun = in.number_attribute("/run", "begun") != 0;
  grid.line.ended_by = in.text_attribute("/line_phase", "ended_by");
  for (auto const& [name, member] : phase_fields) {
    grid.line.*member = in.number_attribute("/line_phase", name);
  }
  grid.snapshot_times = in.read("/times");
  r.ledger.mass = read_ledger(in, "mass");
  r.ledger.energy = read_ledger(in, "energy");
  for (std::size_t d = 0; d < 3; ++d) {
    r.ledger.momentum[d] = read_ledger(in, momentum_names[d]);
  }
  if (!run.grid->bodies.empty()) {
    grid.surface_sizes = in.read("/surface_sizes");
    read_body_ledgers(in, run, r);
    read_overset(in, r);
    for (auto const& [name, member] : problem_fields) {
      r.problems.*member = in.number_attribute("/counters", name);
    }
  }
  read_counters(in, r.counters);
  r.counters.cured = static_cast<std::uint64_t>(in.number_attribute("/counters", "cured"));
  r.counters.cells_skipped = static_cast<std::uint64_t>(in.number_attribute("/counters", "cells_skipped"));
  r.time = in.number_attribute("/restart", "time");
  record.history.totals.next = in.number_attribute("/restart", "next_history");
  if (in.has("/restart/mass")) {
    for (std::size_t f = 0; f < averages.size(); ++f) {
      r.averages[f] = in.read(fmt::format("/restart/{}", averages[f].first));
    }
  }
  for (std::size_t f = 0; f < map_names.size(); ++f) {
    std::string const path = fmt::format("/restart/{}", map_names[f]);
    r.maps[f] = in.has(path) ? in.read(path) : std::vector<double>{};
  }
}

std::string grid_xdmf(std::string const& run_name, SceneRun const& run, GridRecord const& record) {
  std::vector<double> const& times = record.snapshot_times;
  std::size_t const bodies = run.grid->bodies.size();
  GasGridSetup const& s = run.grid->setup;
  Vec3 h{1, 1, 1};
  bool const solid = run.dimensions() == 3;
  for (std::size_t d = 0; d < (solid ? 3U : 2U); ++d) {
    h[d] = (s.upper[d] - s.lower[d]) / s.cells[d];
  }
  // A plane is a mesh of nodes nx x ny x 1: VTK takes its cells as rectangles, with one value a cell.
  std::string const nodes = fmt::format("{} {} {}", solid ? s.cells[2] + 1 : 1, s.cells[1] + 1, s.cells[0] + 1);
  std::string const cells = fmt::format("{} {} {}", s.cells[2], s.cells[1], s.cells[0]);
  std::vector<std::string> fields{"density", "velocity_x", "velocity_y", "pressure"};
  if (solid) {
    fields.insert(fields.begin() + 3, "velocity_z");
  }
  if (s.options.maps) {
    fields.insert(fields.end(), map_names.begin(), map_names.end());
  }
  if (bodies > 0) {
    fields.emplace_back("gas_fraction");
  }
  std::string out =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (bodies > 0) {
      out += fmt::format("<Grid Name=\"state {}\" GridType=\"Collection\" CollectionType=\"Spatial\">\n", i);
    }
    out += fmt::format(
        "<Grid Name=\"state {}\">\n<Time Value=\"{}\"/>\n<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{}\"/>\n"
        "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n<DataItem Format=\"XML\" Dimensions=\"3\">{} {} {}</DataItem>\n"
        "<DataItem Format=\"XML\" Dimensions=\"3\">{} {} {}</DataItem>\n</Geometry>\n",
        i, times[i], nodes, solid ? s.lower[2] : 0.0, s.lower[1], s.lower[0], h[2], h[1], h[0]);
    for (std::string const& field : fields) {
      out += fmt::format(
          "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Cell\">\n<DataItem Format=\"HDF\" "
          "NumberType=\"Float\" Precision=\"8\" Dimensions=\"{1}\">{2}.state/{3}:{4}/{0}</DataItem>\n</Attribute>\n",
          field, cells, run_name, state_file(i), state_path(i));
    }
    out += "</Grid>\n";
    if (bodies > 0) {
      std::string const data = fmt::format("{}.state/{}:{}", run_name, state_file(i), state_path(i));
      out += body_xdmf(run, record.surface_sizes.data() + 2 * bodies * i, data) + "</Grid>\n";
    }
  }
  return out + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace g27
