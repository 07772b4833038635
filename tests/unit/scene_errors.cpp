/// Every malformed scene is refused with its file, place, key and remedy.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_reader.hpp"
#include "tests/catch.hpp"

namespace {

char const* const valid = R"(title = "tube"
[time]
end = "1 ms"
cfl = 0.8
[scheme]
order = 2
switch = "graded"
[domain]
symmetry = "planar"
extent = ["0 m", "1 m"]
cells = 100
motion = "fixed"
boundary = { left = "wall", right = "outflow" }
[material.gas]
eos = { type = "ideal", gamma = 1.4 }
[[region]]
extent = ["0 m", "0.5 m"]
density = "1 kg/m3"
velocity = "0 m/s"
pressure = "1 bar"
[[region]]
extent = ["0.5 m", "1 m"]
density = "0.125 kg/m3"
pressure = "0.1 bar"
[output]
snapshots = ["0.5 ms"]
threshold = "2 bar"
probe = [{ name = "mid", position = "0.5 m" }]
[[expect]]
quantity = "probe_pressure"
probe = "mid"
time = "1 ms"
value = "0.3 bar"
tolerance = "5 %"
)";

char const* const valid_grid = R"(title = "box"
[time]
end = "1 ms"
[scheme]
order = 2
transverse = "own-cell"
skip = "on"
[domain]
extent = [["0 m", "1 m"], ["0 m", "1 m"], ["0 m", "0.5 m"]]
cells = [20, 20, 10]
boundary = { x_low = "symmetry", y_low = "symmetry", z_low = "symmetry", others = "outflow" }
[[domain.patch]]
side = "x_high"
extent = [["0 m", "0.2 m"], ["0 m", "0.2 m"]]
condition = { type = "inflow", density = "1 kg/m3", velocity = ["-1 m/s", [["0 s", "0 m/s"], ["1 s", "1 m/s"]], "0 m/s"], pressure = "1 bar" }
[[block]]
extent = [["0.5 m", "0.75 m"], ["0 m", "0.25 m"], ["0 m", "0.3 m"]]
[material.gas]
eos = { type = "ideal", gamma = 1.4 }
[ambient]
density = "1 kg/m3"
pressure = "1 bar"
[[region]]
shape = "sphere"
center = ["0 m", "0 m", "0 m"]
radius = "0.2 m"
density = "2 kg/m3"
pressure = "9 bar"
[start]
one_dimensional_radius = "0.3 m"
[output]
threshold = "2 bar"
origin = ["0 m", "0 m", "0 m"]
probe = [{ name = "mid", position = ["0.5 m", "0.5 m", "0.1 m"] }]
[[expect]]
quantity = "shock_radius"
axis = "diagonal"
time = "1 ms"
value = "0.3 m"
tolerance = "5 %"
)";

char const* const jwl_material =
    R"(eos = { type = "jwl", A = "708.6 GPa", B = "13.16 GPa", R1 = 4.94, R2 = 1.35, omega = 0.28, rho0 = "1.65 g/cm3" })";
char const* const ideal_material = R"(eos = { type = "ideal", gamma = 1.4 })";

