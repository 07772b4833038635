// Bodies that are bonded to walls of the domain.
#include <cmath>

#include "fsi/overset/body_integrals.hpp"
#include "fsi/overset/overset_solver.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

constexpr double h = 1.0 / 18, p0 = 1e6, speed = 10, edge = 1;
constexpr double bulk = 175e9, shear = 80.77e9;

/// Half of a steel cube in thin gas at its pressure, on the wall x = 0, moving at `u`.
OversetSetup half_cube(bool clamped) {
  SolidMedium const steel = solid_medium("steel");
  GasGridSetup gas{.eos = IdealGas{1.4}, .lower = {0, -1, -1}, .upper = {1, 1, 1}, .cells = {12, 24, 24}};
  gas.sides[0].kind = GridBoundary::Kind::wall;
  OversetSetup s{.gas = gas};
  s.remeshing.on = false;
  TriangleSurface surface = clip_surface(make_box({edge, edge, edge}, 1.1 * h), 0, 0, true, 0.3 * h);
  s.bodies.push_back({.surface = std::move(surface),
                      .material = steel.scheme,
                      .cell = h,
                      .lower = {0, -0.7, -0.7},
                      .upper = {0.7, 0.7, 0.7},
                      .initial = {}});
  s.bodies[0].clamps.low[0] = clamped;
  return s;
}

OversetSolver moving(OversetSetup s, Vec3 const& u) {
  SolidMedium const steel = solid_medium("steel");
  s.bodies[0].initial = [=](Vec3 const&) { return solid_state(steel, steel.rho0 * (1 + p0 / bulk), u, p0); };
  return {std::move(s), [](Vec3 const&) { return GasPoint{0.1, {0, 0, 0}, p0}; }};
}

double run(OversetSolver& solver, double end) {
  while (solver.time() < end) REQUIRE(solver.step(end).status == StepStatus::ok);
  return solver.time();
}

}  // namespace

TEST_CASE("a state beyond a clamp has the opposite velocity and the same stress") {
  SolidFields q{1, 2, 3, 4, 5};
  for (std::size_t c = 0; c < 6; ++c) q[solid_field_of::S + c] = 10.0 + static_cast<double>(c);
  Clamps none, on_y;
  on_y.low[1] = true;
  CHECK(reflected(q, {0, -1, 0}, none) == reflected(q, {0, -1, 0}));
  CHECK(reflected(q, {0, 1, 0}, on_y) == reflected(q, {0, 1, 0}));  // the upper plane is one of symmetry
  SolidFields expected = q;
  for (std::size_t a = 0; a < 3; ++a) expected[solid_field_of::u + a] = -q[solid_field_of::u + a];
  CHECK(reflected(q, {0, -1, 0}, on_y) == expected);
  // both: the mirror image, then the clamp
  expected = reflected(q, {0, 0, 1});
  for (std::size_t a = 0; a < 3; ++a) expected[solid_field_of::u + a] = -expected[solid_field_of::u + a];
  CHECK(reflected(q, {0, -1, 1}, on_y) == expected);
  CHECK(reflected(Vec3{1, 2, 3}, {0, -1, 1}, on_y) == Vec3{-1, -2, 3});
}

TEST_CASE("a clamped body at rest under its pressure stays at rest") {
  OversetSetup s = half_cube(true);
  s.skip = false;
  OversetSolver solver = moving(std::move(s), {0, 0, 0});
  for (int n = 0; n < 10; ++n) REQUIRE(solver.step(1).status == StepStatus::ok);
  double fastest = 0;
  for (TriangleState const& t : solver.bodies()[0]->triangles) fastest = std::max(fastest, length(t.velocity));
  CHECK(fastest < 1e-8);  // round-off of stresses, 1e-16 of 175 GPa, over the impedance, 5e7 Pa s/m, in 10 steps
}

TEST_CASE("a clamp takes the momentum of the wave that it sends, along it and across") {
  // Until waves come back from the opposite face the traction on the wall is the impedance times the velocity, less
  // what P waves from the free sides relieve: at most strips of the wall that grow to c_p t, two of them, along it
  // four.
  double const rho = 7800, c_p = std::sqrt((bulk + 4 * shear / 3) / rho), c_s = std::sqrt(shear / rho);
  double const end = 0.2 * edge / c_p;
  for (auto const& [u, c] : {std::pair{Vec3{0, speed, 0}, c_s}, std::pair{Vec3{-speed, 0, 0}, c_p}}) {
    double const taken = rho * c * speed * edge * edge * end;
    OversetSolver held = moving(half_cube(true), u), mirrored = moving(half_cube(false), u);
    Vec3 const before = integrals(*held.bodies()[0]).momentum;
    run(held, end), run(mirrored, end);
    double const lost = dot(before - integrals(*held.bodies()[0]).momentum, (1 / speed) * u) / taken;
    double const at_mirror = dot(before - integrals(*mirrored.bodies()[0]).momentum, (1 / speed) * u) / taken;
    INFO("of " << u[0] << ", " << u[1] << ": " << lost << ", at a plane of symmetry " << at_mirror);
    bool const along = u[0] != 0;
    CHECK(lost < 1.02);
    CHECK(lost > (along ? 0.6 : 0.8));
    CHECK(at_mirror == Approx(along ? lost : 0).margin(0.07));
  }
}

TEST_CASE("what lies on a clamp stays, and a stored state goes on bit by bit") {
  OversetSolver whole = moving(half_cube(true), {0, speed, 0});
  TriangleSurface const start = whole.bodies()[0]->surface;
  for (int n = 0; n < 6; ++n) REQUIRE(whole.step(1).status == StepStatus::ok);
  OversetSolver second(half_cube(true), whole.state());
  for (int n = 0; n < 6; ++n) {
    REQUIRE(whole.step(1).status == StepStatus::ok);
    REQUIRE(second.step(1).status == StepStatus::ok);
  }
  CHECK(second.state().arrays.at("body/0/vertices") == whole.state().arrays.at("body/0/vertices"));
  CHECK(second.state().arrays.at("body/0/triangle_states") == whole.state().arrays.at("body/0/triangle_states"));
  TriangleSurface const& now = whole.bodies()[0]->surface;
  std::size_t on_wall = 0;
  for (std::size_t v = 0; v < start.vertices.size(); ++v) {
    if (start.vertices[v][0] != 0) continue;
    CHECK(now.vertices[v] == start.vertices[v]);
    ++on_wall;
  }
  CHECK(on_wall > 0);
}

TEST_CASE("a clamp where the body is not cut is refused, and a rigid body that is clamped") {
  OversetSetup s = half_cube(true);
  s.bodies[0].clamps.high[0] = true;
  CHECK_THROWS_AS(moving(s, {0, 0, 0}), SurfaceError);
  OversetSetup rigid = half_cube(true);
  rigid.bodies[0].rigid = RigidSetup{.density = 7800};
  CHECK_THROWS_AS(moving(rigid, {0, 0, 0}), SurfaceError);
}
