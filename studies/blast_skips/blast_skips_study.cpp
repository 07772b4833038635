/// What the scene of a charge between two cubes leaves out: each skip alone and all together, time saved and difference
/// made.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/stl_file.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/atomic_file.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"
#include "studies/driver/study.hpp"

namespace g27 {
namespace {

/// How a run begins.
enum class Begin {
  on_grid,   ///< lit at t = 0, burnt on the grid
  on_line,   ///< lit at t = 0, burnt on a line until the wave has left the charge
  breakout,  ///< the exact wave when it has burnt the charge, then a line until the wave is at the body
};

struct Choice {
  char const* name;
  bool whole, tiles, faces;
  Begin begin;
  bool yields = true;  ///< else the cubes are elastic, and keep their shape
};
constexpr std::array choices{
    Choice{"nothing", true, false, false, Begin::on_grid},
    Choice{"what is at rest", true, true, false, Begin::on_grid},
    Choice{"Riemann solver on weak faces", true, false, true, Begin::on_grid},
    Choice{"burning in 3D: a line", true, false, false, Begin::on_line},
    Choice{"burning: from breakout", true, false, false, Begin::breakout},
    Choice{"seven of eight octants", false, false, false, Begin::on_grid},
    Choice{"rest, octants, from breakout", false, true, false, Begin::breakout},
    Choice{"rest, octants, a line", false, true, false, Begin::on_line},
    Choice{"rest, octants", false, true, false, Begin::on_grid},
    Choice{"rest, octants, weak faces", false, true, true, Begin::on_grid},
    Choice{"elastic: nothing", true, false, false, Begin::on_grid, false},
    Choice{"elastic: Riemann solver on weak faces", true, false, true, Begin::on_grid, false},
    Choice{"elastic: seven of eight octants", false, false, false, Begin::on_grid, false},
    Choice{"elastic: rest, octants", false, true, false, Begin::on_grid, false},
};
constexpr std::size_t rest = 1, faces = 2, octant = 5, all = 6, same_start = 8;
constexpr std::size_t elastic = 10, elastic_faces = 11, elastic_octant = 12, elastic_same_start = 13;

constexpr double end_us = 20;

/// A cube of edge 1 with triangles that are mirror images of each other, in no need to be meshed anew: parts of it are
/// then the same body as the whole.
void write_cube(std::filesystem::path const& file) {
  constexpr int squares = 4;  // along half an edge: of .88 cells, with diagonals of 1.24
  std::vector<std::array<Vec3, 3>> facets;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const corner = [&](int i, int j) {
      Vec3 x{};
      x[axis] = 0.5, x[(axis + 1) % 3] = 0.5 * i / squares, x[(axis + 2) % 3] = 0.5 * j / squares;
      return x;
    };
    for (int i = 0; i < squares; ++i) {
      for (int j = 0; j < squares; ++j) {
        facets.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
        facets.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
    }
  }
  TriangleSurface cube = weld(facets, 1);
  for (std::size_t axis = 0; axis < 3; ++axis) cube = unfolded(cube, axis, 0);
  write_atomically(file, binary_stl(cube));
}

std::string scene_of(Choice const& c, std::filesystem::path const& surface) {
  std::string text = fmt::format(R"(
title = "A steel cube of 0.92 g beside a detonating sphere; left out: {}"
[time]
end = "{} us"
cfl = 0.95
[scheme]
order       = 2
closure     = true
skip        = {}
linear_star = {}
)",
                                 c.name, end_us, c.tiles, c.faces);
  text += c.whole ? R"([domain]
extent   = [["-6 cm", "6 cm"], ["-6 cm", "6 cm"], ["-10.5 cm", "10.5 cm"]]
cell     = "3 mm"
boundary = { others = "outflow" }
)"
                  : R"([domain]
extent   = [["0 cm", "6 cm"], ["0 cm", "6 cm"], ["0 cm", "10.5 cm"]]
cell     = "3 mm"
boundary = { x_low = "symmetry", y_low = "symmetry", z_low = "symmetry", others = "outflow" }
)";
  text += R"([material.products]
eos = { type = "jwl", A = "708.6056 GPa", B = "13.16457 GPa", R1 = 4.94, R2 = 1.35, omega = 0.28, rho0 = "1.65 g/cm3" }
[material.steel]
density  = "7.8 g/cm3"
eos      = { type = "bulk-modulus", K = "175 GPa" }
)";
  text += c.yields ? R"(strength = { type = "von-mises", shear = "80.77 GPa", yield = "340 MPa", hardening = "240 MPa" }
)"
                   : R"(strength = { type = "elastic", shear = "80.77 GPa" }
)";
  text += R"([ambient]