class TemporaryScene {
 public:
  explicit TemporaryScene(std::string const& text)
      : path_(std::filesystem::temp_directory_path() / ("g27-scene-" + std::to_string(getpid()) + ".toml")) {
    std::ofstream(path_) << text;
  }
  ~TemporaryScene() { std::filesystem::remove(path_); }
  TemporaryScene(TemporaryScene const&) = delete;
  TemporaryScene& operator=(TemporaryScene const&) = delete;
  [[nodiscard]] std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string edited(std::string const& from, std::string const& to, std::string text = valid) {
  std::size_t const at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

struct Mistake {
  std::string from, to;           ///< edit of the valid scene
  std::string key, what, remedy;  ///< fragments of the message
};

// clang-format off
std::vector<Mistake> const mistakes{
    // syntax and keys
    {"title = \"tube\"", "title = \"tube", "syntax", "", "correct the TOML"},
    {"cells = 100", "cells = 100\ncells = 200", "syntax", "", "correct the TOML"},
    {"title = \"tube\"", "", "title", "missing", "add title"},
    {"title = \"tube\"", "title = 3", "title", "a number, not text", "quotes"},
    {"title = \"tube\"", "title = \"t\"\nsoure = \"x\"", "soure", "unknown key", "'source'"},
    {"cells = 100", "cels = 100", "domain.cels", "unknown key", "'cells'"},
    {"[output]", "[ouput]", "ouput", "unknown key", "'output'"},
    {"velocity = \"0 m/s\"", "velocty = \"0 m/s\"", "region.0.velocty", "unknown key", "'velocity'"},
    {"right = \"outflow\"", "rigth = \"outflow\"", "domain.boundary.rigth", "unknown key", "'right'"},
    {"[time]", "[[time]]", "time", "a list, not a table", "entries"},
    {"[[region]]\nextent = [\"0 m\"", "[region]\nextent = [\"0 m\"", "syntax", "", "correct the TOML"},
    // numbers, units, dimensions
    {"end = \"1 ms\"", "end = \"1 m\"", "time.end", "not a time", "\"55 us\""},
    {"end = \"1 ms\"", "end = \"soon\"", "time.end", "not a number with a unit", "\"55 us\""},
    {"end = \"1 ms\"", "end = \"1 parsec\"", "time.end", "not a number with a unit", "\"55 us\""},
    {"end = \"1 ms\"", "end = true", "time.end", "a boolean, not a number", "\"55 us\""},
    {"end = \"1 ms\"", "end = \"-1 ms\"", "time.end", "not positive", "> 0"},
    {"end = \"1 ms\"", "end = \"0 ms\"", "time.end", "not positive", "> 0"},
    {"end = \"1 ms\"", "end = \"1e999 ms\"", "time.end", "not a finite number", "\"55 us\""},
    {"end = \"1 ms\"", "end = nan", "time.end", "not a finite number", "\"55 us\""},
    {"end = \"1 ms\"", "", "time.end", "missing", "add end"},
    {"cfl = 0.8", "cfl = 0", "time.cfl", "out of range", "up to 1"},
    {"cfl = 0.8", "cfl = 1.5", "time.cfl", "out of range", "up to 1"},
    {"cfl = 0.8", "cfl = -0.1", "time.cfl", "out of range", "up to 1"},
    {"cfl = 0.8", "cfl = inf", "time.cfl", "not a finite number", "\"0.8\""},
    {"cfl = 0.8", "cfl = \"0.8 m\"", "time.cfl", "not a pure number", "\"0.8\""},
    // scheme
    {"order = 2", "order = 4", "scheme.order", "4 is unknown", "choose 1"},
    {"order = 2", "order = 2.5", "scheme.order", "not a whole number", "choose 1"},
    {"order = 2", "order = []", "scheme.order", "empty list", "at least one"},
    {"order = 2", "order = [1, 1]", "scheme.order", "twice", "once"},
    {"order = 2", "order = 2\nname = \"linear\"", "scheme.name", "beside order", "keep one"},
    {"order = 2", "name = \"musl\"", "scheme.name", "'musl'", "'muscl'"},
    {"switch = \"graded\"", "switch = \"gradd\"", "scheme.switch", "'gradd'", "'graded'"},
    {"switch = \"graded\"", "riemann = \"roe\"", "scheme.riemann", "'roe'", "fast, exact, hllc"},
    {"switch = \"graded\"", "linear_star = \"yes\"", "scheme.linear_star", "not true or false", "true or false"},
    // domain
    {"symmetry = \"planar\"", "symmetry = \"sperical\"", "domain.symmetry", "'sperical'", "'spherical'"},
    {"extent = [\"0 m\", \"1 m\"]", "extent = [\"1 m\", \"0 m\"]", "domain.extent", "ends before it starts", "start < end"},
    {"extent = [\"0 m\", \"1 m\"]", "extent = [\"0 m\"]", "domain.extent", "has 1 entries", "two"},
    {"extent = [\"0 m\", \"1 m\"]", "extent = \"1 m\"", "domain.extent", "not a list", "write ["},
    {"cells = 100", "cells = 3", "domain.cells", "3 is out of range", "from 4"},
    {"cells = 100", "cells = -5", "domain.cells", "-5 is out of range", "from 4"},
    {"cells = 100", "cells = 99.5", "domain.cells", "not a whole number", "from 4"},
    {"cells = 100", "cell = \"1 m\"", "domain.cell", "makes 1 cells", "4 to"},
    {"cells = 100", "cells = 100\ncell = \"1 cm\"", "domain.cells", "both given", "either"},
    {"cells = 100", "", "domain.cells", "missing", "cells = 400"},
    {"cells = 100", "cells = 100\nmesh = \"graded\"", "domain.mesh", "needs its parameters", "ratio"},
    {"cells = 100", "cells = 100\nmesh = { type = \"graded\", ratio = -2 }", "domain.mesh.ratio", "not positive", "> 0"},
    {"cells = 100", "cells = 100\nmesh = { type = \"faces\", faces = [\"0 m\", \"1 m\"] }", "domain.extent", "beside a table", "remove it"},
    {"motion = \"fixed\"", "motion = \"prescribed\"", "domain.motion", "needs its parameters", "amplitude"},
    {"motion = \"fixed\"", "motion = { type = \"prescribed\", amplitude = \"1 m\", period = \"1 ms\" }", "domain.motion.amplitude", "faces cross", "below a third"},
    {"left = \"wall\"", "left = \"periodic\"", "domain.boundary", "one side only", "both sides"},
    {"left = \"wall\"", "left = \"piston\"", "domain.boundary.left", "needs its state", "velocity"},
    {"left = \"wall\"", "left = { type = \"piston\", velocity = \"10 m/s\" }", "domain.motion", "does not follow the piston", "stretched"},
    {"left = \"wall\"", "left = { type = \"piston\", velocity = [[\"0 s\", \"1 m/s\"], [\"0 s\", \"2 m/s\"]] }", "domain.boundary.left.velocity", "do not increase", "sort"},
    {"left = \"wall\"", "left = { type = \"inflow\", density = \"1 kg/m3\", velocity = \"1 m/s\" }", "domain.boundary.left.pressure", "missing", "add pressure"},
    {"left = \"wall\"", "left = { type = \"inflow\", density = \"1 kg/m3\", velocity = \"1 m/s\", pressure = \"-1 bar\" }", "domain.boundary.left.pressure", "not admissible", "raise the pressure"},
    {"symmetry = \"planar\"\nextent = [\"0 m\"", "symmetry = \"spherical\"\nextent = [\"-1 m\"", "domain.extent", "below 0 in curved", "start at"},
    {"symmetry = \"planar\"\nextent = [\"0 m\", \"1 m\"]\ncells = 100\nmotion = \"fixed\"\nboundary = { left = \"wall\"", "symmetry = \"spherical\"\nextent = [\"0 m\", \"1 m\"]\ncells = 100\nmotion = \"fixed\"\nboundary = { left = \"outflow\"", "domain.boundary", "axis or centre", "left = \"wall\""},
    // material
    {"type = \"ideal\"", "type = \"idael\"", "material.gas.eos.type", "'idael'", "'ideal'"},
    {", gamma = 1.4", "", "material.gas.eos.gamma", "missing", "add gamma"},
    {"gamma = 1.4", "gamma = 0.9", "material.gas.eos.gamma", "out of range", "choose it in"},
    {"gamma = 1.4", "gama = 1.4", "material.gas.eos.gama", "unknown key", "'gamma'"},
    {"gamma = 1.4", "gamma = \"1.4 bar\"", "material.gas.eos.gamma", "dimension", "give a"},
    {"[material.gas]", "[material.gas]\ndensity = \"1 kg/m3\"", "material.gas.density", "unknown key", "eos"},
    {ideal_material, "eos = \"ideal\"", "material.gas.eos", "text, not a table", "entries"},
    // initial data
    {"density = \"1 kg/m3\"", "density = \"-1 kg/m3\"", "region.0.density", "not positive", "density > 0"},
    {"density = \"1 kg/m3\"", "density = \"1 bar\"", "region.0.density", "not a density", "g/cm3"},
    {"pressure = \"1 bar\"", "pressure = \"-1 bar\"", "region.0.pressure", "not admissible", "raise the pressure"},
    {"pressure = \"1 bar\"", "", "region.0.pressure", "missing", "add pressure"},
    {"extent = [\"0.5 m\", \"1 m\"]", "extent = [\"0.4 m\", \"1 m\"]", "region.1", "overlaps", "extents meet"},
    {"extent = [\"0.5 m\", \"1 m\"]", "extent = [\"0.6 m\", \"1 m\"]", "region.1", "gap", "extents meet"},
    {"extent = [\"0.5 m\", \"1 m\"]", "extent = [\"0.5 m\", \"0.9 m\"]", "scene", "no initial data", "[[region]]"},
    {"extent = [\"0.5 m\", \"1 m\"]", "extent = [\"5 m\", \"10 m\"]", "region.1.extent", "covers no centre of a cell of the domain, 0 m to 1 m", "into the domain"},
    {"extent = [\"0.5 m\", \"1 m\"]", "extent = [\"0.506 m\", \"0.514 m\"]", "region.1.extent", "covers no centre", "smaller cells"},
    {"[output]", "[[charge]]\nradius = \"4 mm\"\ndensity = \"1.65 g/cm3\"\nenergy = \"8.2 GJ/m3\"\n[output]", "charge.0.radius", "covers no centre", "smaller cells"},
    {"density = \"1 kg/m3\"", "material = \"steel\"\ndensity = \"1 kg/m3\"", "region", "'steel' is not defined", "use 'gas'"},
    {"[output]", "[initial]\ntype = \"table\"\nfile = \"x.csv\"\n[output]", "initial", "beside", "keep one"},
    {"[output]", "[[charge]]\nradius = \"5 cm\"\ndensity = \"1.65 g/cm3\"\nenergy = \"8.2 m\"\n[output]", "charge.0.energy", "not an energy", "GJ/m3"},
    // output, expectations, variants
    {"snapshots = [\"0.5 ms\"]", "snapshots = [\"0.5 ms\", \"0.1 ms\"]", "output.snapshots", "do not increase", "sort"},
    {"threshold = \"2 bar\"", "threshold = \"0 bar\"", "output.threshold", "not positive", "> 0"},
    {"snapshots = [\"0.5 ms\"]", "snapshots = [\"0.5 ms\", \"2 ms\"]", "output.snapshots", "0.002 s is after the end at 0.001 s", "time.end later"},
    {"position = \"0.5 m\"", "position = \"-0.5 m\"", "output.probe.0.position", "outside", "choose it"},
    {"position = \"0.5 m\"", "position = \"1.5 m\"", "output.probe.0.position", "of every run", "choose it"},
    {"quantity = \"probe_pressure\"", "quantity = \"probe_presure\"", "expect.0.quantity", "'probe_presure'", "'probe_pressure'"},
    {"probe = \"mid\"", "probe = \"end\"", "expect.0.probe", "'end' is not", "one of the probes"},
    {"time = \"1 ms\"\n", "", "expect.0.time", "is needed", "add time"},
    {"time = \"1 ms\"\n", "time = \"1 ms\"\nafter = \"1 ms\"\n", "expect.0.after", "is not used", "remove after"},
    {"time = \"1 ms\"\n", "time = \"2 ms\"\n", "expect.0.time", "0.002 s is after the end of 'main' at 0.001 s", "time.end later"},
    {"quantity = \"probe_pressure\"\nprobe = \"mid\"\ntime = \"1 ms\"", "quantity = \"wall_impulse\"\nafter = \"2 ms\"", "expect.0.after", "0.002 s is longer than 'main'", "time.end later"},
    {"value = \"0.3 bar\"", "value = \"0.3 m\"", "expect.0.value", "not a pressure", "1 bar"},
    {"tolerance = \"5 %\"", "tolerance = \"0 %\"", "expect.0.tolerance", "not positive", "1 %"},
    {"tolerance = \"5 %\"", "tolerance = \"5 %\"\nvariant = \"other\"", "expect.0.variant", "'other'", "main"},
    {"tolerance = \"5 %\"", "tolerance = \"5 %\"\n[[variant]]\nname = \"main\"", "variant.0.name", "taken", "own name"},
    {"tolerance = \"5 %\"", "tolerance = \"5 %\"\n[[variant]]\nname = \"b\"\ndomain = { cels = 3 }", "domain.cels", "unknown key", "'cells'"},
};

std::vector<Mistake> const grid_mistakes{
    // domain
    {"extent = [[\"0 m\", \"1 m\"], [\"0 m\", \"1 m\"], [\"0 m\", \"0.5 m\"]]", "extent = [[\"0 m\", \"1 m\"]]", "domain.extent", "has 1 intervals", "two or three"},
    {"extent = [[\"0 m\", \"1 m\"], [\"0 m\"", "extent = [[\"0 m\", \"1 m\"], [\"2 m\"", "domain.extent.1", "ends before it starts", "start < end"},
    {"extent = [[\"0 m\", \"1 m\"], [\"0 m\"", "extent = [[\"0 m\", \"1 bar\"], [\"0 m\"", "domain.extent.0.1", "not a length", "5 cm"},
    {"cells = [20, 20, 10]", "cells = [20, 20]", "domain.cells", "has 2 entries", "3 whole numbers"},
    {"cells = [20, 20, 10]", "cells = 20", "domain.cells", "not a list", "one an axis"},
    {"cells = [20, 20, 10]", "cells = [20, 20, 2]", "domain.cells", "2 is out of range", "from 4"},
    {"cells = [20, 20, 10]", "", "domain.cells", "missing", "cell = "},
    {"cells = [20, 20, 10]", "cell = \"3 cm\"", "domain.cell", "33.3333 cells", "whole number of cells"},
    {"cells = [20, 20, 10]", "cells = [20, 20, 10]\nsymmetry = \"planar\"", "domain.symmetry", "one dimension", "remove it"},
    {"cells = [20, 20, 10]", "cells = [20, 20, 10]\nmesh = \"uniform\"", "domain.mesh", "one dimension", "remove it"},
    {"cells = [20, 20, 10]", "cels = [20, 20, 10]", "domain.cels", "unknown key", "'cells'"},
    // boundary
    {"x_low = \"symmetry\", ", "x_lo = \"symmetry\", ", "domain.boundary.x_lo", "unknown key", "'x_low'"},
    {"others = \"outflow\"", "x_high = \"outflow\"", "domain.boundary.y_high", "missing", "others"},
    {"x_low = \"symmetry\", ", "x_low = \"symetry\", ", "domain.boundary.x_low", "'symetry'", "'symmetry'"},
    {"x_low = \"symmetry\", ", "x_low = \"periodic\", ", "domain.boundary", "one side of x only", "x_high"},
    {"x_low = \"symmetry\", ", "x_low = \"inflow\", ", "domain.boundary.x_low", "needs its state", "velocity"},
    {"x_low = \"symmetry\", ", "x_low = { type = \"inflow\", density = \"1 kg/m3\", velocity = [\"1 m/s\"], pressure = \"1 bar\" }, ", "domain.boundary.x_low.velocity", "has 1 entries", "give 3"},
    {"x_low = \"symmetry\", ", "x_low = { type = \"inflow\", density = \"1 kg/m3\", velocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"], pressure = \"-1 bar\" }, ", "domain.boundary.x_low.pressure", "not admissible", "raise"},
    {"x_low = \"symmetry\", ", "x_low = { type = \"moving-shock\", point = [\"0 m\", \"0 m\", \"0 m\"], normal = [1, 0, 0], speed = \"1 m/s\" }, ", "domain.boundary.x_low.behind", "missing", "add behind"},
    {"side = \"x_high\"", "side = \"right\"", "domain.patch.0.side", "'right'", "x_low"},
    {"extent = [[\"0 m\", \"0.2 m\"], [\"0 m\", \"0.2 m\"]]", "extent = [[\"0 m\", \"0.2 m\"]]", "domain.patch.0.extent", "has 1 intervals", "give 2"},
    {"extent = [[\"0 m\", \"0.2 m\"], [\"0 m\", \"0.2 m\"]]", "extent = [[\"2 m\", \"3 m\"], [\"0 m\", \"0.2 m\"]]", "domain.patch.0.extent", "beside the domain", "from 0 m to 1 m"},
    {"[[\"0 s\", \"0 m/s\"], [\"1 s\", \"1 m/s\"]]", "[[\"1 s\", \"0 m/s\"], [\"1 s\", \"1 m/s\"]]", "domain.patch.0.condition.velocity.1", "do not increase", "sort"},
    // blocks
    {"extent = [[\"0.5 m\", \"0.75 m\"]", "extent = [[\"0.5 m\", \"0.6 m\"]", "block.0.extent", "takes 2 cells along x", "4 cells"},
    {"extent = [[\"0.5 m\", \"0.75 m\"]", "extent = [[\"0.7 m\", \"0.9 m\"]", "block.0.extent", "2 after it", "none or 4"},
    {"[\"0 m\", \"0.25 m\"], [\"0 m\", \"0.3 m\"]]", "[\"0 m\", \"0.25 m\"]]", "block.0.extent", "has 2 intervals", "give 3"},
    {"extent = [[\"0.5 m\", \"0.75 m\"], [\"0 m\", \"0.25 m\"], [\"0 m\", \"0.3 m\"]]", "extent = [[\"0 m\", \"1 m\"], [\"0 m\", \"1 m\"], [\"0 m\", \"0.5 m\"]]", "ambient", "no cell left", "blocks smaller"},
    // scheme
    {"transverse = \"own-cell\"", "transverse = \"mean\"", "scheme.transverse", "'mean'", "averaged"},
    {"skip = \"on\"", "skip = \"maybe\"", "scheme.skip", "not true or false", "on, off"},
    {"skip = \"on\"", "feet = \"conservative\"", "scheme.feet", "unknown key", "skip"},
    {"skip = \"on\"", "tile = [2, 16, 16]", "scheme.tile", "2 is out of range", "from 4"},
    // initial data
    {"[ambient]\ndensity = \"1 kg/m3\"\npressure = \"1 bar\"", "", "ambient", "missing", "add [ambient]"},
    {"shape = \"sphere\"", "shape = \"ball\"", "region.0.shape", "'ball'", "sphere"},
    {"radius = \"0.2 m\"", "raduis = \"0.2 m\"", "region.0.raduis", "unknown key", "'radius'"},
    {"radius = \"0.2 m\"", "radius = \"-0.2 m\"", "region.0.radius", "not positive", "> 0"},
    {"center = [\"0 m\", \"0 m\", \"0 m\"]", "center = [\"0 m\", \"0 m\"]", "region.0.center", "has 2 entries", "give 3"},
    {"center = [\"0 m\", \"0 m\", \"0 m\"]", "center = [\"0 km\", \"3 km\", \"0 m\"]", "region.0.shape", "outside the domain", "move it"},
    {"radius = \"0.2 m\"", "radius = \"4 cm\"", "region.0.shape", "covers no centre of a cell", "smaller cells"},
    {"shape = \"sphere\"\ncenter = [\"0 m\", \"0 m\", \"0 m\"]\nradius = \"0.2 m\"", "shape = \"box\"\nextent = [[\"0.18 m\", \"0.22 m\"], [\"0 m\", \"1 m\"], [\"0 m\", \"1 m\"]]", "region.0.shape", "covers no centre of a cell", "smaller cells"},
    {"pressure = \"9 bar\"", "pressure = \"9 bar\"\nvelocity = \"1 m/s\"", "region.0.velocity", "not a list", "write ["},
    {"shape = \"sphere\"\ncenter = [\"0 m\", \"0 m\", \"0 m\"]\nradius = \"0.2 m\"", "shape = \"half-space\"\npoint = [\"0 m\", \"0 m\", \"0 m\"]\nnormal = [0, 0, 0]", "region.0.normal", "has no length", "direction"},
    {"[output]", "[initial]\ntype = \"table\"\n[output]", "initial", "one dimension", "[[region]]"},
    // the first phase
    {"one_dimensional_radius = \"0.3 m\"", "", "start.one_dimensional_until", "missing", "one_dimensional_radius"},
    {"one_dimensional_radius = \"0.3 m\"", "one_dimensional_radius = \"0.1 m\"", "start.one_dimensional_radius", "out of range", "nearest side, block or body"},
    {"one_dimensional_radius = \"0.3 m\"", "one_dimensional_radius = \"0.6 m\"", "start.one_dimensional_radius", "out of range", "0.5 m"},
    {"one_dimensional_radius = \"0.3 m\"", "one_dimensional_until = \"2 ms\"", "start.one_dimensional_until", "not within the run", "choose it"},
    {"pressure = \"9 bar\"", "pressure = \"9 bar\"\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]", "start", "region.0 moves", "remove [start]"},
    {"x_low = \"symmetry\", ", "x_low = \"outflow\", ", "start", "not a plane of symmetry", "x_low = \"symmetry\""},
    {"radius = \"0.2 m\"", "radius = \"0.55 m\"", "start", "nearest side, block or body", "remove [start]"},
    // output, expectations, variants
    {"position = [\"0.5 m\", \"0.5 m\", \"0.1 m\"]", "position = \"0.5 m\"", "output.probe.0.position", "not a list", "write ["},
    {"position = [\"0.5 m\", \"0.5 m\", \"0.1 m\"]", "position = [\"0.5 m\", \"-0.5 m\", \"0.1 m\"]", "output.probe.0.position", "outside", "choose it"},
    {"position = [\"0.5 m\", \"0.5 m\", \"0.1 m\"]", "position = [\"0.5 m\", \"3 m\", \"0.1 m\"]", "output.probe.0.position", "of every run", "choose it"},
    {"threshold = \"2 bar\"", "threshold = \"2 bar\"\nmap = 20", "output.map", "unknown key", "probe"},
    {"axis = \"diagonal\"", "axis = \"w\"", "expect.0.axis", "'w'", "diagonal"},
    {"axis = \"diagonal\"\n", "", "expect.0.axis", "missing", "add axis"},
    {"quantity = \"shock_radius\"", "quantity = \"wall_impulse\"", "expect.0.quantity", "'wall_impulse'", "shock_radius"},
    {"tolerance = \"5 %\"", "tolerance = \"5 %\"\n[[variant]]\nname = \"b\"\ndomain = { extent = [\"0 m\", \"1 m\"] }", "block", "two and three dimensions", "remove it"},
};
// clang-format on

void check_mistakes(std::vector<Mistake> const& list, std::string const& start) {
  for (Mistake const& m : list) {
    TemporaryScene const file(edited(m.from, m.to, start));
    INFO(m.to);
    try {
      (void)g27::read_scene(file.path(), {});
      FAIL_CHECK("was accepted");
    } catch (g27::InputError const& error) {
      INFO(error.what());
      CHECK(error.file.find(file.path().string() + ":") == 0);  // with a line
      CHECK(error.key == m.key);
      CHECK(error.problem.find(m.what) != std::string::npos);
      CHECK(error.remedy.find(m.remedy) != std::string::npos);
    }
  }
}

}  // namespace

