#pragma once
/// Algebra of points and vectors in space.
#include <cmath>

#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

inline Vec3 operator+(Vec3 const& a, Vec3 const& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(Vec3 const& a, Vec3 const& b) noexcept { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(double s, Vec3 const& a) noexcept { return {s * a[0], s * a[1], s * a[2]}; }

inline double dot(Vec3 const& a, Vec3 const& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(Vec3 const& a, Vec3 const& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(Vec3 const& a) noexcept { return std::hypot(a[0], a[1], a[2]); }

}  // namespace g27
