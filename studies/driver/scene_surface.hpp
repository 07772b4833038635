#pragma once
/// The surface of a body: from its file to triangles in place, of the size of the cells.
#include "studies/driver/scene.hpp"
#include "studies/driver/section.hpp"

namespace g27 {

struct LoadedSurface {
  TriangleSurface surface;           ///< healthy [m]
  std::uint64_t fingerprint = 0;     ///< of the file's bytes
  std::vector<std::string> remarks;  ///< repairs
};

/// `surface` and `scale` of a [[body]]: read beside the scene's file, examined, and repaired where that cannot change
/// the body. What cannot be repaired is refused in the words of `g27 stl`.
LoadedSurface load_surface(Section const& body);

/// Moves the centroid to `center` and turns the body about it by `rotate`.
void place_surface(Section const& body, TriangleSurface& surface);

/// Triangles anew where edges are shorter than 0.4 or longer than 1.7 cells; says so.
void mesh_surface(Section const& body, double cell, LoadedSurface& loaded);

}  // namespace g27
