#include "studies/driver/run_record.hpp"

#include "studies/driver/grid_history.hpp"

namespace g27 {

RunRecord::RunRecord(SceneRun const& run)
    : history(run.grid ? History(grid_columns(run.output, run.dimensions())) : History(run.output)) {
  if (run.grid) {
    grid.emplace();
  }
}

}  // namespace g27
