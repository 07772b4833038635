/// A run that is interrupted, written, read back and resumed gives the same bits as one that was not.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_reader.hpp"
#include "tests/run_in_pieces.hpp"

namespace fs = std::filesystem;

namespace {

char const* const tube = R"(title = "tube"
[time]
end = "0.2 s"
[scheme]
name = ["godunov", "linear", "parabolic", "muscl"]
[domain]
extent = ["0 m", "1 m"]
cells = 60
motion = "fixed"
boundary = { left = "wall", right = "wall" }
[material.gas]
eos = { type = "ideal", gamma = 1.4 }
[[region]]
extent = ["0 m", "0.5 m"]
density = "1 kg/m3"
pressure = "1 Pa"
[[region]]
extent = ["0.5 m", "1 m"]
density = "0.125 kg/m3"
pressure = "0.1 Pa"
[output]
snapshots = ["0.05 s", "0.15 s"]
every = "0.003 s"
threshold = "0.2 Pa"
map = 20
probe = [{ name = "mid", position = "0.5 m" }]
)";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("g27-resume-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

void check_same(g27::RunRecord const& a, g27::RunRecord const& b) {
  CHECK(a.restart.mass == b.restart.mass);
  CHECK(a.restart.momentum == b.restart.momentum);
  CHECK(a.restart.energy == b.restart.energy);
  CHECK(a.restart.faces == b.restart.faces);
  CHECK(a.restart.switched == b.restart.switched);
  CHECK(a.restart.counters.steps == b.restart.counters.steps);
  CHECK(a.restart.counters.switched == b.restart.counters.switched);
  CHECK(a.map.time == b.map.time);
  CHECK(a.map.pressure == b.map.pressure);
  REQUIRE(a.snapshots.size() == b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
    CHECK(a.snapshots[i].time == b.snapshots[i].time);
    CHECK(a.snapshots[i].pressure == b.snapshots[i].pressure);
  }
  for (std::size_t c = 0; c < a.history.columns().size(); ++c) {
    INFO(a.history.columns()[c].name);
    auto const &x = a.history.columns()[c].values, &y = b.history.columns()[c].values;
    REQUIRE(x.size() == y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      CHECK((x[i] == y[i] || (std::isnan(x[i]) && std::isnan(y[i]))));
    }
  }
  // Sums of the pieces' sums: equal to round-off, not bit by bit.
  CHECK(std::abs(a.restart.ledger.energy.residual() - b.restart.ledger.energy.residual()) < 1e-14);
}

void check_scene(std::vector<std::string> const& set) {
  Folder const folder;
  fs::path const file = folder.path / "scene.toml";
  std::ofstream(file) << tube;
  g27::Scene const scene = g27::read_scene(file, set);
  for (std::size_t i = 0; i < scene.runs.size(); ++i) {
    INFO(scene.runs[i].name);
    g27::RunRecord const whole = run_in_pieces(scene, folder.path / "a.h5", 0, i);
    CHECK(whole.restart.counters.steps > 21);  // at least four pieces
    CHECK(whole.snapshots.size() == 4);
    check_same(whole, run_in_pieces(scene, folder.path / "b.h5", 7, i));
  }
}

}  // namespace

TEST_CASE("resuming changes no bit on a fixed mesh", "[resume]") { check_scene({}); }

TEST_CASE("resuming changes no bit in curved symmetry", "[resume]") { check_scene({"domain.symmetry=spherical"}); }

TEST_CASE("resuming changes no bit on a Lagrangian mesh", "[resume]") { check_scene({"domain.motion=lagrangian"}); }

TEST_CASE("resuming changes no bit on a stretched mesh", "[resume]") {
  check_scene({"domain.motion=stretched", "domain.boundary.left={type=\"piston\", velocity=\"0.3 m/s\"}"});
}

TEST_CASE("resuming changes no bit on a prescribed mesh", "[resume]") {
  check_scene({"domain.motion={type=\"prescribed\", amplitude=\"0.05 m\", period=\"0.1 s\"}"});
}

TEST_CASE("a record of other settings is not resumed", "[resume]") {
  Folder const folder;
  fs::path const file = folder.path / "scene.toml", out = folder.path / "a.h5";
  std::ofstream(file) << tube;
  g27::Scene const scene = g27::read_scene(file, {}), other = g27::read_scene(file, {"time.cfl=0.5"});
  (void)run_in_pieces(scene, out, 0);
  CHECK_THROWS_AS(g27::read_run(out, other, other.runs[0]), g27::InputError);
  CHECK_THROWS_AS(g27::read_run(out, scene, scene.runs[1]), g27::InputError);
}
