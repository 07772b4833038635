#pragma once
/// Rims and tips of a body that are thinner than three of its cells.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Once the cloud is set: where the body does not hold the third layer of a triangle's local grid, the velocities of
/// the two cores go part of the way, more in a longer step, to those of the solid around them. Nothing but these cores
/// has the solid there, and rims that a blast has drawn out would flap on their own; at the tips of a regular
/// tetrahedron round-off grows twentyfold in 100 steps, unless they are tied. Fields that are linear in space stay as
/// they are. Whether any triangle was tied.
bool tie_thin_rims(Body& body, double dt);

}  // namespace g27
