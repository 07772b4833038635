#include "fsi/overset/rigid_body.hpp"

#include <Eigen/Dense>

#include "fsi/overset/body_integrals.hpp"

namespace g27 {

namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

Vector vector_of(Vec3 const& v) { return {v[0], v[1], v[2]}; }
Vec3 vec3_of(Vector const& v) { return {v[0], v[1], v[2]}; }
Quaternion quaternion_of(std::array<double, 4> const& q) { return {q[0], q[1], q[2], q[3]}; }

Matrix symmetric(std::array<double, 6> const& m) {
  Matrix out;
  out << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
  return out;
}

Quaternion rotation_by(Vec3 const& way) {
  double const angle = length(way);
  return angle > 0 ? Quaternion(Eigen::AngleAxisd(angle, vector_of(way) / angle)) : Quaternion::Identity();
}

/// The tensor of inertia of second moments.
Matrix inertia_of(Matrix const& moments) { return moments.trace() * Matrix::Identity() - moments; }

}  // namespace

RigidBody::RigidBody(TriangleSurface const& surface, Cut const& cut, RigidSetup const& setup) : given_(setup.given) {
  Mirrors const& planes = cut.mirrors;
  Enclosed const within = enclosed(surface, planes);
  mass_ = setup.density * within.volume, state.centre = within.centroid;
  for (Vec3 const& x : surface.vertices) shape_.push_back(x - state.centre);
  for (std::size_t a = 0; a < 3; ++a) {
    moves_[a] = !planes.across(a);
    turns_[a] = !planes.across((a + 1) % 3) && !planes.across((a + 2) % 3);
  }
  // the whole body's products of inertia with the normal of a plane vanish
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      std::size_t const at = tensor_place[a][b];
      if (a == b || (moves_[a] && moves_[b])) moments_[at] = setup.density * within.moments[at];
    }
  }
  Vector const angular = inertia_of(symmetric(moments_)) * vector_of(setup.spin);
  for (std::size_t a = 0; a < 3; ++a) {
    if (moves_[a]) state.momentum[a] = mass_ * setup.velocity[a];
    if (turns_[a]) state.angular[a] = angular[static_cast<Eigen::Index>(a)];
  }
}

RigidBody::Motion RigidBody::motion() const {
  Vector const spin = inertia_of(symmetric(moments())).ldlt().solve(vector_of(state.angular));
  return {(1 / mass_) * state.momentum, vec3_of(spin)};
}

double RigidBody::kinetic_energy() const {
  auto const [velocity, spin] = motion();
  return 0.5 * (dot(state.momentum, velocity) + dot(state.angular, spin));
}

std::array<double, 6> RigidBody::moments() const {
  Matrix const R = quaternion_of(state.rotation).toRotationMatrix();
  Matrix const m = R * symmetric(moments_) * R.transpose();
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

std::array<Vec3, 3> RigidBody::turn(double dt) const {
  Matrix const R = rotation_by(dt * motion().spin).toRotationMatrix();
  return {vec3_of(R.row(0)), vec3_of(R.row(1)), vec3_of(R.row(2))};
}

RigidBody::Motion RigidBody::half_step(std::vector<Push> const& pushes, double time, double dt) const {
  if (given_) return {given_(time + 0.5 * dt), motion().spin};
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix const R = rotation_by(0.5 * dt * motion().spin).toRotationMatrix();
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  matrix.topLeftCorner<3, 3>() = mass_ * Matrix::Identity();
  matrix.bottomRightCorner<3, 3>() = R * inertia_of(symmetric(moments())) * R.transpose();
  Vector6 right;
  right << vector_of(state.momentum), vector_of(state.angular);
  for (Push const& p : pushes) {
    Vector6 along;  // the part's velocity along its normal is along . (velocity, spin)
    along << vector_of(p.normal), vector_of(cross(p.arm, p.normal));
    right += 0.5 * dt * p.force * along;
    matrix += 0.5 * dt * p.resistance * along * along.transpose();
  }
  for (Eigen::Index a = 0; a < 6; ++a) {
    std::size_t const axis = static_cast<std::size_t>(a % 3);
    if (a < 3 ? moves_[axis] : turns_[axis]) continue;
    matrix.row(a).setZero(), matrix.col(a).setZero();
    matrix(a, a) = 1, right(a) = 0;
  }
  Vector6 const found = matrix.ldlt().solve(right);
  return {vec3_of(found.head<3>()), vec3_of(found.tail<3>())};
}

void RigidBody::advance(double time, double dt, Vec3 const& impulse, Vec3 const& moment) {
  state.centre = state.centre + dt * during_step.velocity;
  Quaternion const q = (rotation_by(dt * during_step.spin) * quaternion_of(state.rotation)).normalized();
  state.rotation = {q.w(), q.x(), q.y(), q.z()};
  if (given_) {
    state.momentum = mass_ * given_(time + dt);
    state.angular = vec3_of(inertia_of(symmetric(moments())) * vector_of(during_step.spin));
    return;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (moves_[a]) state.momentum[a] += impulse[a];
    if (turns_[a]) state.angular[a] += moment[a];
  }
}

void RigidBody::place(TriangleSurface& surface, Cut const& cut) const {
  Matrix const R = quaternion_of(state.rotation).toRotationMatrix();
  for (std::size_t v = 0; v < shape_.size(); ++v) {
    Vec3 const x = state.centre + vec3_of(R * vector_of(shape_[v]));
    for (std::size_t a = 0; a < 3; ++a) {
      if (!cut.on_planes[v][a]) surface.vertices[v][a] = x[a];
    }
  }
}

}  // namespace g27
