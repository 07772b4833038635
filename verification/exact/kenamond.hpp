#pragma once
/// Lighting times about an inert sphere in an unbounded explosive that is lit at one point: Kenamond's third problem of
/// programmed burn, and without the sphere his first (ExactPack 1.7.11, kenamond1 and kenamond3).
///
/// Point of ignition, centre and target span a plane in which the shortest way lies. Where the straight one meets the
/// sphere of radius R, it is the tangent from the point of ignition, an arc, and the tangent to the target: with a and
/// b the two's distances from the centre and g the angle between them there, sqrt(a^2 - R^2) + sqrt(b^2 - R^2)
/// + R (g - acos(R/a) - acos(R/b)). In the plane the sphere is a disc.
#include <array>

namespace g27 {

struct Kenamond {
  double speed = 1;                          ///< of the front [m/s]
  double radius = 0;                         ///< of the sphere [m]; 0: there is none
  std::array<double, 3> centre{0, 0, 0};     ///< [m]
  std::array<double, 3> ignition{-1, 0, 0};  ///< outside of the sphere [m]

  /// Angle of the arc that the front goes along the sphere on its way to x, not inside; <= 0: the straight way is free.
  [[nodiscard]] double arc(std::array<double, 3> const& x) const;
  /// Time since ignition [s].
  [[nodiscard]] double time(std::array<double, 3> const& x) const;
};

}  // namespace g27
