#include "verification/exact/rigid_rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace g27 {
namespace {

Eigen::Vector3d vector(Vector3 const& v) { return {v[0], v[1], v[2]}; }
Vector3 array(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Vector3 RigidRotation::moved(Vector3 const& x, double t) const {
  Eigen::AngleAxisd const turn(rate * t, vector(axis).normalized());
  return array(vector(centre) + t * vector(drift) + turn * (vector(x) - vector(centre)));
}

SolidPoint RigidRotation::at(Vector3 const& x, double t) const {
  Eigen::Vector3d const unit = vector(axis).normalized(), arm = vector(x) - vector(centre) - t * vector(drift);
  double const distance2 = unit.cross(arm).squaredNorm();
  SolidPoint out;
  out.u = array(vector(drift) + rate * unit.cross(arm));
  if (auto const* linear = std::get_if<LinearBulkLaw>(&law)) {
    out.rho = rho * std::exp(linear->rho0 * rate * rate * distance2 / (2 * linear->K));
    out.p = pressure(law, out.rho, 0);
  } else {
    out.rho = rho;
    out.p = p + rho * rate * rate * distance2 / 2;
  }
  out.e = energy(law, out.rho, out.p);
  Eigen::Matrix3d const R = Eigen::AngleAxisd(rate * t, unit).toRotationMatrix();
  double turn[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) turn[i][j] = R(i, j);
  out.S = turned(turn, S);
  return out;
}

}  // namespace g27
