#pragma once
/// Sides of the domain that clamp the bodies which they cut: the body is bonded to a rigid wall there.
///
/// A plane of symmetry has the mirror image of the body beyond it. Beyond a clamp the body goes on with the opposite
/// velocity, along the wall too, and the same stress: between a cell and its image the contact of the Riemann problem
/// is at rest and has the cell's traction. To first order in the distance from the wall that is the solid beside a
/// fixed boundary, where the wall-parallel strains vanish; the wall takes the momentum.
#include <array>
#include <cstddef>

namespace g27 {

/// By axis, at its lower and at its upper side.
struct Clamps {
  std::array<bool, 3> low{}, high{};

  [[nodiscard]] bool any() const noexcept { return low[0] || low[1] || low[2] || high[0] || high[1] || high[2]; }
  /// side: -1 the lower, 1 the upper one, 0 none.
  [[nodiscard]] bool at(std::size_t axis, int side) const noexcept {
    return side != 0 && (side < 0 ? low : high)[axis];
  }
};

}  // namespace g27
