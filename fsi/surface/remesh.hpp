#pragma once
/// Triangles of a wanted size on the same body.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

struct RemeshOptions {
  double edge;                ///< wanted length of the edges [m]
  double feature_angle = 40;  ///< edges where the normals turn by more than this are kept [degrees]
  int iterations = 10;
};

/// Isotropic remeshing (Botsch and Kobbelt 2004, by CGAL). Sharp edges are first parted into pieces of equal length and
/// then kept as they are, corners included; the vertices between them slide on the given surface. Needs a healthy
/// surface; throws SurfaceError if the wanted edges are too many, or too long for the body.
TriangleSurface remesh(TriangleSurface const& surface, RemeshOptions const& options);

}  // namespace g27
