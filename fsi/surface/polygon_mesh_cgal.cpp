#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "fsi/surface/cgal_mesh.hpp"
#include "fsi/surface/polygon_mesh.hpp"

namespace g27 {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Point point(Vec3 const& x) { return {x[0], x[1], x[2]}; }

struct EnoughPairs {};

/// Whether two triangles meet elsewhere than in what they share, by exact predicates.
class Meeting {
 public:
  explicit Meeting(TriangleSurface const& surface) : surface_(surface) {
    for (Vec3 const& v : surface.vertices) points_.push_back(point(v));
  }

  [[nodiscard]] Point const& at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
  [[nodiscard]] Kernel::Triangle_3 triangle(Triangle const& t) const { return {at(t[0]), at(t[1]), at(t[2])}; }

  bool operator()(std::size_t s, std::size_t t) const {
    Triangle a = surface_.triangles[s], b = surface_.triangles[t];
    std::size_t const shared = share_first(a, b);
    switch (shared) {
      case 0:
        return CGAL::do_intersect(triangle(a), triangle(b));
      case 1:
        return CGAL::do_intersect(triangle(a), Kernel::Segment_3(at(b[1]), at(b[2]))) ||
               CGAL::do_intersect(triangle(b), Kernel::Segment_3(at(a[1]), at(a[2])));
      case 2:  // folded back onto one another
        return CGAL::coplanar(at(a[0]), at(a[1]), at(a[2]), at(b[2])) &&
               CGAL::coplanar_orientation(at(a[0]), at(a[1]), at(a[2]), at(b[2])) == CGAL::POSITIVE;
      default:
        return false;
    }
  }

 private:
  /// Moves the common vertices to the front of both and returns their number.
  static std::size_t share_first(Triangle& a, Triangle& b) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      auto const same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
      if (same == b.end()) continue;
      std::swap(*same, b[shared]);
      std::swap(a[i], a[shared]);
      ++shared;
    }
    return shared;
  }

  TriangleSurface const& surface_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<std::array<int, 2>> self_intersections(TriangleSurface const& surface, std::size_t limit) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  Meeting const meeting(surface);
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    auto const corners = meeting.triangle(surface.triangles[t]);
    if (!corners.is_degenerate()) boxes.emplace_back(corners.bbox(), t);
  }
  std::vector<std::array<int, 2>> pairs;
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](Box const& a, Box const& b) {
      if (!meeting(a.info(), b.info())) return;
      if (pairs.size() == limit) throw EnoughPairs{};
      pairs.push_back({static_cast<int>(std::min(a.info(), b.info())), static_cast<int>(std::max(a.info(), b.info()))});
    });
  } catch (EnoughPairs const&) {
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<bool> inward_triangles(TriangleSurface const& surface) {
  Mesh mesh = to_cgal<Mesh>(surface);
  CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);
  std::vector<bool> out;
  for (auto const f : mesh.faces()) {
    // Whether the corners a, b still follow one another.
    Point const a = point(surface.corners(static_cast<std::size_t>(f))[0]);
    Point const b = point(surface.corners(static_cast<std::size_t>(f))[1]);
    bool turned = true;
    for (auto const h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      turned = turned && !(mesh.point(mesh.source(h)) == a && mesh.point(mesh.target(h)) == b);
    }
    out.push_back(turned);
  }
  return out;
}

std::vector<Triangle> triangulate_polygon(std::vector<Vec3> const& points) {
  if (points.size() == 3) return {{0, 1, 2}};
  std::vector<Point> polygon;
  for (Vec3 const& x : points) polygon.push_back(point(x));
  std::vector<CGAL::Triple<int, int, int>> patch;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(polygon, std::back_inserter(patch));
  std::vector<Triangle> out;
  for (auto const& t : patch) out.push_back({t.first, t.second, t.third});
  return out;
}

}  // namespace g27
