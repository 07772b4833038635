#pragma once
/// What a boundary of a solid gives its faces.
#include "scheme/kernel/solid_kernels.hpp"
#include "scheme/step/solid_grid_options.hpp"

namespace g27 {

/// Of a wall, a fixed, a traction or a free boundary.
SolidFaceCondition condition_of(SolidBoundary::Kind kind) noexcept;

/// Velocity or traction given on the face at x across `axis`, along x, y, z: mean over the step [t, t + dt], two Gauss
/// points.
Vec3 given_value(SolidBoundary const& boundary, std::size_t axis, Vec3 const& x, double t, double dt);

}  // namespace g27
