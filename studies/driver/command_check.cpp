#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riemann/eos/factory.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/early_end.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/scene_check.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/table.hpp"

namespace g27 {

namespace {

/// "spherical" of a line, "64 x 64 x 32" of a grid.
std::string mesh_text(SceneRun const& run) {
  if (!run.grid) {
    return symmetry_names()[static_cast<std::size_t>(run.setup.symmetry)];
  }
  auto const& n = run.grid->setup.cells;
  return run.dimensions() == 3 ? fmt::format("{} x {} x {}", n[0], n[1], n[2]) : fmt::format("{} x {}", n[0], n[1]);
}

nlohmann::ordered_json bodies_json(RunEstimate const& e, SceneRun const& run) {
  auto out = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < e.bodies.size(); ++n) {
    BodyEstimate const& b = e.bodies[n];
    out.push_back({{"name", b.name},
                   {"triangles", b.triangles},
                   {"edges_over_cell", {b.shortest, b.longest}},
                   {"cells", b.cells},
                   {"grid_cells", b.window},
                   {"volume", b.volume},
                   {"mass", b.mass},
                   {"memory", b.bytes},
                   {"surface", {b.from, b.to}},
                   {"extent", {b.lower, b.upper}},
                   {"remarks", run.grid->bodies[n].remarks}});
  }
  return out;
}

/// Of one run: variants differ in names.
Table bodies_table(RunEstimate const& e) {
  Table table{.name = "bodies",
              .title = "Bodies of " + e.name,
              .columns = {{"body", "1"},
                          {"triangles", "1"},
                          {"edges", "cells"},
                          {"cells in it", "1"},
                          {"cells of its grid", "1"},
                          {"mass", "kg"},
                          {"memory", "MB"},
                          {"may go to", "m"}},
              .rows = {},
              .facts = {}};
  for (BodyEstimate const& b : e.bodies) {
    std::string way;
    for (std::size_t a = 0; a < 3; ++a) {
      way += fmt::format("{}{} {:.4g} to {:.4g}", a > 0 ? ", " : "", ray_names()[a], b.lower[a], b.upper[a]);
    }
    table.rows.push_back({b.name, b.triangles, fmt::format("{:.2f} to {:.2f}", b.shortest, b.longest),
                          std::round(b.cells), b.window, b.mass, b.bytes / 1e6, way});
  }
  return table;
}

}  // namespace

int command_check(CheckArguments const& arguments) {
  auto const file = find_scene(arguments.scene);
  Scene const scene = read_scene(file, without_what_is_beyond(file, arguments.set));
  require_memory(scene);
  auto const estimates = estimate(scene);
  double seconds = 0, bytes = 0;
  for (RunEstimate const& e : estimates) {
    seconds += e.seconds;
    bytes += e.bytes;
  }
  auto const judged =
      std::count_if(scene.expect.begin(), scene.expect.end(), [](Expectation const& e) { return e.judged; });
  if (arguments.json) {
    nlohmann::ordered_json json{{"scene", scene.name},
                                {"title", scene.title},
                                {"runs", nlohmann::ordered_json::array()},
                                {"expectations", scene.expect.size()},
                                {"judged", judged},
                                {"seconds", seconds},
                                {"bytes", bytes},
                                {"bare_numbers", scene.bare_numbers},
                                {"remarks", remarks_on(scene)}};
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      SceneRun const& run = scene.runs[i];
      json["runs"].push_back({{"name", run.name},
                              {"variant", run.variant},
                              {"scheme", run.scheme},
                              {"eos", eos_name(run.eos())},
                              {"symmetry", mesh_text(run)},
                              {"dimensions", run.dimensions()},
                              {"cells", estimates[i].cells},
                              {"start_s", run.start},
                              {"end_s", run.end},
                              {"steps", estimates[i].steps},
                              {"seconds", estimates[i].seconds},
                              {"bytes", estimates[i].bytes},
                              {"memory", estimates[i].memory},
                              {"line_steps", estimates[i].line_steps}});
      if (!estimates[i].bodies.empty()) json["runs"].back()["bodies"] = bodies_json(estimates[i], run);
    }
    fmt::print("{}\n", json.dump(2));
    return 0;
  }
  Table table{.name = "check",
              .title = scene.title,
              .columns = {{"run", "1"},
                          {"mesh", "1"},
                          {"eos", "1"},
                          {"cells", "1"},
                          {"from", "us"},
                          {"to", "us"},
                          {"steps", "1"},
                          {"time", "s"},
                          {"file", "MB"},
                          {"memory", "MB"}},
              .rows = {},
              .facts = {}};
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    SceneRun const& run = scene.runs[i];
    RunEstimate const& e = estimates[i];
    table.rows.push_back({e.name, mesh_text(run), eos_name(run.eos()), static_cast<long>(e.cells), run.start * 1e6,
                          run.end * 1e6, e.steps, e.seconds, e.bytes / 1e6, e.memory / 1e6});
  }
  fmt::print("{}\nabout {} on one thread, {:.1f} MB; {} figures to judge\n", to_text(table), duration_text(seconds),
             bytes / 1e6, judged);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    if (!estimates[i].bodies.empty()) fmt::print("{}\n", to_text(bodies_table(estimates[i])));
  }
  for (std::string const& remark : remarks_on(scene)) fmt::print("{}\n", remark);
  if (scene.bare_numbers.empty()) {
    fmt::print("every number with a dimension carries its unit\n");
  } else {
    fmt::print("read as SI, for want of a unit:\n");
    for (auto const& note : scene.bare_numbers) {
      fmt::print("  {}\n", note);
    }
  }
  return 0;
}

}  // namespace g27
