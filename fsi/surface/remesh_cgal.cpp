#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include "fsi/surface/cgal_mesh.hpp"
#include "fsi/surface/remesh.hpp"

namespace g27 {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;
namespace np = CGAL::parameters;

/// Vertices where the border of an open surface turns by more than this: they stay.
template <class Map>
void mark_corners(Mesh const& mesh, double degrees, Map const& corner) {
  for (auto const h : mesh.halfedges()) {
    if (!mesh.is_border(h)) continue;
    auto const along = [&](auto side) { return mesh.point(mesh.target(side)) - mesh.point(mesh.source(side)); };
    if (CGAL::approximate_angle(along(h), along(mesh.next(h))) > degrees) put(corner, mesh.target(h), true);
  }
}

}  // namespace

TriangleSurface remesh(TriangleSurface const& surface, RemeshOptions const& options) {
  if (!(mass_properties(surface).area / (0.43 * options.edge * options.edge) < 1e7)) {
    throw SurfaceError("edges of this length would make more than ten million triangles", "give a longer one");
  }
  Mesh mesh = to_cgal<Mesh>(surface);
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  pmp::detect_sharp_edges(mesh, options.feature_angle, sharp);
  for (auto const e : mesh.edges()) {
    if (mesh.is_border(e)) put(sharp, e, true);
  }
  auto const corner = mesh.add_property_map<Mesh::Vertex_index, bool>("v:corner", false).first;
  mark_corners(mesh, options.feature_angle, corner);
  pmp::isotropic_remeshing(mesh.faces(), options.edge, mesh,
                           np::number_of_iterations(static_cast<unsigned>(options.iterations))
                               .number_of_relaxation_steps(3)
                               .edge_is_constrained_map(sharp)
                               .vertex_is_constrained_map(corner)
                               .relax_constraints(false));
  mesh.collect_garbage();
  return from_cgal(mesh);
}

}  // namespace g27
