#include "fsi/surface/gap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g27 {

namespace {

bool beside(BoundingBox const& box, Vec3 const& x, double distance) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (x[a] < box.lower[a] - distance || x[a] > box.upper[a] + distance) return true;
  }
  return false;
}

/// Least distance of the vertices of `a` to the triangles of `b`.
double one_way(TriangleSurface const& a, TriangleSurface const& b, double enough) {
  BoundingBox const box_a = bounding_box(a), box_b = bounding_box(b);
  struct Near {
    std::array<Vec3, 3> corners;
    double size;  // no point of the triangle is farther from its first corner
  };
  std::vector<Near> near;
  for (std::size_t t = 0; t < b.size(); ++t) {
    auto const corners = b.corners(t);
    double const size = std::max(length(corners[1] - corners[0]), length(corners[2] - corners[0]));
    if (!beside(box_a, corners[0], enough + size)) near.push_back({corners, size});
  }
  double least = enough;
  for (Vec3 const& x : a.vertices) {
    if (beside(box_b, x, least)) continue;
    for (Near const& t : near) {
      Vec3 const r = x - t.corners[0];
      double const reach = least + t.size;
      if (dot(r, r) < reach * reach) least = std::min(least, distance(x, t.corners));
    }
  }
  return least;
}

}  // namespace

// Regions of the nearest point: Ericson, Real-Time Collision Detection (2005), 5.1.5.
double distance(Vec3 const& x, std::array<Vec3, 3> const& triangle) noexcept {
  auto const& [a, b, c] = triangle;
  Vec3 const ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  double const d1 = dot(ab, ax), d2 = dot(ac, ax), d3 = dot(ab, bx), d4 = dot(ac, bx), d5 = dot(ab, cx),
               d6 = dot(ac, cx);
  if (d1 <= 0 && d2 <= 0) return length(ax);
  if (d3 >= 0 && d4 <= d3) return length(bx);
  if (d6 >= 0 && d5 <= d6) return length(cx);
  double const to_c = d1 * d4 - d3 * d2, to_b = d5 * d2 - d1 * d6, to_a = d3 * d6 - d5 * d4;
  if (to_c <= 0 && d1 >= 0 && d3 <= 0) return length(ax - (d1 / (d1 - d3)) * ab);
  if (to_b <= 0 && d2 >= 0 && d6 <= 0) return length(ax - (d2 / (d2 - d6)) * ac);
  if (to_a <= 0 && d4 >= d3 && d5 >= d6) return length(bx - ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b));
  double const sum = to_a + to_b + to_c;
  return length(ax - (to_b / sum) * ab - (to_c / sum) * ac);
}

double distance(Vec3 const& x, TriangleSurface const& surface) noexcept {
  double least = 1e300;
  for (std::size_t t = 0; t < surface.size(); ++t) least = std::min(least, distance(x, surface.corners(t)));
  return least;
}

double gap_between(TriangleSurface const& a, TriangleSurface const& b, double enough) {
  return std::min(one_way(a, b, enough), one_way(b, a, enough));
}

// Solid angle of the surface: 4 pi from within, 0 from outside (Van Oosterom and Strackee 1983).
bool within(Vec3 const& x, TriangleSurface const& surface) noexcept {
  double angle = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    auto const corners = surface.corners(t);
    Vec3 const a = corners[0] - x, b = corners[1] - x, c = corners[2] - x;
    double const la = length(a), lb = length(b), lc = length(c);
    double const volume = dot(a, cross(b, c));
    angle += 2 * std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle > 2 * std::numbers::pi;
}

double distance_to_body(Vec3 const& x, TriangleSurface const& surface) noexcept {
  return within(x, surface) ? 0.0 : distance(x, surface);
}

}  // namespace g27
