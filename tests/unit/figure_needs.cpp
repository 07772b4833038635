/// What figures of the paper declare, and the digest under which results of scenes are kept.
#include "studies/driver/figure_needs.hpp"
#include "studies/driver/early_end.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "fsi/surface/shapes.hpp"
#include "fsi/surface/stl_file.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_cache.hpp"
#include "studies/driver/scene_reader.hpp"
#include "tests/catch.hpp"

namespace fs = std::filesystem;
using namespace g27;

namespace {

std::string const head = R"(title = "cube"
[time]
end = "5 us"
[scheme]
order = 2
)";
std::string const domain = R"([domain]
extent = [["0 cm", "3.2 cm"], ["0 cm", "3.2 cm"], ["0 cm", "3.2 cm"]]
cell = "2 mm"
boundary = { others = "outflow" }
)";
std::string const rest = R"([material.gas]
eos = { type = "ideal", gamma = 1.4 }
[material.soft]
density = "1 g/cm3"
eos = { type = "bulk-modulus", K = "2 GPa" }
strength = { type = "von-mises", shear = "0.5 GPa", yield = "2 MPa", hardening = "1 MPa" }
[ambient]
density = "100 kg/m3"
pressure = "50 bar"
[[body]]
name = "cube"
surface = "cube.stl"
scale = "1 cm"
center = ["1.6 cm", "1.6 cm", "1.61 cm"]
material = "soft"
cell = "1.5 mm"
[output]
snapshots = ["1 us", "3 us"]
)";

class SceneFolder {
 public:
  SceneFolder() : folder_(fs::temp_directory_path() / ("g27-needs-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    write_cube(1);
  }
  ~SceneFolder() { fs::remove_all(folder_); }
  SceneFolder(SceneFolder const&) = delete;
  SceneFolder& operator=(SceneFolder const&) = delete;

  void write_cube(double side) const {
    std::ofstream(folder_ / "cube.stl", std::ios::binary) << binary_stl(make_box({side, side, side}, 0.15));
  }
  [[nodiscard]] std::string digest(std::string const& text, std::vector<std::string> const& set = {}) const {
    std::ofstream(file(), std::ios::binary) << text;
    return read_scene(file(), set).digest;
  }
  [[nodiscard]] fs::path file() const { return folder_ / "cube.toml"; }

 private:
  fs::path folder_;
};

}  // namespace

TEST_CASE("needs are read from a script's comments", "[unit]") {
  auto const needs = parse_needs(
      "\"\"\"A figure.\"\"\"\n# needs: cube\nimport h5py\n"
      "# needs:  disc --set scheme.order=1 --set 'material.steel.strength={ type = \"elastic\" }' \n# other\n",
      "fig.py");
  REQUIRE(needs.size() == 2);
  CHECK(needs[0].scene == "cube");
  CHECK(needs[0].set.empty());
  CHECK(needs[1].scene == "disc");
  CHECK(needs[1].set == std::vector<std::string>{"scheme.order=1", "material.steel.strength={ type = \"elastic\" }"});
  CHECK(parse_needs("import h5py\n", "fig.py").empty());
}

TEST_CASE("needs that say nothing are refused", "[unit]") {
  for (char const* text : {"# needs:\n", "# needs: cube --set\n", "# needs: cube --set x\n", "# needs: cube disc\n",
                           "# needs: cube --set 'a=b\n"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_needs(text, "fig.py"), InputError);
  }
}

TEST_CASE("the digest of a scene is of what determines its results", "[unit]") {
  SceneFolder const folder;
  std::string const text = head + domain + rest, digest = folder.digest(text);
  SECTION("not of comments, spaces, the title, the order of keys and the way of a number") {
    CHECK(folder.digest("# a remark\n" + text + "\n\n") == digest);
    CHECK(folder.digest("title = 'another'\n" + rest + domain +
                        "[scheme]\norder   =  2 # linear\n[time]\nend = \"5 us\"\n") == digest);
    CHECK(folder.digest(text, {"material.gas.eos={ gamma = 1.40, type = \"ideal\" }"}) == digest);
  }
  SECTION("of keys, also by --set, and of the surface") {
    CHECK(folder.digest(text, {"scheme.order=1"}) != digest);
    CHECK(folder.digest(text, {"time.end=5.1 us"}) != digest);
    for (char const* same : {"5 us", "5us", "5.0 us", "0.005 ms", "\"5000 ns\"", "5e-6"}) {
      INFO(same);
      CHECK(folder.digest(text, {std::string("time.end=") + same}) == digest);
    }
    folder.write_cube(1.01);
    CHECK(folder.digest(text) != digest);
    folder.write_cube(1);
    CHECK(folder.digest(text) == digest);
  }
}

TEST_CASE("coarser grids and quick looks are settings", "[unit]") {
  Document const scene = parse_document(head + domain + rest, "cube.toml");
  CHECK(coarser(scene, 1).empty());
  CHECK(coarser(scene, 2) == std::vector<std::string>{"domain.cell=\"4 mm\"", "body.0.cell=\"3 mm\""});
  Document const twins =
      parse_document(head + domain + rest + "[[variant]]\n[[variant.body]]\ncell = '1 mm'\n", "twins.toml");
  CHECK(coarser(twins, 2).back() == "variant.0.body.0.cell=\"2 mm\"");
  Document shorter = scene;
  set_value(shorter, "time.end=2 us");
  CHECK(quick_look(scene) == std::vector<std::string>{"expect=[]"});
  CHECK(quick_look(shorter) == std::vector<std::string>{"expect=[]", "output.snapshots=[\"1 us\"]"});
  Document counted = scene;
  set_value(counted, "domain.cells=[8, 8, 8]");
  CHECK_THROWS_AS(coarser(counted, 2), InputError);
}
