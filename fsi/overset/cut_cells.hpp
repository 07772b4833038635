#pragma once
/// The parts of cells that lie within closed surfaces.
#include "fsi/overset/window.hpp"

namespace g27 {

/// Part of a cell within the surfaces, and the sum of the places of its pieces.
struct CellPart {
  std::size_t cell = 0;  ///< of the window
  double share = 0;      ///< of the cell, > 0
  Vec3 moment{0, 0, 0};  ///< share times the part's centre [m]
};

/// Ascending, by `rays` x `rays` lines along x through each cell, for the surfaces as they were classified.
std::vector<CellPart> parts_within(CellKinds const& kinds, int rays);

}  // namespace g27
