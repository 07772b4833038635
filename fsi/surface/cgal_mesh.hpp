#pragma once
/// To and from the mesh types of CGAL, without their headers.
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Mesh: CGAL::Surface_mesh<Point>; faces in the order of the triangles, without the vertices that none has. Needs a
/// manifold, consistently oriented surface; throws std::invalid_argument.
template <class Mesh>
Mesh to_cgal(TriangleSurface const& surface) {
  Mesh mesh;
  std::vector<typename Mesh::Vertex_index> number(surface.vertices.size(), Mesh::null_vertex());
  auto vertex = [&](int v) {
    auto& n = number[static_cast<std::size_t>(v)];
    Vec3 const& x = surface.at(v);
    if (n == Mesh::null_vertex()) n = mesh.add_vertex(typename Mesh::Point(x[0], x[1], x[2]));
    return n;
  };
  for (auto const& [a, b, c] : surface.triangles) {
    auto const p = vertex(a), q = vertex(b), r = vertex(c);
    if (mesh.add_face(p, q, r) == Mesh::null_face()) throw std::invalid_argument("the surface is not manifold");
  }
  return mesh;
}

/// Vertices and triangles in the order of the mesh, which holds no removed elements; the first side of a triangle is
/// the one after its halfedge, which is the last of those that it was added by.
template <class Mesh>
TriangleSurface from_cgal(Mesh const& mesh) {
  TriangleSurface out;
  for (auto const v : mesh.vertices()) {
    auto const& p = mesh.point(v);
    out.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (auto const f : mesh.faces()) {
    Triangle t{};
    auto h = mesh.next(mesh.halfedge(f));
    for (int& corner : t) {
      corner = static_cast<int>(mesh.source(h));
      h = mesh.next(h);
    }
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace g27
