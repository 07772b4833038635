// Parts of surfaces on one side of a plane.
#include "fsi/surface/clip.hpp"

#include <cmath>

#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

TriangleSurface moved(TriangleSurface s, Vec3 const& by) {
  for (Vec3& x : s.vertices) x = x + by;
  return s;
}

}  // namespace

TEST_CASE("a part and its image are a closed surface of twice the part's volume") {
  // planes through the middle of cylinders and spheres; the divergence theorem from the plane leaves out its part
  for (std::size_t axis : {0u, 1u, 2u}) {
    for (bool above : {false, true}) {
      Vec3 at{0.3, -0.2, 0.7};
      TriangleSurface const s = moved(axis == 1 ? make_sphere(0.5, 0.09) : make_cylinder(0.4, 1, 0.09), at);
      TriangleSurface const part = clip_surface(s, axis, at[axis], above, 0.02);
      for (Vec3 const& x : part.vertices) CHECK((above ? x[axis] >= at[axis] : x[axis] <= at[axis]));
      TriangleSurface const whole = unfolded(part, axis, at[axis]);
      CHECK(whole.size() == 2 * part.size());
      Diagnosis const d = diagnose(whole);
      CHECK(d.healthy());
      // snapped vertices slide along the surface: volume changes by their way squared over the radius
      CHECK(mass_properties(whole).volume == Approx(mass_properties(s).volume).epsilon(2e-3));
      CHECK(mass_properties(whole).centroid[axis] == Approx(at[axis]).margin(1e-14));
    }
  }
}

TEST_CASE("clipping leaves no triangle thinner than the distance of snapping allows") {
  double const edge = 0.09, snap = 0.3 * edge;
  TriangleSurface const part = clip_surface(make_sphere(0.5, edge), 2, 0.0123, true, snap);
  for (std::size_t t = 0; t < part.size(); ++t) {
    auto const c = part.corners(t);
    for (std::size_t k = 0; k < 3; ++k) CHECK(length(c[(k + 1) % 3] - c[k]) > 0.25 * edge);
  }
}

TEST_CASE("a cube is clipped to its exact eighth") {
  TriangleSurface s = make_box({1, 1, 1}, 0.11);
  for (std::size_t a = 0; a < 3; ++a) s = clip_surface(s, a, 0, true, 1e-9);
  TriangleSurface whole = s;
  for (std::size_t a = 0; a < 3; ++a) whole = unfolded(whole, a, 0);
  CHECK(8 * s.size() == whole.size());
  CHECK(mass_properties(whole).volume == Approx(1).epsilon(1e-13));
  CHECK(diagnose(whole).healthy());
}

TEST_CASE("a plane beside the body leaves nothing, and it is said") {
  CHECK_THROWS_AS(clip_surface(make_sphere(1, 0.3), 0, 2, true, 0.01), SurfaceError);
}
