#pragma once
/// Cases in two and three dimensions with a manufactured solution.
#include <string>

#include "verification/cases/grid_problem.hpp"

namespace g27 {

/// Waves in all variables, each in its own oblique direction, periodic on the unit box.
Case manufactured_grid_case(std::string const& name, int dimensions);

}  // namespace g27
