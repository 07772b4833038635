#pragma once
/// Triangles of a wanted size on the same body.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

struct RemeshOptions {
  double edge;                ///< wanted length of the edges [m]
  double feature_angle = 40;  ///< edges where the normals turn by more than this are kept [degrees]
  int iterations = 10;
};

/// Isotropic remeshing (Botsch and Kobbelt 2004, by CGAL). Sharp edges are divided or joined along themselves, vertices
/// on them do not slide; those between slide on the given surface. More than 90 % of the edges come out within 0.7
/// to 1.4 of the length, single ones as short as 0.3 where sharp edges meet. The border of an open surface is kept as
/// sharp edges are. Needs a surface that is healthy but for its border; throws SurfaceError if more than ten million
/// triangles would be needed.
TriangleSurface remesh(TriangleSurface const& surface, RemeshOptions const& options);

}  // namespace g27
