#pragma once
/// Shu and Osher's problem on a line, which cases in more dimensions share.
#include "verification/cases/line_problem.hpp"

namespace g27 {

/// Mach 3 shock at x = -4 m, running into the density wave 1 + 0.2 sin 5x; on [-5, 5] m until 1.8 s.
LineProblem shu_osher_problem();

/// Its fine-grid solution at the end.
CellMean shu_osher_reference();

/// The state outside that drives it: the shocked gas behind the shock as if the density were uniform, the wave ahead.
GasState<> shu_osher_outside(double x, double t);

}  // namespace g27
