/// Runs on grids through the program's own path: what the files hold, resuming, skipping, the first phase on a line.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"
#include "tests/run_in_pieces.hpp"

namespace fs = std::filesystem;

namespace {

char const* const blast = R"(title = "blast"
[time]
end = "0.3 s"
[scheme]
order = 2
tile = [8, 8, 8]
[domain]
extent = [["0 m", "1 m"], ["0 m", "0.75 m"], ["0 m", "0.5 m"]]
cells = [32, 24, 16]
boundary = { x_low = "symmetry", y_low = "symmetry", z_low = "symmetry", others = "outflow" }
[material.gas]
eos = { type = "ideal", gamma = 1.4 }
[ambient]
density = "1 kg/m3"
pressure = "0.1 Pa"
[[region]]
shape = "sphere"
center = ["0 m", "0 m", "0 m"]
radius = "0.15 m"
density = "1 kg/m3"
pressure = "5 Pa"
[output]
snapshots = ["0.05 s", "0.2 s"]
every = "0.01 s"
threshold = "0.2 Pa"
repairs = true
probe = [{ name = "mid", position = ["0.3 m", "0 m", "0 m"] }]
)";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("g27-grid-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

g27::Scene read(Folder const& folder, std::vector<std::string> const& set = {}) {
  std::ofstream(folder.path / "scene.toml") << blast;
  return g27::read_scene(folder.path / "scene.toml", set);
}

void check_same_files(fs::path const& a, fs::path const& b, std::vector<std::string> const& but_not = {}) {
  g27::Hdf5Reader const x(a), y(b);
  auto const times = x.read("/times");
  CHECK(times == y.read("/times"));
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::string const state = "/state/000" + std::to_string(i);
    for (std::string const& field : x.names(state)) {
      INFO(state << "/" << field);
      CHECK(x.read(state + "/" + field) == y.read(state + "/" + field));
    }
  }
  for (std::string const& column : x.names("/history")) {
    if (column == "probe" || column == "shock" || std::find(but_not.begin(), but_not.end(), column) != but_not.end()) {
      continue;
    }
    INFO(column);
    auto const u = x.read("/history/" + column), v = y.read("/history/" + column);
    CHECK(std::equal(u.begin(), u.end(), v.begin(), v.end(),
                     [](double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); }));
  }
  CHECK(x.read("/history/probe/mid/pressure") == y.read("/history/probe/mid/pressure"));
}

}  // namespace

TEST_CASE("the files of a grid hold its states, history, ledger and origin", "[grid-run]") {
  Folder const folder;
  g27::Scene const scene = read(folder);
  fs::path const file = folder.path / "a.h5";
  g27::RunRecord const record = run_in_pieces(scene, file, 0);
  CHECK(record.grid->snapshot_times == std::vector<double>{0, 0.05, 0.2, 0.3});
  g27::Hdf5Reader const in(file);
  for (char const* field : {"density", "velocity_x", "velocity_y", "velocity_z", "pressure", "switched", "cured"}) {
    CHECK(in.shape(std::string("/state/0003/") + field) == std::vector<std::uint64_t>{16, 24, 32});
  }
  CHECK(in.read("/state/0000/x").size() == 33);
  CHECK(in.text_attribute("/state/0002/pressure", "units") == "Pa");
  CHECK(in.number_attribute("/state/0002", "time") == 0.2);
  // x runs fastest, and the ball lies in the corner
  auto const p = in.read("/state/0000/pressure");
  CHECK(p[0] == Approx(5).epsilon(1e-12));
  CHECK(p[31] == Approx(0.1).epsilon(1e-12));
  CHECK(p[32 * 23] == Approx(0.1).epsilon(1e-12));
  auto const rho = in.read("/state/0003/density");
  double const cell = 1.0 / 32 * 0.75 / 24 * 0.5 / 16;
  CHECK(std::accumulate(rho.begin(), rho.end(), 0.0) * cell == Approx(in.read("/history/total_mass").back()));
  CHECK(std::fabs(in.number_attribute("/ledger/energy", "residual")) < 1e-14);
  CHECK(std::fabs(in.number_attribute("/ledger/mass", "residual")) < 1e-14);
  CHECK(in.number_attribute("/counters", "cell_updates") > 0);
  CHECK(in.read_text("/provenance/scene") == scene.text);
  CHECK_FALSE(in.has("/restart/mass"));  // nothing left to resume
  CHECK(fs::exists(folder.path / "a.xdmf"));
  CHECK_FALSE(in.read("/history/shock/diagonal").empty());
}

TEST_CASE("resuming on a grid changes no bit", "[grid-run]") {
  Folder const folder;
  for (std::vector<std::string> const& set :
       {std::vector<std::string>{}, {"start={one_dimensional_radius=\"0.3 m\"}"}, {"scheme.order=3"}}) {
    g27::Scene const scene = read(folder, set);
    g27::RunRecord const whole = run_in_pieces(scene, folder.path / "a.h5", 0);
    g27::RunRecord const pieces = run_in_pieces(scene, folder.path / "b.h5", 11);
    CHECK(whole.counters().steps == pieces.counters().steps);
    CHECK(whole.counters().switched == pieces.counters().switched);
    check_same_files(folder.path / "a.h5", folder.path / "b.h5", {"active_share", "stored_share"});
  }
}

