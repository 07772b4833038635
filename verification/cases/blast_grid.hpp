#pragma once
/// Sedov's explosion and Noh's implosion on Cartesian grids: a quadrant or an octant between symmetry walls.
#include <string>

#include "verification/cases/grid_problem.hpp"

namespace g27 {

/// gamma = 1.4, gas at 1 and p = 1e-8; all the energy starts in one cell at the origin, or in a cube of some, and the
/// shock reaches r = 1 at the end, t = 1. Two dimensions: cylindrical; three: spherical.
Case sedov_grid_case(std::string const& name, int dimensions);

/// gamma = 5/3, gas at 1 falling in at 1 from everywhere until t = 0.6; the cold gas has p = 1e-8.
Case noh_grid_case(std::string const& name, int dimensions);

}  // namespace g27
