#pragma once
/// Motion of the surface along its normals alone: the planes of triangles move with the normal velocities of their
/// contacts, and vertices go where these planes meet.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Velocity of a vertex [m/s]: the shortest of which, by least squares over the triangles around, each has its own
/// along its normal. Where they lie in one plane it is along their normal, at corners and edges it keeps these sharp.
Vec3 along_normals(Body const& body, std::size_t vertex);

}  // namespace g27
