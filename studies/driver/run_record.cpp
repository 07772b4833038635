#include "studies/driver/run_record.hpp"

#include <algorithm>

#include "studies/driver/body_history.hpp"
#include "studies/driver/grid_history.hpp"

namespace g27 {

void add(LedgerEntry& total, LedgerEntry const& piece) {
  total.current = piece.current;
  total.through_boundary += piece.through_boundary;
  total.from_source += piece.from_source;
  total.from_floor += piece.from_floor;
  total.scale = std::max(total.scale, piece.scale);
}

RunRecord::RunRecord(SceneRun const& run)
    : history(run.grid ? History(grid_columns(run.output, run.dimensions())) : History(run.output)) {
  if (run.grid) {
    grid.emplace();
    auto const columns = body_columns(run);
    history.columns().insert(history.columns().end(), columns.begin(), columns.end());
  }
}

}  // namespace g27
