#pragma once
/// Few changes to a surface that deforms: only where its triangles have become too long, too short or too flat.
#include <cstdint>

#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

struct LocalRemeshOptions {
  double shortest, longest;   ///< edges beyond are joined or parted [m]
  double height = 0.12;       ///< of a triangle over its longest edge: below, it is mended
  double feature_angle = 40;  ///< edges where the normals turn by more are sharp: parted and joined along themselves
};

struct LocalRemeshCounts {
  std::uint64_t splits = 0, collapses = 0, flips = 0, moves = 0;
  std::uint64_t refused = 0;  ///< calls whose result would have met itself: the surface stayed as it was
  double volume = 0;          ///< change of the volume, sum of the absolute values [m^3]
  void add(LocalRemeshCounts const& o) noexcept {
    splits += o.splits, collapses += o.collapses, flips += o.flips, moves += o.moves, refused += o.refused;
    volume += o.volume;
  }
};

struct LocalRemesh {
  TriangleSurface surface;
  std::vector<std::vector<int>> parents;  ///< [new triangle]: the old ones whose place it has taken, ascending
  LocalRemeshCounts counts;
};

/// Whether a surface has an edge or a triangle that local_remesh() would change.
bool needs_remeshing(TriangleSurface const& surface, LocalRemeshOptions const& options);

/// Long edges are parted at their middle, short ones joined, edges between flat triangles turned, vertices of flat ones
/// shifted along the surface. Joining and shifting keep the volume: it is linear in the place of one vertex, which is
/// corrected along the mean normal of the triangles around it; at corners and where an edge is turned it may change a
/// little. A change that would turn a normal by more than 40 degrees or make a worse triangle is left out. The border
/// of an open surface is parted and joined where it lies in a plane across an axis, along that plane. Needs a manifold
/// surface; throws std::invalid_argument.
LocalRemesh local_remesh(TriangleSurface const& surface, LocalRemeshOptions const& options);

}  // namespace g27
