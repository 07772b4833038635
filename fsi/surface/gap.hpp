#pragma once
/// How near two surfaces are to each other.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Distance of a point to a triangle [m].
double distance(Vec3 const& x, std::array<Vec3, 3> const& triangle) noexcept;

/// Distance of a point to the nearest triangle [m].
double distance(Vec3 const& x, TriangleSurface const& surface) noexcept;

/// Least distance of a vertex of one surface to the other [m], at most `enough`. Edges that cross at a distance from
/// their vertices are taken for farther apart than they are, by less than their length.
double gap_between(TriangleSurface const& a, TriangleSurface const& b, double enough);

/// Whether a point lies within a closed surface.
bool within(Vec3 const& x, TriangleSurface const& surface) noexcept;

/// Distance of a point to the body in a closed surface [m]; 0 within.
double distance_to_body(Vec3 const& x, TriangleSurface const& surface) noexcept;

}  // namespace g27
