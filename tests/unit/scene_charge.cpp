/// A charge that is lit, in scenes.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/simulate.hpp"
#include "tests/reference_table.hpp"
#include "tests/run_in_pieces.hpp"
#include "verification/exact/kenamond.hpp"

namespace fs = std::filesystem;

namespace {

constexpr double radius = 0.05, density = 1650, energy = 8.2e9;  ///< m, kg/m^3, J/m^3

std::string const material = R"(
[scheme]
order = 2
[material.products]
eos = { type = "jwl", A = "708.6056 GPa", B = "13.16457 GPa", R1 = 4.94, R2 = 1.35, omega = 0.28, rho0 = "1.65 g/cm3" }
[ambient]
density = "1.2 kg/m3"
pressure = "1 bar"
[[charge]]
radius = "5 cm"
density = "1.65 g/cm3"
energy = "8.2 GJ/m3"
)";

std::string const line = R"(title = "on a line"
[time]
end = "13 us"
[domain]
symmetry = "spherical"
extent = ["0 cm", "12 cm"]
cell = "0.0625 cm"
boundary = { left = "wall", right = "outflow" }
[output]
threshold = "10 bar"
)";

std::string const grid = R"(title = "on a grid"
[time]
end = "1 us"
[domain]
extent = [["0 cm", "8 cm"], ["0 cm", "8 cm"], ["0 cm", "8 cm"]]
cell = "0.5 cm"
boundary = { x_low = "symmetry", y_low = "symmetry", z_low = "symmetry", others = "outflow" }
)";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("g27-charge-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  [[nodiscard]] g27::Scene scene(std::string const& text) const {
    std::ofstream(path / "s.toml") << text;
    return g27::read_scene(path / "s.toml", {});
  }
};

g27::RunRecord run(g27::Scene const& scene) {
  g27::RunRecord record(scene.runs[0]);
  g27::simulate(scene.runs[0], record,
                {.progress = [](double) {},
                 .checkpoint = [](g27::RunRecord const&) {},
                 .checkpoint_s = 1e9,
                 .interrupted = [] { return false; }});
  return record;
}

double last(g27::RunRecord const& r, std::string const& column) { return r.history[column].back(); }

}  // namespace

// Both start from the same energy. On 80 cells a radius the burnt front lags behind the exact one by less than a cell,
// 0.7 % of the way of the shock in air at 13 us.
TEST_CASE("a lit charge throws the air as one that starts at breakout", "[scene][charge]") {
  Folder const folder;
  g27::RunRecord const lit = run(folder.scene(line + material + "start = \"ignition\"\n"));
  g27::RunRecord const exact = run(folder.scene(line + material));
  CHECK(std::fabs(last(lit, "shock_position") / last(exact, "shock_position") - 1) < 0.007);
  double const mass = density * 4 / 3.0 * std::numbers::pi * radius * radius * radius;
  double const released = lit.energy().from_source, whole = energy / density * mass;
  CHECK(exact.energy().from_source == 0);
  // a part is there before: to the products the explosive at rest is compressed
  CHECK(released > 0.2 * whole);
  CHECK(released < 0.5 * whole);
  CHECK(lit.energy().initial + released == Approx(exact.energy().initial).epsilon(2e-4));
  CHECK(std::fabs(lit.energy().residual()) < 1e-13);
  CHECK(std::fabs(lit.mass().residual()) < 1e-13);
}

TEST_CASE("on a grid a charge is lit where told", "[scene][charge]") {
  Folder const folder;
  std::string const centre = "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\nstart = \"ignition\"\n";
  g27::Scene const off = folder.scene(grid + material + centre + "ignition = [[\"0 cm\", \"0 cm\", \"4 cm\"]]\n");
  auto const& burn = off.runs[0].grid->setup.burn;
  REQUIRE(burn.there());
  CHECK(burn.lighting({0, 0, 0.04}) == 0);
  CHECK(burn.lighting({0, 0.03, 0}) * burn.speed == Approx(0.05));
  CHECK(burn.lighting({0.04, 0.04, 0}) == g27::ProgrammedBurn::no_explosive);
  // a cell is explosive wholly or not at all
  g27::GridInitial const& initial = off.runs[0].grid->initial;
  CHECK(initial({0.0475, 0.0025, 0.0025}, {0.005, 0.005, 0.005}).mass == Approx(density));
  CHECK(initial({0.0525, 0.0025, 0.0025}, {0.005, 0.005, 0.005}).mass == 1.2);
  CHECK_THROWS_AS(folder.scene(grid + material + centre + "ignition = [[\"0 cm\", \"0 cm\", \"6 cm\"]]\n"),
                  g27::InputError);
  CHECK_THROWS_AS(folder.scene(grid + material + "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\npressure = \"2 bar\"\n"),
                  g27::InputError);
}

