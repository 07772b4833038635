#pragma once
/// Repairs of a surface that cannot change the body: what they did is said, what is not safe is left as it is.
#include "fsi/surface/diagnosis.hpp"

namespace g27 {

struct RepairStep {
  std::string what;            ///< "removed duplicate triangles"
  std::size_t count;           ///< of them
  std::vector<int> triangles;  ///< that it removed or changed, as numbered in the surface given
};

struct Repair {
  TriangleSurface surface;
  std::vector<int> origin;  ///< [triangles] number in the surface given; -1: new
  std::vector<RepairStep> steps;
  Diagnosis diagnosis;  ///< of the repaired surface: healthy, or what was not safe to repair
};

/// Repairs, in this order: triangles without three vertices and duplicates are removed; vertices at open edges that are
/// closer than 1e-5 of the diagonal of the box are welded; the triangles of a shell are given one orientation; holes of
/// three edges, or of up to eight that take up to 2 % of the area, are closed; degenerate triangles are collapsed or
/// flipped away; shells are turned outward, cavities inward. Where edges are not manifold, or a shell has one side
/// only, the later steps are left out.
Repair repair(TriangleSurface const& surface);

}  // namespace g27
