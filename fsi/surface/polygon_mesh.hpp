#pragma once
/// Questions about a surface that need exact arithmetic.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Pairs of triangles that have a point in common besides a common vertex or edge; triangles with three common vertices
/// or without area are left out. Any surface will do. Stops after `limit` pairs.
std::vector<std::array<int, 2>> self_intersections(TriangleSurface const& surface, std::size_t limit = 10000);

/// [triangles] true where a shell must be turned, so that outer shells face outward, cavities in them inward, bodies in
/// the cavities outward again. Needs closed, manifold, consistent shells that do not intersect.
std::vector<bool> inward_triangles(TriangleSurface const& surface);

/// Triangles between the points of a closed polygon, by their indices and in its sense; as small in area as dihedral
/// angles allow. Empty where there are none.
std::vector<Triangle> triangulate_polygon(std::vector<Vec3> const& points);

}  // namespace g27
