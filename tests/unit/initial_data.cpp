/// Initial data: waves keep what they must keep, tables interpolate, a charge starts from the Chapman-Jouguet state.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_reader.hpp"
#include "tests/catch.hpp"

namespace fs = std::filesystem;

namespace {

char const* const head = R"(title = "initial data"
[time]
end = "1 s"
[domain]
extent = ["0 m", "1 m"]
cells = 20
boundary = { left = "periodic", right = "periodic" }
[material.gas]
eos = { type = "ideal", gamma = 1.6 }
[initial]
)";

char const* const wave = R"(type = "wave"
density = "1.3 kg/m3"
velocity = "12 m/s"
pressure = "2 bar"
wavelength = "1 m"
phase = "30 deg"
)";

struct Folder {
  fs::path path = fs::temp_directory_path() / ("g27-initial-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  [[nodiscard]] fs::path write(std::string const& name, std::string const& text) const {
    std::ofstream(path / name) << text;
    return path / name;
  }
};

g27::InitialState read(Folder const& folder, std::string const& initial) {
  return g27::read_scene(folder.write("scene.toml", head + initial), {}).runs[0].initial;
}

/// The key that an InputError names, "" when there is none.
std::string refused_key(Folder const& folder, std::string const& initial) {
  try {
    (void)read(folder, initial);
    return "";
  } catch (g27::InputError const& error) {
    return error.key;
  }
}

}  // namespace

TEST_CASE("a simple wave keeps entropy and one Riemann invariant", "[initial]") {
  Folder const folder;
  auto const state = read(folder, std::string(wave) + "kind = \"simple\"\namplitude = 0.2\n");
  double const g = 1.6;
  double const s0 = 2e5 / std::pow(1.3, g), j0 = 12 - 2 / (g - 1) * std::sqrt(g * 2e5 / 1.3);
  for (double x = 0; x < 1; x += 0.037) {
    auto const q = state(x);
    // The curve is integrated with 64 fourth-order steps; its relative error is below 1e-9.
    CHECK(q.p / std::pow(q.rho, g) == Approx(s0).epsilon(1e-9));
    CHECK(q.u - 2 / (g - 1) * std::sqrt(g * q.p / q.rho) == Approx(j0).epsilon(1e-9));
  }
  CHECK(state(0.0).u == Approx(12 + 0.2 * std::sqrt(g * 2e5 / 1.3) * 0.5));  // sin 30 deg
}

TEST_CASE("an entropy wave keeps velocity and pressure, an acoustic one carries no entropy to first order",
          "[initial]") {
  Folder const folder;
  auto const entropy = read(folder, std::string(wave) + "kind = \"entropy\"\namplitude = 0.3\n");
  auto const sound = read(folder, std::string(wave) + "kind = \"acoustic\"\namplitude = 1e-5\n");
  double const s0 = 2e5 / std::pow(1.3, 1.6);
  double largest = 0;
  for (double x = 0; x < 1; x += 0.037) {
    CHECK(entropy(x).u == 12);
    CHECK(entropy(x).p == 2e5);
    largest = std::max(largest, entropy(x).rho);
    CHECK(sound(x).p / std::pow(sound(x).rho, 1.6) == Approx(s0).epsilon(1e-9));  // amplitude squared
  }
  CHECK(largest == Approx(1.3 * 1.3).epsilon(0.01));
}

TEST_CASE("a table is read in its own units and interpolated", "[initial]") {
  Folder const folder;
  (void)folder.write("data.csv",
                     "# made by hand\nx [cm],density [g/cm3],velocity [km/s],pressure [kPa]\n0,1,0,100\n50,2,1,300\n"
                     "100,2,0,300\n");
  auto const from_file = read(folder, "type = \"table\"\nfile = \"data.csv\"\n");
  auto const inline_ = read(folder,
                            "type = \"table\"\nx = [\"0 m\", \"0.5 m\", \"1 m\"]\ndensity = [\"1 g/cm3\", \"2 g/cm3\", "
                            "\"2 g/cm3\"]\nvelocity = [0, 1000, 0]\npressure = [\"1 bar\", \"3 bar\", \"3 bar\"]\n");
  for (auto const& state : {from_file, inline_}) {
    CHECK(state(0.25).rho == Approx(1500));
    CHECK(state(0.25).u == Approx(500));
    CHECK(state(0.25).p == Approx(2e5));
    CHECK(state(0.5).u == Approx(1000));
    CHECK(state(0.9).p == Approx(3e5));
  }
}