material = "products"
density  = "1.2 kg/m3"
pressure = "1 bar"
[[charge]]
material = "products"
center   = ["0 cm", "0 cm", "0 cm"]
radius   = "5 cm"
density  = "1.65 g/cm3"
energy   = "8.2 GJ/m3"
)";
  text += fmt::format("start = \"{}\"\n", c.begin == Begin::breakout ? "breakout" : "ignition");
  if (c.begin != Begin::on_grid) text += "[start]\none_dimensional_radius = \"5.5 cm\"\n";
  auto const cube = [&](char const* name, char const* centre, char const* extent) {
    return fmt::format(R"([[body]]
name     = "{}"
surface  = '{}'
scale    = "0.49 cm"
center   = ["0 cm", "0 cm", "{}"]
material = "steel"
cell     = "0.7 mm"
extent   = [["-1.54 cm", "1.54 cm"], ["-1.54 cm", "1.54 cm"], [{}]]
)",
                       name, surface.string(), centre, extent);
  };
  text += cube("cube", "6.5 cm", R"("5.8 cm", "8.5 cm")");
  if (c.whole) text += cube("opposite", "-6.5 cm", R"("-8.5 cm", "-5.8 cm")");
  return text + "[output]\nevery = \"0.1 us\"\n";
}

struct Outcome {
  std::vector<double> velocity;  ///< of the cube along the axis, every 0.1 us [m/s]
  double cpu = 0;                ///< [s]
  double steps = 0;
};

Outcome outcome_of(Choice const& c, std::size_t number, StudyContext const& context) {
  auto const folder = context.out / fmt::format("run-{}", number);
  std::filesystem::create_directories(folder);
  write_atomically(folder / "scene.toml", scene_of(c, std::filesystem::absolute(context.out / "cube.stl")));
  Scene const scene = read_scene(folder / "scene.toml", {});
  double const start = process_cpu_seconds();
  SceneResult const result = run_whole(scene, folder, 1);  // the CPU time of several counts their waiting
  RunRecord const& record = result.records.begin()->second;
  return {record.history["body/cube/velocity_z"], process_cpu_seconds() - start,
          static_cast<double>(record.counters().steps)};
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "skips",
              .title = fmt::format(
                  "Cubes on both sides of a detonating sphere, to {} us: CPU time of the whole run over that of "
                  "one that leaves something out",
                  end_us),
              .columns = {{"left_out", "1"},
                          {"steps", "1"},
                          {"cpu", "s"},
                          {"factor", "1"},
                          {"velocity", "m/s"},
                          {"difference", "%"},
                          {"identical", "1"}},
              .rows = {},
              .facts = {}};
  write_cube(context.out / "cube.stl");
  std::vector<Outcome> outcomes;
  auto const last = [&](std::size_t n) { return outcomes[n].velocity.back(); };
  for (std::size_t n = 0; n < choices.size(); ++n) {
    if (context.progress) {
      context.progress(static_cast<double>(n) / choices.size(), fmt::format("left out: {}", choices[n].name));
    }
    outcomes.push_back(outcome_of(choices[n], n, context));
    std::size_t const plain = choices[n].yields ? 0 : elastic;
    bool const same = outcomes[n].velocity == outcomes[plain].velocity;
    table.rows.push_back({std::string(choices[n].name), outcomes[n].steps, outcomes[n].cpu,
                          outcomes[plain].cpu / outcomes[n].cpu, last(n), 100 * (last(n) / last(plain) - 1),
                          std::string(same ? "yes" : "no")});
  }
  bool const same = outcomes[rest].velocity == outcomes[0].velocity;
  double const factor = outcomes[0].cpu / outcomes[all].cpu;
  auto const change = [&](std::size_t n, std::size_t plain) { return 100 * std::fabs(last(n) / last(plain) - 1); };
  auto const judge = [&](std::string const& what, std::size_t n, std::size_t of_elastic) {
    double const crushed = change(n, 0), kept = change(of_elastic, elastic);
    return Finding{what + " changes the final velocity by .1 % at most",
                   fmt::format("{:.4f} % of elastic cubes, {:.4f} % of crushed ones", kept, crushed),
                   std::max(crushed, kept) <= 0.1};
  };
  double const without_start = outcomes[0].cpu / outcomes[same_start].cpu;
  return {
      {table},
      {{"leaving out what is at rest changes no bit of the cube's velocity", same ? "identical" : "DIFFERENT", same},
       judge("the acoustic star state on weak faces", faces, elastic_faces),
       judge("an octant between planes of symmetry", octant, elastic_octant),
       judge("what is at rest and seven octants, together", same_start, elastic_same_start),
       {"with the start from breakout they save a factor of 5 at least", fmt::format("{:.2f}", factor), factor >= 5},
       {"so they do without it", fmt::format("{:.2f}", without_start), without_start >= 5}}};
}

}  // namespace

Study blast_skips_study() {
  return {"blast-skips",
          "the scene of a charge between bodies leaves out what it does not need, at a measured difference", run};
}

}  // namespace g27
