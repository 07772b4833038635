#include "fsi/overset/rigid_motion.hpp"

#include <cmath>

namespace g27 {

namespace {

Eigen::Vector3d vector(Vec3 const& v) { return {v[0], v[1], v[2]}; }
Vec3 array(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }

/// The turn by a vector, its length the angle [rad].
Eigen::Quaterniond turn_by(Eigen::Vector3d const& angle) {
  double const size = angle.norm();
  if (size == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(size, angle / size));
}

}  // namespace

RigidMotion::RigidMotion(TriangleSurface const& surface, double density, Vec3 const& velocity, Vec3 const& spin) {
  MassProperties const m = mass_properties(surface, density);
  if (!(m.mass > 0)) throw SurfaceError("the body has no mass", "give a closed surface, its normals outwards");
  mass_ = m.mass, start_ = centre_ = m.centroid;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inertia_(i, j) = m.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  solver_.compute(inertia_);
  momentum_ = mass_ * velocity, angular_ = array(inertia_ * vector(spin));
}

Vec3 RigidMotion::spin_of(Vec3 const& angular, Eigen::Quaterniond const& turn) const {
  return array(turn * solver_.solve(turn.conjugate() * vector(angular)));
}

double RigidMotion::kinetic() const { return 0.5 * dot(momentum_, momentum_) / mass_ + 0.5 * dot(angular_, spin()); }

void RigidMotion::advance(double dt, Vec3 const& impulse, Vec3 const& moment) {
  constexpr int iterations = 30;
  centre_ = centre_ + (dt / mass_) * (momentum_ + 0.5 * impulse);
  Vec3 const angular = angular_ + 0.5 * moment;
  // the spin in the middle of the step depends on the orientation there
  Eigen::Vector3d spin = vector(spin_of(angular, turn_));
  for (int i = 0; i < iterations; ++i) {
    Eigen::Vector3d const next = vector(spin_of(angular, turn_by(0.5 * dt * spin) * turn_));
    double const change = (next - spin).norm();
    spin = next;
    if (change <= 1e-15 * spin.norm()) break;
  }
  turn_ = (turn_by(dt * spin) * turn_).normalized();
  momentum_ = momentum_ + impulse, angular_ = angular_ + moment;
}

Vec3 RigidMotion::place(Vec3 const& at_start) const { return centre_ + array(turn_ * vector(at_start - start_)); }

}  // namespace g27