TEST_CASE("the scene that the mistakes start from is valid", "[scene]") {
  TemporaryScene const file(valid);
  g27::Scene const scene = g27::read_scene(file.path(), {});
  CHECK(scene.runs.size() == 1);
  CHECK(scene.bare_numbers.empty());
}

TEST_CASE("the grid that the mistakes start from is valid", "[scene]") {
  TemporaryScene const file(valid_grid);
  g27::Scene const scene = g27::read_scene(file.path(), {});
  REQUIRE(scene.runs.size() == 1);
  CHECK(scene.bare_numbers.empty());
  REQUIRE(scene.runs[0].grid);
  g27::GridRun const& grid = *scene.runs[0].grid;
  CHECK(scene.runs[0].dimensions() == 3);
  CHECK(grid.setup.blocks.at(0).first == g27::Int3{10, 0, 0});
  CHECK(grid.setup.blocks.at(0).last == g27::Int3{15, 5, 6});
  CHECK(grid.setup.patches.at(0).condition.state({1, 0, 0}, 0.5).u == g27::Vec3{-1, 0.5, 0});
  REQUIRE(grid.line);
  CHECK(grid.line->setup.symmetry == g27::Symmetry::spherical);
  CHECK(grid.line->clearance == Approx(0.5));
  CHECK_FALSE(g27::read_scene(file.path(), {"skip=off"}).runs[0].grid->setup.options.skip);
}

