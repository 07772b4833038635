#pragma once
/// A sphere of explosive that detonates from its centre by programmed burn, held against the exact self-similar wave.
#include "verification/cases/case.hpp"

namespace g27 {

/// On a line in spherical symmetry, or on an octant in three dimensions; up to shortly before the front leaves.
Case detonation_line_case(std::string const& name);
Case detonation_grid_case(std::string const& name);

}  // namespace g27
