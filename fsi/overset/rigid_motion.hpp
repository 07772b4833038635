#pragma once
/// Motion of a rigid body under given impulses.
#include <Eigen/Geometry>

#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Newton's and Euler's equations, by the mid-point rule: momentum and angular momentum are exact in the impulses,
/// position and orientation of second order.
class RigidMotion {
 public:
  /// Of uniform density [kg/m^3] within a surface; `spin` about its centre [rad/s]. Throws SurfaceError where the
  /// surface encloses no volume.
  RigidMotion(TriangleSurface const& surface, double density, Vec3 const& velocity, Vec3 const& spin);

  /// Over dt [s] under an impulse [N s] and its moment about the centre [N m s].
  void advance(double dt, Vec3 const& impulse, Vec3 const& moment);

  [[nodiscard]] double mass() const noexcept { return mass_; }               ///< [kg]
  [[nodiscard]] Vec3 const& centre() const noexcept { return centre_; }      ///< [m]
  [[nodiscard]] Vec3 const& momentum() const noexcept { return momentum_; }  ///< [N s]
  [[nodiscard]] Vec3 const& angular() const noexcept { return angular_; }    ///< about the centre [N m s]
  [[nodiscard]] Vec3 velocity() const noexcept { return (1 / mass_) * momentum_; }
  [[nodiscard]] Vec3 spin() const { return spin_of(angular_, turn_); }  ///< [rad/s]
  [[nodiscard]] double kinetic() const;                                 ///< [J]
  /// Velocity of the body at x [m/s].
  [[nodiscard]] Vec3 velocity_at(Vec3 const& x) const { return velocity() + cross(spin(), x - centre_); }
  /// Where a point of the body at the start is now [m].
  [[nodiscard]] Vec3 place(Vec3 const& at_start) const;

 private:
  [[nodiscard]] Vec3 spin_of(Vec3 const& angular, Eigen::Quaterniond const& turn) const;

  double mass_;
  Vec3 start_, centre_;
  Eigen::Matrix3d inertia_;  ///< at the start
  Eigen::LDLT<Eigen::Matrix3d> solver_;
  Eigen::Quaterniond turn_ = Eigen::Quaterniond::Identity();
  Vec3 momentum_, angular_;
};

}  // namespace g27