TEST_CASE("a malformed scene is refused with file, key and remedy", "[scene]") { check_mistakes(mistakes, valid); }

TEST_CASE("a malformed scene on a grid is refused with file, key and remedy", "[scene]") {
  check_mistakes(grid_mistakes, valid_grid);
}

TEST_CASE("a probe in a block is remarked on", "[scene]") {
  TemporaryScene const file(valid_grid);
  CHECK(g27::remarks_on(g27::read_scene(file.path(), {})).empty());
  auto const remarks =
      g27::remarks_on(g27::read_scene(file.path(), {"output.probe.0.position=[\"0.6 m\", \"0.1 m\", \"0.1 m\"]"}));
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0].find("'mid' lies in block.0") != std::string::npos);
}

TEST_CASE("snapshots may be those of a longer variant", "[scene]") {
  std::string const text = edited("snapshots = [\"0.5 ms\"]", "snapshots = [\"0.5 ms\", \"2 ms\"]") +
                           "[[variant]]\nname = \"long\"\ntime = { end = \"3 ms\" }\n";
  TemporaryScene const file(text);
  g27::Scene const scene = g27::read_scene(file.path(), {});
  CHECK(scene.runs.at(0).output.snapshots == std::vector<double>{0, 0.5e-3, 1e-3});
  CHECK(scene.runs.at(1).output.snapshots == std::vector<double>{0, 0.5e-3, 2e-3, 3e-3});
}

