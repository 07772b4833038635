/// Mending a surface that deforms keeps the body: volume, sharp edges, no triangle through another.
#include "fsi/surface/local_remesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/polygon_mesh.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

double volume(TriangleSurface const& s) { return mass_properties(s).volume; }

/// Repeated until nothing is left to do.
struct Mended {
  TriangleSurface surface;
  LocalRemeshCounts counts;
  int calls = 0;
};
Mended mended(TriangleSurface surface, LocalRemeshOptions const& options) {
  Mended m{.surface = std::move(surface), .counts = {}};
  while (m.calls < 20 && needs_remeshing(m.surface, options)) {
    LocalRemesh r = local_remesh(m.surface, options);
    m.surface = std::move(r.surface), m.counts.add(r.counts), ++m.calls;
  }
  return m;
}

}  // namespace

TEST_CASE("a surface within the limits is left alone", "[surface]") {
  CHECK_FALSE(needs_remeshing(make_sphere(1, 0.2), {.shortest = 0.08, .longest = 0.34}));
  CHECK(needs_remeshing(make_sphere(1, 0.2), {.shortest = 0.08, .longest = 0.2}));
  CHECK(needs_remeshing(make_sphere(1, 0.2), {.shortest = 0.2, .longest = 0.34}));
}

TEST_CASE("a box that is stretched and flattened gets edges within the limits and keeps its volume", "[surface]") {
  // affine: sides stay plane and sharp edges straight, so that whatever is done along them keeps the volume
  LocalRemeshOptions const limits{.shortest = 0.04, .longest = 0.17};
  for (Vec3 const& by : {Vec3{2.5, 0.6, 0.6}, Vec3{0.3, 1.8, 1.8}, Vec3{0.35, 0.35, 0.35}, Vec3{3, 3, 3}}) {
    TriangleSurface s = make_box({1, 1, 1}, 0.1);
    for (Vec3& x : s.vertices) x = {by[0] * x[0], by[1] * x[1], by[2] * x[2]};
    Mended const m = mended(s, limits);
    CAPTURE(by[0], by[1], m.calls, m.counts.splits, m.counts.collapses, m.counts.flips, m.counts.moves);
    // of the sum of about 1000 triangles' volumes
    CHECK(volume(m.surface) == Approx(volume(s)).epsilon(1e-12));
    CHECK(m.counts.refused == 0);
    CHECK(diagnose(m.surface).healthy());
    // the angles at its edges are right ones still
    CHECK(diagnose(m.surface).angles.smallest == Approx(0.5 * std::numbers::pi).epsilon(1e-6));
    auto const lengths = edge_lengths(m.surface);
    auto const within = std::count_if(lengths.begin(), lengths.end(),
                                      [&](double l) { return l > limits.shortest && l < limits.longest; });
    // single ones cannot be joined: corners and crossing lines hold their ends
    CHECK(static_cast<double>(within) > 0.99 * static_cast<double>(lengths.size()));
    CHECK(*std::max_element(lengths.begin(), lengths.end()) < limits.longest);
  }
}

TEST_CASE("joining triangles of a ball keeps its volume", "[surface]") {
  // a corner that joins another is put where the volume stays; only turned edges change it
  TriangleSurface s = make_sphere(1, 0.12);
  for (Vec3& x : s.vertices) x = {0.45 * x[0], 1.4 * x[1], 1.4 * x[2]};
  Mended const m = mended(s, {.shortest = 0.08, .longest = 0.3});
  CAPTURE(m.calls, m.counts.splits, m.counts.collapses, m.counts.flips, m.counts.moves, m.counts.volume);
  CHECK(m.counts.collapses > 50);
  CHECK(m.surface.size() < s.size());
  CHECK(std::fabs(volume(m.surface) - volume(s)) <= m.counts.volume * (1 + 1e-9) + 1e-12);
  CHECK(std::fabs(volume(m.surface) / volume(s) - 1) < 2e-3);
  CHECK(diagnose(m.surface).healthy());
}

TEST_CASE("parents are the triangles whose place a new one has", "[surface]") {
  TriangleSurface s = make_box({1, 1, 1}, 0.2);
  for (Vec3& x : s.vertices) x[0] *= 2;
  LocalRemesh const r = local_remesh(s, {.shortest = 0.08, .longest = 0.34});
  REQUIRE(r.parents.size() == r.surface.size());
  CHECK(r.counts.splits > 10);
  for (std::size_t t = 0; t < r.surface.size(); ++t) {
    REQUIRE_FALSE(r.parents[t].empty());
    CHECK(std::is_sorted(r.parents[t].begin(), r.parents[t].end()));
    for (int const p : r.parents[t]) {
      // on the same side of the box, and within a few edges
      CHECK(dot(r.surface.normal(t), s.normal(static_cast<std::size_t>(p))) > 0.999);
      CHECK(length(r.surface.centre(t) - s.centre(static_cast<std::size_t>(p))) < 0.8);
    }
  }
  // the same again, bit by bit
  LocalRemesh const again = local_remesh(s, {.shortest = 0.08, .longest = 0.34});
  CHECK(again.surface.vertices == r.surface.vertices);
  CHECK(again.surface.triangles == r.surface.triangles);
}

