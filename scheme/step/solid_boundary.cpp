#include "scheme/step/solid_boundary.hpp"

#include "scheme/step/gauss.hpp"

namespace g27 {

SolidFaceCondition condition_of(SolidBoundary::Kind kind) noexcept {
  using Kind = SolidBoundary::Kind;
  return kind == Kind::wall    ? SolidFaceCondition::wall
         : kind == Kind::fixed ? SolidFaceCondition::fixed
                               : SolidFaceCondition::traction;
}

Vec3 given_value(SolidBoundary const& b, std::size_t axis, Vec3 const& x, double t, double dt) {
  using Kind = SolidBoundary::Kind;
  auto const gauss = gauss_points(2);
  Vec3 value{0, 0, 0};
  for (std::size_t m = 0; m < 2; ++m) {
    double const at = t + 0.5 * dt * (1.0 + gauss[m].x);
    Vec3 v{0, 0, 0};
    if (b.kind == Kind::wall && b.normal_velocity) v[axis] = b.normal_velocity(x, at);
    if (b.kind == Kind::fixed && b.velocity) v = b.velocity(x, at);
    if (b.kind == Kind::traction && b.traction) v = b.traction(x, at);
    for (std::size_t c = 0; c < 3; ++c) value[c] += 0.5 * v[c];
  }
  return value;
}

}  // namespace g27