TEST_CASE("malformed waves and tables are refused", "[initial]") {
  Folder const folder;
  auto const csv = [&](std::string const& text) {
    (void)folder.write("data.csv", text);
    return refused_key(folder, "type = \"table\"\nfile = \"data.csv\"\n");
  };
  std::string const header = "x [m],density [kg/m3],velocity [m/s],pressure [Pa]\n";
  CHECK(csv(header + "0,1,0,1\n1,1,0,1\n").empty());
  CHECK(csv(header + "0,1,0,1\n0.5,1,0,1\n") == "initial.file");  // does not reach 1 m
  CHECK(csv(header + "0,1,0,1\n1,-1,0,1\n") == "initial.density");
  CHECK(csv(header + "0,1,0,1\n1,1,0,nan\n") == "pressure");
  CHECK(csv(header + "0,1,0,1\n1,1,0\n") == "pressure");
  CHECK(csv(header + "1,1,0,1\n0,1,0,1\n") == "initial.file");
  CHECK(csv("x [m],density [kg/m3],velocity [m/s]\n0,1,0\n1,1,0\n") == "pressure");
  CHECK(csv("x [m],density [Pa],velocity [m/s],pressure [Pa]\n0,1,0,1\n1,1,0,1\n") == "density");
  CHECK(csv("x,density [kg/m3],velocity [m/s],pressure [Pa]\n0,1,0,1\n1,1,0,1\n") == "x");
  CHECK(csv("") == "file");
  CHECK(refused_key(folder, "type = \"table\"\nfile = \"none.csv\"\n") == "file");
  CHECK(refused_key(folder, "type = \"tabel\"\n") == "initial.type");
  CHECK(refused_key(folder, std::string(wave) + "amplitude = 1.5\n") == "initial.amplitude");
  CHECK(refused_key(folder, std::string(wave)) == "initial.amplitude");
  CHECK(refused_key(folder, std::string(wave) + "kind = \"acustic\"\namplitude = 0.1\n") == "initial.kind");
  CHECK(refused_key(folder, std::string(wave) + "amplitude = 0.1\nfile = \"x\"\n") == "initial.file");
}

TEST_CASE("the default scene starts at breakout from the Chapman-Jouguet state", "[initial]") {
  g27::Scene const scene = g27::read_scene(g27::find_scene("tnt-rdx-sphere"), {});
  CHECK(scene.bare_numbers.empty());
  CHECK(scene.runs.size() == 12);
  for (auto const& run : scene.runs) {
    // Tangency of the Rayleigh line for this set at 1.65 g/cm3: p 23.700 GPa, D 7.58690 km/s, rho 2.198643 g/cm3.
    // The velocity falls as a square root behind the front: the state is sampled on it.
    CHECK(run.start == Approx(0.05 / 7586.90).epsilon(1e-5));
    CHECK(run.initial(0.05).p == Approx(23.700e9).epsilon(1e-4));
    CHECK(run.initial(0.05).rho == Approx(2198.643).epsilon(1e-5));
    CHECK(run.initial(0.01).p == Approx(5.0219e9).epsilon(1e-4));  // core at rest
    CHECK(run.initial(0.01).u == 0);
    if (run.setup.faces.back() > 0.0501) {
      CHECK(run.initial(0.0501).p == 1e5);
      CHECK(run.initial(0.0501).rho == 1.2);
    }
  }
}
