/// A surface that runs through itself is drawn back there, and nowhere else.
#include "fsi/overset/untangle.hpp"

#include <cmath>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/polygon_mesh.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

Cut whole(TriangleSurface const& s) {
  Cut cut;
  cut.on_planes.assign(s.vertices.size(), {false, false, false});
  return cut;
}

}  // namespace

TEST_CASE("a surface that meets neither itself nor a plane stays as it is, bit by bit", "[surface]") {
  TriangleSurface s = make_sphere(1, 0.3);
  TriangleSurface const before = s;
  Untangled const r = untangle(s, whole(s));
  CHECK(r.clear);
  CHECK(r.moved == 0);
  CHECK(s.vertices == before.vertices);
}

TEST_CASE("the sides of a plate that have gone through each other are drawn apart", "[surface]") {
  TriangleSurface s = make_box({1, 1, 0.05}, 0.1);
  for (Vec3& x : s.vertices) {
    // a dent from above that comes out below, by a fifth of the thickness
    if (x[2] > 0) x[2] -= 0.06 * std::exp(-(x[0] * x[0] + x[1] * x[1]) / 0.01);
  }
  REQUIRE_FALSE(self_intersections(s).empty());
  TriangleSurface const before = s;
  Untangled const r = untangle(s, whole(s));
  CHECK(r.clear);
  CHECK(r.moved > 0);
  CHECK(self_intersections(s).empty());
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    Vec3 const& x = before.vertices[v];
    double const way = length(s.vertices[v] - x);
    // what is moved is within the dent and two edges around it, by no more than the dent's depth
    if (std::hypot(x[0], x[1]) > 0.4) CHECK(way == 0);
    CHECK(way < 0.06);
  }
}

TEST_CASE("vertices beyond a plane of symmetry come back, and those on it stay on it", "[surface]") {
  TriangleSurface s = clip_surface(make_box({1, 1, 1}, 0.1), 0, 0, true, 1e-9);
  Mirrors const planes{.low = {true, false, false}, .high = {}, .lower = {0, -2, -2}, .upper = {2, 2, 2}};
  Cut const cut = find_cut(s, planes, 1e-6);
  std::size_t first = s.vertices.size();
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    Vec3& x = s.vertices[v];
    if (!cut.on_planes[v][0] && x[0] < 0.12 && x[2] > 0.49 && std::fabs(x[1]) < 0.06) x[0] = -0.01, first = v;
  }
  REQUIRE(first < s.vertices.size());
  Untangled const r = untangle(s, cut);
  CHECK(r.clear);
  CHECK(r.moved > 0);
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    if (cut.on_planes[v][0]) {
      CHECK(s.vertices[v][0] == 0);
    } else {
      CHECK(s.vertices[v][0] > 0);
    }
  }
}
