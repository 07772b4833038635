#include "fsi/overset/body_spin.hpp"

#include <Eigen/Dense>

#include "fsi/overset/body.hpp"

namespace g27 {

Vec3 spin_of(Body const& body) {
  Mirrors const& mirrors = body.cut.mirrors;
  double area = 0;
  Vec3 centre{0, 0, 0}, velocity{0, 0, 0};
  auto const each = [&](auto const& visit) {
    for (TriangleState const& t : body.triangles) {
      visit(t.area, t.centre, t.velocity);
      mirrors.for_each([&](Image const& at) {
        visit(t.area, mirrors.image(t.centre, at), reflected(t.velocity, at, mirrors.clamps));
      });
    }
  };
  each(
      [&](double a, Vec3 const& x, Vec3 const& u) { area += a, centre = centre + a * x, velocity = velocity + a * u; });
  centre = (1 / area) * centre, velocity = (1 / area) * velocity;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  each([&](double a, Vec3 const& x, Vec3 const& u) {
    Vec3 const y = x - centre, l = cross(y, u - velocity);
    Eigen::Vector3d const r(y[0], y[1], y[2]);
    inertia += a * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    momentum += a * Eigen::Vector3d(l[0], l[1], l[2]);
  });
  Eigen::Vector3d const spin = inertia.ldlt().solve(momentum);
  return {spin[0], spin[1], spin[2]};
}

}  // namespace g27
