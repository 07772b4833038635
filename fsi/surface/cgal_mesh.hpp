#pragma once
/// To and from the mesh types of CGAL, without their headers.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Mesh: CGAL::Surface_mesh<Point>. Needs a manifold, consistently oriented surface; throws std::invalid_argument.
template <class Mesh>
Mesh to_cgal(TriangleSurface const& surface) {
  using Vertex = typename Mesh::Vertex_index;
  Mesh mesh;
  for (Vec3 const& v : surface.vertices) mesh.add_vertex(typename Mesh::Point(v[0], v[1], v[2]));
  for (auto const& [a, b, c] : surface.triangles) {
    using Index = typename Mesh::size_type;
    auto const face =
        mesh.add_face(Vertex(static_cast<Index>(a)), Vertex(static_cast<Index>(b)), Vertex(static_cast<Index>(c)));
    if (face == Mesh::null_face()) throw std::invalid_argument("the surface is not manifold");
  }
  return mesh;
}

/// Vertices and triangles in the order of the mesh, which holds no removed elements.
template <class Mesh>
TriangleSurface from_cgal(Mesh const& mesh) {
  TriangleSurface out;
  for (auto const v : mesh.vertices()) {
    auto const& p = mesh.point(v);
    out.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (auto const f : mesh.faces()) {
    Triangle t{};
    auto h = mesh.halfedge(f);
    for (int& corner : t) {
      corner = static_cast<int>(mesh.source(h));
      h = mesh.next(h);
    }
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace g27
