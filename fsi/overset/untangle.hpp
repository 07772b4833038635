#pragma once
/// A surface that has run through itself or through a plane of symmetry is drawn back.
#include <cstdint>

#include "fsi/overset/mirrors.hpp"
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

struct Untangled {
  std::uint64_t moved = 0;  ///< vertices, each as often as it was moved
  bool clear = true;        ///< no triangle meets another, no vertex lies beyond a plane
};

/// Where a rim is thinner than a triangle is wide, or a fold closes, the two sides go through one another by and by: no
/// grid resolves what is between. Vertices of triangles that meet, and of those around them, go half of the way to the
/// middle of their neighbours, along the planes that hold them, until no triangle meets another; twenty times at most.
Untangled untangle(TriangleSurface& surface, Cut const& cut);

}  // namespace g27