TEST_CASE("averages of cells that a ball cuts are means over points", "[scene]") {
  TemporaryScene const file(valid_grid);
  g27::GridRun const grid = *g27::read_scene(file.path(), {}).runs[0].grid;
  double const h = 0.05;
  CHECK(grid.initial({0.5 * h, 0.5 * h, 0.5 * h}, {h, h, h}).mass == 2.0);  // inside: no round-off of a sum
  CHECK(grid.initial({10.5 * h, 0.5 * h, 0.5 * h}, {h, h, h}).mass == 1.0);
  double mass = 0;
  for (int n = 0; n < 512; ++n) {
    mass += h * h * h * grid.initial({(n % 8 + 0.5) * h, (n / 8 % 8 + 0.5) * h, (n / 64 + 0.5) * h}, {h, h, h}).mass;
  }
  double const pi = 3.14159265358979;
  CHECK(mass ==
        Approx(0.4 * 0.4 * 0.4 + pi / 6 * 0.2 * 0.2 * 0.2).epsilon(1e-4));  // 4 cells to the surface, 8 points each
}

TEST_CASE("a JWL scene guards the pressure margin, not the sign", "[scene]") {
  std::string text = edited(ideal_material, jwl_material);
  // The cold curve at 2.5 g/cm3 is far above 1 bar: such a state has no temperature.
  text.replace(text.find("density = \"1 kg/m3\""), 19, "density = \"2.5 g/cm3\"");
  TemporaryScene const file(text);
  try {
    (void)g27::read_scene(file.path(), {});
    FAIL("was accepted");
  } catch (g27::InputError const& error) {
    CHECK(error.key == "region.0.pressure");
    CHECK(error.problem.find("not admissible") != std::string::npos);
  }
}

