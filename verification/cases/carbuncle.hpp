#pragma once
/// Grid-aligned steady shocks with noise: does it grow?
#include <string>

#include "verification/cases/grid_problem.hpp"

namespace g27 {

/// A steady plane shock on a row of faces, gamma = 1.4, periodic along the shock. All variables
/// start with noise of one relative amplitude in every cell; the largest velocity along the shock, over the sound speed
/// behind it, is measured after a number of steps.
Case carbuncle_case(std::string const& name, int dimensions);

}  // namespace g27
