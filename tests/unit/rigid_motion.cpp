/// A rigid body: impulses exactly, the free symmetric top against its closed form with order two, what a free body
/// keeps.
#include <Eigen/Geometry>
#include <cmath>

#include "fsi/overset/rigid_motion.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

/// Where a corner of a free top of size (a, a, b), turning at `spin` from rest about its origin, is at t: precession
/// about L at L/I1 after a turn about its own axis at spin3 (1 - I3/I1) (Goldstein, Classical Mechanics, 5.6).
Vec3 top(Vec3 const& x, double a, double b, Vec3 const& spin, double t) {
  double const I1 = (a * a + b * b) / 12, I3 = a * a / 6;
  Eigen::Vector3d const L(I1 * spin[0], I1 * spin[1], I3 * spin[2]);
  Eigen::Vector3d const y =
      Eigen::AngleAxisd(L.norm() * t / I1, L.normalized()) *
      (Eigen::AngleAxisd(spin[2] * (1 - I3 / I1) * t, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(x[0], x[1], x[2]));
  return {y[0], y[1], y[2]};
}

double error_of_top(int steps) {
  double const a = 1, b = 2, t = 3;
  Vec3 const spin{0.4, -0.7, 2.0}, corner{0.5, 0.5, 1};
  RigidMotion body(make_box({a, a, b}, 1), 3, {0, 0, 0}, spin);
  Vec3 const at_start = body.centre() + corner;
  Vec3 const origin = body.centre();
  for (int i = 0; i < steps; ++i) body.advance(t / steps, {0, 0, 0}, {0, 0, 0});
  return length(body.place(at_start) - origin - top(corner, a, b, spin, t));
}

}  // namespace

TEST_CASE("a free symmetric top moves as its closed form, to second order", "[overset][rigid]") {
  double const coarse = error_of_top(100), fine = error_of_top(200);
  CHECK(fine < 2e-4);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.02));  // the leading term is all that is left
}

TEST_CASE("a free body keeps momentum and angular momentum exactly, its energy to second order", "[overset][rigid]") {
  auto const drift = [](int steps) {
    RigidMotion body(make_box({1, 2, 3}, 1), 2, {1, -2, .5}, {0.1, 2, 0.1});  // about the middle axis: it tumbles
    double const before = body.kinetic();
    Vec3 const L = body.angular(), P = body.momentum();
    double worst = 0;
    for (int i = 0; i < steps; ++i) {
      body.advance(10.0 / steps, {0, 0, 0}, {0, 0, 0});
      worst = std::max(worst, std::fabs(body.kinetic() / before - 1));
    }
    CHECK(body.angular() == L);
    CHECK(body.momentum() == P);
    return worst;
  };
  double const coarse = drift(400), fine = drift(800);
  CHECK(fine < 1e-4);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.1));
}

TEST_CASE("impulses move a sphere as Newton and Euler say", "[overset][rigid]") {
  RigidMotion body(make_sphere(0.5, 0.1), 8, {1, 0, 0}, {0, 0, 0});
  double const M = body.mass();
  Vec3 const at = body.centre();
  // a constant force along y and moment along z: the mid-point rule is exact
  for (int i = 0; i < 10; ++i) body.advance(0.1, {0, 0.1 * M, 0}, {0, 0, 0.01});
  CHECK(length(body.velocity() - Vec3{1, 1, 0}) < 1e-14);
  CHECK(length(body.centre() - at - Vec3{1, 0.5, 0}) < 1e-14);
  double const inertia = 0.1 * M;                                // 2/5 M r^2
  CHECK(body.spin()[2] == Approx(0.1 / inertia).epsilon(0.02));  // the polyhedron is a little less than the sphere
  CHECK(length(body.place(at) - body.centre()) < 1e-15);
  CHECK_THROWS_AS(RigidMotion(TriangleSurface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 1, {0, 0, 0}, {0, 0, 0}),
                  SurfaceError);
}