TEST_CASE("mirror images are mended alike, and what is left alone keeps its first sides", "[surface]") {
  // the frames of model problems start at the first sides
  TriangleSurface const half = clip_surface(make_box({1, 1, 1}, 0.25), 0, 0, true, 1e-9);
  TriangleSurface s = unfolded(half, 0, 0);
  for (Vec3& x : s.vertices) {
    // triangles far from the plane are stretched, and no two sides are equally long
    double const far = std::fabs(x[0]), y = x[1], z = x[2];
    x[1] += 0.1 * far * (z + 0.3 * y * y), x[2] += 0.07 * far * (y - 0.4 * y * z);
    if (far > 0.3) x[0] *= 2 + 0.3 * y + 0.17 * z + 0.2 * y * z;
  }
  LocalRemesh const r = local_remesh(s, {.shortest = 0.08, .longest = 0.45});
  CHECK(r.counts.splits > 10);
  using Corners = std::array<Vec3, 3>;
  auto const rounded = [](Corners c) {  // vertices that moved have sums in another order
    for (Vec3& x : c) {
      for (double& q : x) q = std::round(q * 1e9) + 0.0;
    }
    return c;
  };
  std::map<Corners, int> corners;
  for (std::size_t t = 0; t < r.surface.size(); ++t) ++corners[rounded(r.surface.corners(t))];
  auto const mirrored = [](Vec3 x) { return x[0] = 0.0 - x[0], x; };
  int images = 0, same = 0;
  for (auto const& [c, count] : corners) {
    CHECK(count == 1);
    images += static_cast<int>(corners.count({mirrored(c[1]), mirrored(c[0]), mirrored(c[2])}));
  }
  for (std::size_t t = 0; t < s.size(); ++t) same += static_cast<int>(corners.count(rounded(s.corners(t))));
  CHECK(images == static_cast<int>(r.surface.size()));
  CHECK(same > 30);
  // all that there still is, in whatever order
  int kept = 0;
  for (std::size_t t = 0; t < s.size(); ++t) {
    auto const [a, b, c] = rounded(s.corners(t));
    kept += static_cast<int>(corners.count({a, b, c}) + corners.count({b, c, a}) + corners.count({c, a, b}));
  }
  CHECK(kept == same);
}

TEST_CASE("the border of an open surface is parted and joined in its plane", "[surface]") {
  LocalRemeshOptions const limits{.shortest = 0.04, .longest = 0.17};
  // sides of the box lie across axes as well, before and after that of the plane
  std::size_t const axis = GENERATE(0, 1, 2);
  // affine: what is joined within the sides and along their edges keeps the volume
  TriangleSurface s = clip_surface(make_box({1, 1, 1}, 0.1), axis, 0, true, 1e-9);
  for (Vec3& x : s.vertices) {
    x[axis] *= 0.6, x[(axis + 1) % 3] *= 2.5, x[(axis + 2) % 3] *= 0.3;
  }
  // by the divergence of x along the axis, to which the open side at 0 adds nothing
  auto const closed_volume = [axis](TriangleSurface const& of) {
    double v = 0;
    for (std::size_t t = 0; t < of.size(); ++t) v += of.area_vector(t)[axis] * of.centre(t)[axis];
    return v;
  };
  Mended const m = mended(s, limits);
  CHECK(m.counts.splits > 0);
  CHECK(m.counts.collapses > 0);
  CHECK(m.counts.refused == 0);
  CHECK(closed_volume(m.surface) == Approx(closed_volume(s)).epsilon(1e-12));
  CHECK(closed_volume(s) == Approx(0.5 * 0.6 * 2.5 * 0.3).epsilon(1e-12));
  for (SurfaceFinding const& f : diagnose(m.surface).findings) {
    CHECK(f.fault == Fault::open_edge);
    for (int t : f.triangles) {
      auto const corners = m.surface.corners(static_cast<std::size_t>(t));
      CHECK(std::count_if(corners.begin(), corners.end(), [&](Vec3 const& x) { return x[axis] == 0; }) >= 2);
    }
  }
  auto const lengths = edge_lengths(m.surface);
  for (double const l : lengths) CHECK(l < limits.longest);
  // single ones at corners stay
  auto const short_ones = std::count_if(lengths.begin(), lengths.end(), [&](double l) { return l < limits.shortest; });
  CHECK(static_cast<double>(short_ones) < 0.01 * static_cast<double>(lengths.size()));
}
