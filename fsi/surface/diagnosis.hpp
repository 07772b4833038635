#pragma once
/// What is wrong with a surface, by triangle, and what its triangles are like.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

enum class Fault : int {
  degenerate,                ///< a height below 1e-6 of the longest edge
  duplicate,                 ///< the same three vertices as an earlier triangle
  open_edge,                 ///< one triangle alone at an edge: the surface is not watertight
  non_manifold_edge,         ///< more than two triangles at an edge
  non_manifold_vertex,       ///< the triangles around a vertex are more than one fan
  inconsistent_orientation,  ///< two triangles lead along their edge in the same direction
  inward,                    ///< the normals of a shell point into the body
  no_volume,                 ///< a shell encloses less than 1e-6 of (its area)^(3/2)
  self_intersection          ///< triangles meet elsewhere than in their common edge or vertex
};

/// "open edges"
std::string fault_name(Fault fault);
/// What to do about it.
std::string fault_remedy(Fault fault);

struct SurfaceFinding {
  Fault fault;
  std::size_t count;           ///< of the edges, vertices, shells or triangles at fault
  std::vector<int> triangles;  ///< that are involved, ascending
};

struct EdgeLengths {
  double smallest = 0, mean = 0, largest = 0;  ///< [m]
  int at_smallest = 0;                         ///< a triangle there
};

/// Angle within the body between two triangles at an edge: below pi where the surface is convex [rad].
struct DihedralAngles {
  double smallest = 0, largest = 0;
  std::array<int, 2> at_smallest{}, at_largest{};  ///< the two triangles there
};

struct Diagnosis {
  std::vector<SurfaceFinding> findings;
  int shells = 0;
  BoundingBox box{};
  EdgeLengths edges;
  DihedralAngles angles;  ///< pi if no two triangles meet at an edge

  [[nodiscard]] bool healthy() const noexcept { return findings.empty(); }
  [[nodiscard]] SurfaceFinding const* find(Fault fault) const noexcept {
    for (SurfaceFinding const& f : findings) {
      if (f.fault == fault) return &f;
    }
    return nullptr;
  }
};

/// Examines a surface with at least one triangle. Inward shells are looked for where nothing else is wrong with the
/// surface, for they are not defined before.
Diagnosis diagnose(TriangleSurface const& surface);

/// Lengths of the edges, each edge once [m].
std::vector<double> edge_lengths(TriangleSurface const& surface);

/// Height over its longest edge, relative to that: 0.87 equilateral, 0 degenerate.
double relative_height(TriangleSurface const& surface, std::size_t triangle);
inline constexpr double degenerate_height = 1e-6;

}  // namespace g27
