#include "studies/driver/run_record.hpp"

#include "studies/driver/body_history.hpp"
#include "studies/driver/grid_history.hpp"

namespace g27 {

RunRecord::RunRecord(SceneRun const& run)
    : history(run.grid ? History(grid_columns(run.output, run.dimensions())) : History(run.output)) {
  if (run.grid) {
    grid.emplace();
    auto const columns = body_columns(run);
    history.columns().insert(history.columns().end(), columns.begin(), columns.end());
  }
}

}  // namespace g27