TEST_CASE("lighting times are those of Kenamond's problem, from one point and from two", "[scene][charge]") {
  Folder const folder;
  g27::ReferenceTable const table = g27::read_reference("kenamond1.csv", {"x", "y", "burntime"});
  REQUIRE(table.rows.size() > 400);
  std::string const centre = "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\nstart = \"ignition\"\n";
  double const unit = 0.05 / 30;  // of the table in the charge, whose points and their distances lie within it
  auto const burn_of = [&](std::string const& ignition) {
    return folder.scene(grid + material + centre + ignition).runs[0].grid->setup.burn;
  };
  auto const one = burn_of("");
  std::string const points = "ignition = [[\"0 cm\", \"0 cm\", \"0 cm\"], [\"1 cm\", \"0 cm\", \"0 cm\"]]\n";
  auto const two = burn_of(points), late = burn_of(points + "delay = [\"0 us\", \"0.5 us\"]\n");
  double const delay = 0.5e-6 * one.speed / unit;
  for (auto const& row : table.rows) {
    // the table has ten digits
    double const at_origin = one.lighting({unit * row[0], unit * row[1], 0}) * one.speed / unit;
    CHECK(std::fabs(at_origin - row[2]) <= 1e-8);
    // the same table about the second point: the front that comes first counts
    g27::Vec3 const x{0.01 + unit * row[0], unit * row[1], 0};
    double const from_first = std::hypot(x[0], x[1]) / unit;
    CHECK(std::fabs(two.lighting(x) * two.speed / unit - std::min(row[2], from_first)) <= 1e-8);
    CHECK(std::fabs(late.lighting(x) * late.speed / unit - std::min(row[2] + delay, from_first)) <= 1e-8);
  }
}

TEST_CASE("a front goes around obstacles and blocks of its charge", "[scene][charge]") {
  Folder const folder;
  std::string const lit =
      "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\nstart = \"ignition\"\n"
      "ignition = [[\"0.3 cm\", \"0.2 cm\", \"0.1 cm\"]]\n";
  std::string const ball =
      "obstacle = [{ shape = \"sphere\", center = [\"2.2 cm\", \"1.4 cm\", \"1.2 cm\"], radius = \"1 cm\" }]\n";
  auto const read = [&](std::string const& more) { return *folder.scene(grid + material + lit + more).runs[0].grid; };
  auto const each = [](g27::GridRun const& run, auto const& f) {
    double const h = 0.005;
    for (int k = 0; k < 16; ++k) {
      for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) {
          g27::Vec3 const x{(i + 0.5) * h, (j + 0.5) * h, (k + 0.5) * h};
          f(x, run.setup.burn.lighting(x), run.initial(x, {h, h, h}).mass);
        }
      }
    }
  };
  g27::GridRun const free = read(""), around = read(ball);
  g27::Kenamond const exact{.speed = free.setup.burn.speed,
                            .radius = 0.01,
                            .centre = {0.022, 0.014, 0.012},
                            .ignition = {0.003, 0.002, 0.001}};
  int behind = 0, inert = 0;
  each(around, [&](g27::Vec3 const& x, double lit_at, double mass) {
    bool const inside = std::hypot(x[0] - 0.022, x[1] - 0.014, x[2] - 0.012) < 0.01;
    double const straight = free.setup.burn.lighting(x);
    // what has no time is no explosive, and holds what lies beneath
    bool const explosive = !inside && straight >= 0;
    CHECK((lit_at >= 0) == explosive);
    CHECK(mass == Approx(explosive ? density : 1.2));
    inert += inside ? 1 : 0;
    if (!explosive) return;
    if (exact.arc(x) <= 0) CHECK(lit_at == straight);  // bit by bit
    if (exact.arc(x) > 0) ++behind;
    // a sphere of two cells a radius: times are late by up to a quarter of a cell
    CHECK(lit_at * exact.speed >= exact.time(x) * exact.speed - 1e-9);
    CHECK(lit_at * exact.speed <= exact.time(x) * exact.speed + 0.25 * 0.005);
  });
  CHECK(inert > 25);
  CHECK(behind > 40);

  // a rigid block, and the same box without explosive
  std::string const extent = "extent = [[\"2 cm\", \"4 cm\"], [\"0 cm\", \"2 cm\"], [\"0 cm\", \"2 cm\"]]";
  g27::GridRun const block = read("[[block]]\n" + extent + "\n");
  g27::GridRun const hole = read("obstacle = [{ shape = \"box\", " + extent + " }]\n");
  int delayed = 0;
  each(block, [&](g27::Vec3 const& x, double lit_at, double) {
    CHECK(lit_at == hole.setup.burn.lighting(x));
    bool const inside = x[0] > 0.02 && x[0] < 0.04 && x[1] < 0.02 && x[2] < 0.02;
    CHECK((lit_at >= 0) == (!inside && free.setup.burn.lighting(x) >= 0));
    delayed += lit_at > free.setup.burn.lighting(x) ? 1 : 0;
  });
  CHECK(delayed > 30);
  // a block beside the charge leaves its times alone
  g27::GridRun const beside =
      read("[[block]]\nextent = [[\"6 cm\", \"8 cm\"], [\"0 cm\", \"2 cm\"], [\"0 cm\", \"2 cm\"]]\n");
  CHECK(beside.setup.burn.lighting({0.04, 0.02, 0.01}) == free.setup.burn.lighting({0.04, 0.02, 0.01}));
}

