#pragma once
/// Cases with a manufactured solution: waves in all variables, driven by their source terms.
#include <string>

#include "verification/cases/line_problem.hpp"

namespace g27 {

/// Planar: periodic on [0, 1] m. Curved: on [1, 2] m between inflows of the exact state.
Case manufactured_case(std::string const& name, std::string const& title, Symmetry symmetry);

}  // namespace g27
