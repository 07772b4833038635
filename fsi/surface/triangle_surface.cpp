#include "fsi/surface/triangle_surface.hpp"

#include <algorithm>

namespace g27 {

BoundingBox bounding_box(TriangleSurface const& surface) {
  BoundingBox box{surface.at(surface.triangles[0][0]), surface.at(surface.triangles[0][0])};
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (Vec3 const& corner : surface.corners(t)) {
      for (std::size_t d = 0; d < 3; ++d) {
        box.lower[d] = std::min(box.lower[d], corner[d]);
        box.upper[d] = std::max(box.upper[d], corner[d]);
      }
    }
  }
  return box;
}

MassProperties mass_properties(TriangleSurface const& surface, double density) {
  BoundingBox const box = bounding_box(surface);
  Vec3 const origin = 0.5 * (box.lower + box.upper);
  double area = 0, volume = 0;
  Vec3 first{0, 0, 0};                            // int x dV
  std::array<std::array<double, 3>, 3> second{};  // int x x^T dV
  for (std::size_t t = 0; t < surface.size(); ++t) {
    // The tetrahedron from the origin to the triangle: its moments are polynomials of its corners.
    auto const [a, b, c] = surface.corners(t);
    Vec3 const p = a - origin, q = b - origin, r = c - origin, sum = p + q + r;
    double const six_volumes = dot(p, cross(q, r));
    area += surface.area(t);
    volume += six_volumes / 6;
    first = first + (six_volumes / 24) * sum;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        second[i][j] += six_volumes / 120 * (p[i] * p[j] + q[i] * q[j] + r[i] * r[j] + sum[i] * sum[j]);
      }
    }
  }
  MassProperties out{.area = area, .volume = volume, .mass = density * volume, .centroid = origin};
  if (volume == 0) return out;
  Vec3 const offset = (1 / volume) * first;
  out.centroid = origin + offset;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) second[i][j] -= volume * offset[i] * offset[j];
  }
  double const trace = second[0][0] + second[1][1] + second[2][2];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out.inertia[i][j] = density * ((i == j ? trace : 0) - second[i][j]);
  }
  return out;
}

}  // namespace g27
