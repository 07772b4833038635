#pragma once
/// How a body turns as a whole.
#include "fsi/surface/vec3.hpp"

namespace g27 {

struct Body;

/// Angular velocity [1/s] of the rigid motion that the velocities of a body's surface are nearest to, by least squares
/// over its area, images beyond planes of symmetry included.
Vec3 spin_of(Body const& body);

}  // namespace g27
