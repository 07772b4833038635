#pragma once
/// Which triangles of a surface touch: across edges, around vertices, in shells.
#include <span>

#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// One side of a triangle. Side e leads from corner e to corner e + 1 (mod 3).
struct TriangleSide {
  int low, high;  ///< vertices of the edge, low <= high
  int triangle, side;
  bool rising;  ///< the side leads from low to high
};

/// Every side of every triangle, those of one edge together: sorted by (low, high, triangle, side).
std::vector<TriangleSide> sides_by_edge(TriangleSurface const& surface);

/// Calls f with the sides of each edge.
template <class F>
void for_each_edge(std::vector<TriangleSide> const& sides, F const& f) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high) ++last;
    f(std::span(sides).subspan(first, last - first));
  }
}

struct Adjacency {
  static constexpr int open = -1, non_manifold = -2;
  /// [triangles]: the triangle across side e; `open` where there is none, `non_manifold` where there are several
  std::vector<std::array<int, 3>> beside;
  /// [triangles]: shell, from 0 in the order of the triangles: what is connected across edges of two triangles
  std::vector<int> shell;
  int shells = 0;

  /// Triangles that have the vertex as a corner, ascending.
  [[nodiscard]] std::span<int const> around(int vertex) const noexcept {
    auto const v = static_cast<std::size_t>(vertex);
    return std::span(stars).subspan(static_cast<std::size_t>(first[v]),
                                    static_cast<std::size_t>(first[v + 1] - first[v]));
  }

  std::vector<int> first, stars;  ///< [vertices + 1], [3 triangles]
};

Adjacency adjacency(TriangleSurface const& surface);

}  // namespace g27
