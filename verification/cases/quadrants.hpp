#pragma once
/// Two-dimensional Riemann problems: four uniform states that meet in the middle of the unit square.
#include <array>
#include <string>

#include "verification/cases/grid_problem.hpp"

namespace g27 {

/// The states of the quadrants 1 (right, top), 2 (left, top), 3 (left, bottom), 4 (right, bottom).
struct Quadrants {
  std::string name, title;
  std::array<GasPoint, 4> states;
  double t_end = 0.3;
  bool symmetric = false;  ///< under x <-> y: then the asymmetry is measured
};

/// gamma = 1.4, gas flows out on all sides. No exact solution.
Case quadrants_case(Quadrants const& problem);

}  // namespace g27
