#pragma once
/// Advances a run on a grid: a first phase on a line where the scene asks for one, then the grid.
#include "studies/driver/simulate.hpp"

namespace g27 {

/// As simulate().
void simulate_grid(SceneRun const& run, RunRecord& record, RunHooks const& hooks);

/// A grid without a state. Throws InputError for a setup that the scheme refuses.
GasGrid make_grid(SceneRun const& run);

/// Whether the phase on the line is over; why goes to `ended_by`.
bool line_phase_over(LineStart const& start, GasGridSetup const& grid, GasLine const& line, LinePhase& phase);

/// The line of the first phase at the start of the run.
GasLine make_start_line(LineStart const& start, double time);

}  // namespace g27