TEST_CASE("fronts that cannot start or have no way are refused with key and remedy", "[scene][charge]") {
  Folder const folder;
  std::string const centre = "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\n", lit = centre + "start = \"ignition\"\n";
  auto const block = [](std::string const& x, std::string const& y) {
    return "[[block]]\nextent = [" + x + ", " + y + ", [\"0 cm\", \"8 cm\"]]\n";
  };
  std::string const corner = block("[\"0 cm\", \"2 cm\"]", "[\"0 cm\", \"2 cm\"]");
  struct Mistake {
    std::string text, key, what, remedy;
  };
  // clang-format off
  std::vector<Mistake> const mistakes{
      {lit + corner, "charge.0.ignition", "in block.0", "in no block or obstacle"},
      {lit + "obstacle = [{ shape = \"sphere\", center = [\"0 cm\", \"0 cm\", \"1 cm\"], radius = \"1.1 cm\" }]\n", "charge.0.ignition", "in charge.0.obstacle.0", "in no block or obstacle"},
      {lit + "ignition = [[\"-1 cm\", \"0 cm\", \"0 cm\"]]\n" + corner, "charge.0.ignition", "outside the domain", "in the domain"},
      {lit + block("[\"2 cm\", \"4 cm\"]", "[\"0 cm\", \"8 cm\"]"), "charge.0.ignition", "without a way", "light every part"},
      // blocks that share a corner leave no way
      {lit + block("[\"2 cm\", \"8 cm\"]", "[\"0 cm\", \"2 cm\"]") + block("[\"0 cm\", \"2 cm\"]", "[\"2 cm\", \"8 cm\"]"), "charge.0.ignition", "without a way", "light every part"},
      {centre + corner, "charge.0.radius", "reaches into block.0", "start = \"ignition\""},
      {centre + "obstacle = []\n", "charge.0.obstacle", "is of a charge that is lit", "start = \"ignition\""},
      {lit + "ignition = []\n", "charge.0.ignition", "holds no point", "leave it out"},
      {lit + "ignition = [[\"-1 cm\", \"0 cm\", \"0 cm\"]]\n", "charge.0.ignition", "outside the domain", "in the domain"},
      {"center = [\"-5.1 cm\", \"0 cm\", \"0 cm\"]\n", "charge.0.radius", "covers no centre of a cell", "into the domain"},
      {lit + "obstacle = [{ shape = \"ball\" }]\n", "charge.0.obstacle.0.shape", "'ball'", "sphere"},
      {lit + "obstacle = [{ shape = \"half-space\", point = [\"2 cm\", \"0 cm\", \"0 cm\"], normal = [-1, 0, 0], density = \"1 kg/m3\" }]\n", "charge.0.obstacle.0.density", "unknown key", "normal"},
      {lit + "obstacle = [{ shape = \"sphere\", center = [\"2 cm\", \"2 cm\", \"2 cm\"], radius = \"1 cm\" }]\n[start]\none_dimensional_radius = \"7 cm\"\n", "start", "has obstacles", "remove [start]"},
      {lit + "delay = [\"0 us\", \"1 us\"]\n", "charge.0.delay", "not 1 times", "one for each point"},
      {lit + "delay = [\"-1 us\"]\n", "charge.0.delay", "from 0 on", "one for each point"},
      {lit + "delay = [\"1 us\"]\n", "charge.0.delay", "not before the end", "time.end later"},
      {lit + "obstacle = [{ shape = \"sphere\", center = [\"4 cm\", \"4 cm\", \"0 cm\"], radius = \"0.6 cm\" }]\n", "charge.0.obstacle.0", "touches nothing of the charge", "move it"},
      {lit + "obstacle = [{ shape = \"sphere\", center = [\"-3 cm\", \"0 cm\", \"0 cm\"], radius = \"1 cm\" }]\n", "charge.0.obstacle.0", "touches nothing of the charge", "move it"},
      {lit + "delay = [\"0.5 us\"]\n[start]\none_dimensional_radius = \"7 cm\"\n", "start", "at once", "remove [start]"},
  };
  // clang-format on
  for (Mistake const& m : mistakes) {
    INFO(m.text);
    try {
      (void)folder.scene(grid + material + m.text);
      FAIL_CHECK("was accepted");
    } catch (g27::InputError const& error) {
      INFO(error.what());
      CHECK(error.file.find((folder.path / "s.toml").string() + ":") == 0);  // with a line
      CHECK(error.key == m.key);
      CHECK(error.problem.find(m.what) != std::string::npos);
      CHECK(error.remedy.find(m.remedy) != std::string::npos);
    }
  }
}

