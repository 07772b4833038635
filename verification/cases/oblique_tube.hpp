#pragma once
/// Shock tubes at an angle to the grid.
#include <numbers>
#include <string>

#include "verification/cases/grid_problem.hpp"

namespace g27 {

/// arctan of the golden section: no row of cells ever meets the front as another row did
inline constexpr double irrational_tangent = 0.61803398874989485;

/// Sod's tube along x, periodic along y.
Case sod_aligned_case(std::string const& name);
/// Sod's tube at 45 degrees, on a periodic box of 2 m: a layer of the dense gas between two diaphragms, whose waves
/// have not met by the end.
Case sod_diagonal_case(std::string const& name);
/// Sod's tube at any angle, tan = `tangent`, on a box of 2 m between inflows of the exact solution; compared within
/// 0.5 m of the centre, where nothing from the sides arrives before the end.
Case sod_oblique_case(std::string const& name, double tangent);

/// Shu and Osher's problem along x, periodic along y.
Case shu_osher_aligned_case(std::string const& name);
/// The same at an angle, on a box of 12.8 m; compared in a strip along its normal, 0.8 m wide, that nothing from the
/// sides reaches at the speed of sound.
Case shu_osher_oblique_case(std::string const& name, double tangent);

}  // namespace g27
