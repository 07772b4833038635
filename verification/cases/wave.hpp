#pragma once
/// Cases that are simple waves: smooth, nonlinear, exact for every convex law until they break.
#include <string>

#include "verification/cases/line_problem.hpp"
#include "verification/cases/media.hpp"

namespace g27 {

/// One sine of velocity in [0, 1] m, running to the right on a medium that moves at 0.3 of its sound speed, periodic.
/// `amplitude` over the sound speed; `periods` of the carrying characteristic.
Case wave_case(std::string const& name, std::string const& title, double amplitude, double periods);

}  // namespace g27