TEST_CASE("the place of a mistake is its line and column", "[scene]") {
  TemporaryScene const file(edited("cells = 100", "cels = 100"));
  try {
    (void)g27::read_scene(file.path(), {});
    FAIL("was accepted");
  } catch (g27::InputError const& error) {
    CHECK(error.file == file.path().string() + ":11:1");
  }
}

TEST_CASE("overrides replace values and are checked alike", "[scene]") {
  TemporaryScene const file(valid);
  auto const read = [&](std::vector<std::string> const& set) { return g27::read_scene(file.path(), set); };
  CHECK(read({"domain.cells=40"}).runs[0].setup.faces.size() == 41);
  CHECK(read({"time.end=2 ms"}).runs[0].end == Approx(2e-3));  // a bare word is text
  CHECK(read({"scheme.order=[1, 3]"}).runs.size() == 2);
  CHECK(read({"region.1.pressure=\"0.2 bar\""}).runs[0].initial(0.75).p == Approx(2e4));
  CHECK_THROWS_AS(read({"domain.cels=40"}), g27::InputError);
  CHECK_THROWS_AS(read({"domain.cells"}), g27::InputError);
  CHECK_THROWS_AS(read({"region.7.pressure=1"}), g27::InputError);
  CHECK_THROWS_AS(read({"=1"}), g27::InputError);
}

TEST_CASE("numbers without a unit are SI and are told", "[scene]") {
  TemporaryScene const file(edited("end = \"1 ms\"", "end = 0.001"));
  g27::Scene const scene = g27::read_scene(file.path(), {});
  CHECK(scene.runs[0].end == 0.001);
  REQUIRE(scene.bare_numbers.size() == 1);
  CHECK(scene.bare_numbers[0].find("time.end = 0.001") == 0);
}

TEST_CASE("a scene that is missing, empty or a folder is refused", "[scene]") {
  CHECK_THROWS_AS(g27::read_scene("/nonexistent/scene.toml", {}), g27::InputError);
  CHECK_THROWS_AS(g27::read_scene(std::filesystem::temp_directory_path(), {}), g27::InputError);
  TemporaryScene const file("");
  CHECK_THROWS_AS(g27::read_scene(file.path(), {}), g27::InputError);
  CHECK_THROWS_AS(g27::find_scene("tnt-rdx-spere"), g27::InputError);
}
