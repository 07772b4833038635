#pragma once
/// References by a fine grid, for problems without an exact solution.
///
/// The reference is another scheme than any it judges (MUSCL-Hancock with HLLC fluxes) on a grid so fine that its own
/// error is small beside theirs; the study of shock tubes states how small, from its convergence.
#include "verification/cases/line_problem.hpp"

namespace g27 {

/// Cell means of the fine-grid solution of `problem` at its end, over any cell. Computed once and kept per `name`.
CellMean fine_grid_reference(std::string const& name, LineProblem const& problem, int cells);

}  // namespace g27
