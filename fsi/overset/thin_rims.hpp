#pragma once
/// Rims and tips of a body that are thinner than two of its cells.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Once the cloud is set: where the body does not hold the second layer of a triangle's cores, the velocities of both
/// go by a share to those of the solid around them. Nothing but these cores has the solid there, and rims that a blast
/// has drawn out would flap on their own. Fields that are linear in space stay as they are. Whether any triangle was
/// tied.
bool tie_thin_rims(Body& body);

}  // namespace g27