TEST_CASE("a burn around a block goes on bit by bit after an interruption", "[scene][charge]") {
  Folder const folder;
  g27::Scene const scene = folder.scene(grid + material +
                                        "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\nstart = \"ignition\"\n"
                                        "[[block]]\nextent = [[\"2 cm\", \"4 cm\"], [\"0 cm\", \"2 cm\"], [\"0 cm\", "
                                        "\"2 cm\"]]\n");
  fs::path const a = folder.path / "a.h5", b = folder.path / "b.h5";
  (void)run_in_pieces(scene, a, 0);
  (void)run_in_pieces(scene, b, 5);
  g27::Hdf5Reader const whole(a), pieces(b);
  auto const p = whole.read("/state/0001/pressure");
  CHECK(*std::max_element(p.begin(), p.end()) > 1e9);  // it burns
  for (char const* field : {"density", "velocity_x", "velocity_y", "velocity_z", "pressure"}) {
    INFO(field);
    CHECK(whole.read(std::string("/state/0001/") + field) == pieces.read(std::string("/state/0001/") + field));
  }
}

TEST_CASE("an unburnt charge on a line ends at a face", "[scene][charge]") {
  Folder const folder;
  std::string other = line;
  other.replace(other.find("0.0625 cm"), 9, "0.0640 cm");
  CHECK_NOTHROW(folder.scene(other + material));
  CHECK_THROWS_AS(folder.scene(other + material + "start = \"ignition\"\n"), g27::InputError);
}

TEST_CASE("the mass that few cells hold of a charge is told where it is off", "[scene][charge]") {
  Folder const folder;
  auto const edited = [](std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  auto const remarks = [&](std::string const& start, std::string const& cm, std::string const& more) {
    return g27::remarks_on(folder.scene(start + edited(material, "5 cm", cm) + more));
  };
  std::string const lit = "start = \"ignition\"\n", edge = "center = [\"4 cm\", \"4 cm\", \"4.25 cm\"]\n",
                    corner = "center = [\"0 cm\", \"0 cm\", \"0 cm\"]\n";
  // around an edge of the grid four centres of cells lie within .75 cells: 4 / (4/3 pi .75^3) = 2.26
  auto const few = remarks(grid, "0.375 cm", edge + lit);
  REQUIRE(few.size() == 1);
  CHECK(few[0].find("charge.0.radius: the cells hold 2.26 times the mass") == 0);
  CHECK(remarks(grid, "0.375 cm", edge).empty());  // by the mean over points of each cell
  CHECK(remarks(grid, "5 cm", corner + lit).empty());
  // an octant of a ball of 1.6 cells: one centre where there should be pi/6 1.6^3 = 2.14
  REQUIRE(remarks(grid, "0.8 cm", corner + lit).size() == 1);
  CHECK(remarks(grid, "0.8 cm", corner + lit)[0].find("hold 0.46") != std::string::npos);
  // a line has the wave at five points of each cell
  CHECK(remarks(line, "0.046875 cm", "").size() == 1);
  CHECK(remarks(line, "5.03 cm", "").empty());
}
