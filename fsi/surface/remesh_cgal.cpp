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

}  // namespace

TriangleSurface remesh(TriangleSurface const& surface, RemeshOptions const& options) {
  if (!(mass_properties(surface).area / (0.43 * options.edge * options.edge) < 1e7)) {
    throw SurfaceError("edges of this length would make more than ten million triangles", "give a longer one");
  }
  Mesh mesh = to_cgal<Mesh>(surface);
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  pmp::detect_sharp_edges(mesh, options.feature_angle, sharp);
  pmp::isotropic_remeshing(mesh.faces(), options.edge, mesh,
                           np::number_of_iterations(static_cast<unsigned>(options.iterations))
                               .number_of_relaxation_steps(3)
                               .edge_is_constrained_map(sharp)
                               .relax_constraints(false));
  mesh.collect_garbage();
  return from_cgal(mesh);
}

}  // namespace g27
