/// What a run on a grid has left out.
#include <fmt/format.h>

#include <algorithm>

#include "studies/driver/scene_run.hpp"

namespace g27 {

Saved saved_by(GridRecord const& grid) {
  GridCounters const& c = grid.restart.counters;
  Saved out;
  out.updates = static_cast<double>(c.cell_updates);
  auto const skipped = static_cast<double>(c.cells_skipped);
  double const all = std::max(out.updates + skipped, 1.0);
  out.skipped_share = skipped / all;
  out.unstored_share = grid.cells > 0 ? std::max(0.0, 1 - grid.cells_stored / grid.cells) : 0.0;
  out.weak_share = static_cast<double>(c.linear_star) / std::max(1.0, static_cast<double>(c.faces));
  out.line_updates = grid.line.grid_steps * grid.cells;
  out.factor = (all + out.line_updates) / std::max(out.updates, 1.0);
  return out;
}

Table saved_table(Scene const& scene, SceneResult const& result) {
  Table table{.name = "saved",
              .title = "Left out (scheme.skip, scheme.linear_star, [start])",
              .columns = {{"run", "1"},
                          {"uniform tiles", "% of updates"},
                          {"not stored", "% of cells"},
                          {"weak faces", "% of faces"},
                          {"line until", "us"},
                          {"ended by", "1"},
                          {"line steps", "1"},
                          {"grid steps spared, at least", "1"},
                          {"work saved", "factor"}},
              .rows = {},
              .facts = {}};
  for (SceneRun const& run : scene.runs) {
    auto const found = result.records.find(run.name);
    if (found == result.records.end() || !found->second.grid) {
      continue;
    }
    GridRecord const& grid = *found->second.grid;
    Saved const saved = saved_by(grid);
    bool const line = !grid.line.ended_by.empty();
    auto const of_line = [&](double value, char const* form) {
      return line ? fmt::format(fmt::runtime(form), value) : std::string("-");
    };
    table.rows.push_back({run.name, 100 * saved.skipped_share, 100 * saved.unstored_share, 100 * saved.weak_share,
                          of_line(grid.line.time * 1e6, "{:.4g}"), line ? grid.line.ended_by : "-",
                          of_line(grid.line.steps, "{:.0f}"), of_line(grid.line.grid_steps, "{:.0f}"), saved.factor});
  }
  return table;
}

}  // namespace g27
