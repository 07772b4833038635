#pragma once
/// Advances one run of a scene from its start, or from where it was interrupted, to its end.
#include <functional>
#include <stdexcept>

#include "studies/driver/run_record.hpp"

namespace g27 {

/// The scheme could not continue; exit status 1.
struct RunFailure : std::runtime_error {
  RunFailure(std::string const& what, std::string capsule_) : std::runtime_error(what), capsule(std::move(capsule_)) {}
  std::string capsule;  ///< JSON: cell, stencil and inputs
};

struct RunHooks {
  /// fraction done in [0, 1]; called about ten times a second
  std::function<void(double fraction)> progress;
  /// called every `checkpoint_s` of wall time with a record that can be resumed
  std::function<void(RunRecord const&)> checkpoint;
  double checkpoint_s = 30;
  /// called with every state of a grid that is to be kept; a line's are in the record
  std::function<void(std::size_t index, GridSnapshot const&)> snapshot{};
  /// true: stop after this step, with a record that can be resumed
  std::function<bool()> interrupted;
};

/// Continues `record` (empty, or read back from a checkpoint). Resuming changes no bit of the result. Throws
/// RunFailure.
void simulate(SceneRun const& run, RunRecord& record, RunHooks const& hooks);

/// A line at the run's initial state.
GasLine make_line(SceneRun const& run);

/// Share of the run's duration below which a time step counts as vanished: such a run would never end.
inline constexpr double least_step = 1e-8;

std::string step_status_text(StepStatus status);

}  // namespace g27
