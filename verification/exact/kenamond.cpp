#include "verification/exact/kenamond.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {
namespace {

using Point = std::array<double, 3>;

Point from_to(Point const& a, Point const& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double size(Point const& a) { return std::hypot(a[0], a[1], a[2]); }

/// Angle from the tangent's point to one at distance a, as seen from the centre.
double tangent_angle(double radius, double a) { return std::acos(std::min(1.0, radius / a)); }
double tangent(double radius, double a) { return std::sqrt(std::max(0.0, (a - radius) * (a + radius))); }

}  // namespace

double Kenamond::arc(Point const& x) const {
  Point const a = from_to(centre, ignition), b = from_to(centre, x);
  Point const cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  double const angle = std::atan2(size(cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  return angle - tangent_angle(radius, size(a)) - tangent_angle(radius, size(b));
}

double Kenamond::time(Point const& x) const {
  double const around = radius > 0 ? arc(x) : 0;
  if (!(around > 0)) return size(from_to(ignition, x)) / speed;
  return (tangent(radius, size(from_to(centre, ignition))) + tangent(radius, size(from_to(centre, x))) +
          radius * around) /
         speed;
}

}  // namespace g27
