#include "fsi/overset/normal_motion.hpp"

#include <Eigen/Eigenvalues>

namespace g27 {

namespace {

/// Of the sum of the weights: normals that turn by less than 40 degrees are of one side.
constexpr double least = 0.1;

}  // namespace

Vec3 along_normals(Body const& body, std::size_t vertex) {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  for (int number : body.around[vertex]) {
    TriangleState const& t = body.triangles[static_cast<std::size_t>(number)];
    Vec3 const r = body.surface.vertices[vertex] - t.centre;
    double const w = t.area / dot(r, r);
    Eigen::Vector3d n(t.frame.n[0], t.frame.n[1], t.frame.n[2]);
    for (int a = 0; a < 3; ++a) {
      if (body.cut.on_planes[vertex][static_cast<std::size_t>(a)]) n[a] = 0;  // with the triangle's image
    }
    normals += w * n * n.transpose(), along += (w * dot(t.velocity, t.frame.n)) * n;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(normals);
  Vec3 u{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] <= least * normals.trace()) continue;
    Eigen::Vector3d const v = solver.eigenvectors().col(i);
    u = u + (v.dot(along) / solver.eigenvalues()[i]) * Vec3{v[0], v[1], v[2]};
  }
  return u;
}

}  // namespace g27