TEST_CASE("a damaged state is found before a run goes on", "[grid-run]") {
  Folder const folder;
  g27::Scene const scene = read(folder, {"time.end=0.06 s", "output.snapshots=[\"0.05 s\"]"});
  fs::path const file = folder.path / "a.h5", state = folder.path / "a.state/0001.h5";
  (void)run_in_pieces(scene, file, 0);
  CHECK_NOTHROW(g27::check_resumable(file, scene, scene.runs[0]));
  fs::resize_file(state, fs::file_size(state) - 1);
  CHECK_THROWS_AS(g27::check_resumable(file, scene, scene.runs[0]), g27::OutputError);
  fs::copy_file(folder.path / "a.state/0002.h5", state, fs::copy_options::overwrite_existing);
  CHECK_THROWS_AS(g27::check_resumable(file, scene, scene.runs[0]), g27::OutputError);
}

TEST_CASE("skipping uniform tiles changes no bit", "[grid-run]") {
  Folder const folder;
  std::vector<std::string> set{"time.end=0.1 s", "output.snapshots=[\"0.05 s\"]"};
  g27::RunRecord const on = run_in_pieces(read(folder, set), folder.path / "a.h5", 0);
  set.emplace_back("skip=off");
  g27::RunRecord const off = run_in_pieces(read(folder, set), folder.path / "b.h5", 0);
  check_same_files(folder.path / "a.h5", folder.path / "b.h5", {"active_share", "stored_share"});
  CHECK(off.grid->restart.counters.cells_skipped == 0);
  g27::Saved const saved = g27::saved_by(*on.grid);
  CHECK(saved.skipped_share > 0.1);
  CHECK(saved.factor == Approx(1 / (1 - saved.skipped_share)));
}

TEST_CASE("a first phase on a line keeps mass and energy, and is told", "[grid-run]") {
  Folder const folder;
  g27::Scene const scene = read(folder, {"start={one_dimensional_radius=\"0.4 m\"}"});
  g27::RunRecord const record = run_in_pieces(scene, folder.path / "a.h5", 0);
  CHECK(record.grid->line.ended_by == "radius");
  CHECK(record.grid->line.radius == Approx(0.4).margin(0.02));
  CHECK(record.grid->line.steps > 10);
  CHECK(record.grid->line.grid_steps > 1);
  // the octant's exact content: the ball's own volume, not that of its cells
  double const ball = 3.14159265358979 / 6 * std::pow(0.15, 3);
  CHECK(record.grid->restart.ledger.energy.initial == Approx((0.1 * 0.375 + 4.9 * ball) / 0.4).epsilon(1e-12));
  CHECK(record.grid->restart.ledger.mass.initial == Approx(0.375).epsilon(1e-12));
  g27::Scene const tight = read(folder, {"start={one_dimensional_until=\"0.29 s\"}"});
  CHECK(run_in_pieces(tight, folder.path / "b.h5", 0).grid->line.ended_by == "obstacle");
}

TEST_CASE("a plane is a grid of two dimensions, with its own first phase", "[grid-run]") {
  Folder const folder;
  std::string text = blast;
  auto const replace = [&](std::string const& from, std::string const& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace(", [\"0 m\", \"0.5 m\"]]", "]");
  replace("cells = [32, 24, 16]", "cells = [32, 24]");
  replace("tile = [8, 8, 8]", "tile = [8, 8]");
  replace(", z_low = \"symmetry\"", "");
  replace("center = [\"0 m\", \"0 m\", \"0 m\"]", "center = [\"0 m\", \"0 m\"]");
  replace("position = [\"0.3 m\", \"0 m\", \"0 m\"]", "position = [\"0.3 m\", \"0 m\"]");
  text += "[start]\none_dimensional_radius = \"0.3 m\"\n";
  std::ofstream(folder.path / "plane.toml") << text;
  g27::Scene const scene = g27::read_scene(folder.path / "plane.toml", {});
  CHECK(scene.runs[0].dimensions() == 2);
  CHECK(scene.runs[0].grid->line->setup.symmetry == g27::Symmetry::cylindrical);
  g27::RunRecord const record = run_in_pieces(scene, folder.path / "a.h5", 0);
  g27::Hdf5Reader const in(folder.path / "a.h5");
  CHECK(in.shape("/state/0003/density") == std::vector<std::uint64_t>{1, 24, 32});
  CHECK_FALSE(in.has("/history/shock/z"));
  CHECK(std::fabs(record.energy().residual()) < 1e-14);
}

TEST_CASE("a record of other settings is not resumed on a grid either", "[grid-run]") {
  Folder const folder;
  g27::Scene const scene = read(folder), other = read(folder, {"skip=off"});
  (void)run_in_pieces(scene, folder.path / "a.h5", 0);
  CHECK_THROWS_AS(g27::read_run(folder.path / "a.h5", other, other.runs[0]), g27::InputError);
}
