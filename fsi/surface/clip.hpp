#pragma once
/// Parts of surfaces on one side of a plane of symmetry, and wholes from parts.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// The part of a surface where x[axis] >= at, or <= at, open where the plane cuts the body; the border lies on the
/// plane exactly. Vertices nearer to the plane than `snap` [m] are moved onto it first, along the axis, so that no
/// slivers come about; of a body that the plane is a symmetry of they slide on the surface. Throws SurfaceError if
/// nothing is left.
TriangleSurface clip_surface(TriangleSurface surface, std::size_t axis, double at, bool above, double snap);

/// The surface and its mirror image beyond the plane x[axis] = at, joined at the vertices on the plane.
TriangleSurface unfolded(TriangleSurface surface, std::size_t axis, double at);

}  // namespace g27
