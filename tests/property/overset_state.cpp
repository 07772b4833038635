// A solver of gas and bodies goes on from its state bit by bit; what gas and bodies hold adds up.
#include <cmath>

#include "fsi/overset/gas_integrals.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/gap.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

constexpr double size = 1, edge = 0.3;

/// Two cubes, one behind the other along x, in boxes that overlap: each window holds a part of the other's cube.
OversetSetup two_cubes(SolidMedium const& medium, int n, bool closure, double gap) {
  OversetSetup setup;
  setup.gas = gas_cube(IdealGas{1.4}, size, n);
  setup.closure = closure;
  double const h = size / n, apart = 0.5 * (edge + gap);
  SolidPoint const rest = solid_state(medium, medium.rho0 * (1 + 1e-3), {0, 0, 0}, 1e-3 * 175e9);
  for (double side : {-1.0, 1.0}) {
    Vec3 const middle{0.5 + side * apart, 0.503, 0.497};
    BodySetup b{.surface = placed(make_box({edge, edge, edge}, h), {0, 0, 1}, 0, middle),
                .material = medium.scheme,
                .cell = h,
                .initial = [=](Vec3 const&) { return rest; }};
    double const reach = 0.5 * edge + h;
    b.lower = middle - Vec3{reach, reach, reach}, b.upper = middle + Vec3{reach, reach, reach};
    setup.bodies.push_back(std::move(b));
  }
  return setup;
}

}  // namespace

TEST_CASE("a solver goes on from its state bit by bit") {
  SolidMedium const steel = solid_medium("steel", true);
  auto const blast = [](Vec3 const& x) {
    return x[0] < 0.15 ? GasPoint{2000, {0, 0, 0}, 2e9} : GasPoint{500, {0, 0, 0}, 1.75e8};
  };
  for (bool closure : {false, true}) {
    OversetSetup const setup = two_cubes(steel, 16, closure, 0.1);
    OversetSolver whole(setup, blast);
    for (int n = 0; n < 7; ++n) REQUIRE(whole.step(1e300).status == StepStatus::ok);
    OversetSolver first(setup, blast);
    for (int n = 0; n < 3; ++n) REQUIRE(first.step(1e300).status == StepStatus::ok);
    OversetSolver second(setup, first.state());
    CHECK(second.stable_dt() == first.stable_dt());
    for (int n = 0; n < 4; ++n) REQUIRE(second.step(1e300).status == StepStatus::ok);
    auto a = whole.state().arrays, b = second.state().arrays;
    REQUIRE(a.size() == b.size());
    for (auto const& [name, values] : a) {
      INFO(name);
      if (name != "clock") CHECK(values == b.at(name));  // the clock counts seconds as well
    }
    CHECK(whole.time() == second.time());
    CHECK(whole.counters().problems == second.counters().problems);
    CHECK(whole.counters().first_order == second.counters().first_order);
    CHECK(whole.bodies()[0]->triangles[0].pressure > 1.75e8);  // something did happen
  }
}

TEST_CASE("a body cut by a plane goes on bit by bit after triangles were meshed anew") {
  SolidMedium const steel = solid_medium("steel");
  double const h = size / 16, p = 1e9;
  Vec3 const u{500, 300, 0};
  OversetSetup setup;
  setup.gas = gas_cube(IdealGas{1.4}, size, 16);
  setup.gas.sides[4].kind = GridBoundary::Kind::wall;
  TriangleSurface const whole = placed(make_box({6 * h, 6 * h, 6 * h}, h), {0, 0, 1}, 0.6, {0.503, 0.507, 0});
  setup.bodies.push_back(
      {.surface = clip_surface(whole, 2, 0, true, 0.3 * h),
       .material = steel.scheme,
       .cell = h,
       .lower = {0.2, 0.2, -0.3},
       .upper = {0.8, 0.8, 0.3},
       .initial = [=](Vec3 const&) { return solid_state(steel, steel.rho0 * (1 + p / 175e9), u, p); }});
  setup.remeshing = {.on = true, .shortest = 0.4, .longest = 0.9};
  auto const stream = [=](Vec3 const&) { return GasPoint{780, u, p}; };
  OversetSolver first(setup, stream);
  std::size_t const vertices = first.bodies()[0]->surface.vertices.size();
  for (int n = 0; n < 4; ++n) REQUIRE(first.step(1e300).status == StepStatus::ok);
  CHECK(first.bodies()[0]->surface.vertices.size() > vertices);
  OversetSolver second(setup, first.state());
  CHECK(second.bodies()[0]->cut.on_planes == first.bodies()[0]->cut.on_planes);
  for (int n = 0; n < 3; ++n) {
    REQUIRE(first.step(1e300).status == StepStatus::ok);
    REQUIRE(second.step(1e300).status == StepStatus::ok);
  }
  CHECK(second.bodies()[0]->surface.vertices == first.bodies()[0]->surface.vertices);
}

TEST_CASE("a state of another setup is refused") {
  SolidMedium const steel = solid_medium("steel");
  auto const still = [](Vec3 const&) { return GasPoint{500, {0, 0, 0}, 1.75e8}; };
  OversetSolver const solver(two_cubes(steel, 16, false, 0.1), still);
  OversetSetup other = two_cubes(steel, 16, false, 0.1);
  other.bodies[0].lower = other.bodies[0].lower - Vec3{0.1, 0, 0};
  CHECK_THROWS_AS(OversetSolver(other, solver.state()), std::invalid_argument);
}

TEST_CASE("bodies that reach into each other's windows leave a gas at rest alone") {
  SolidMedium const steel = solid_medium("steel");
  double const p = 1.75e8;
  for (double gap : {0.07, 0.2}) {
    OversetSolver solver(two_cubes(steel, 16, false, gap), [=](Vec3 const&) { return GasPoint{500, {0, 0, 0}, p}; });
    for (int n = 0; n < 5; ++n) REQUIRE(solver.step(1e300).status == StepStatus::ok);
    for (auto const& b : solver.bodies()) {
      // within the other cube there is no gas
      for (auto const& other : solver.bodies()) {
        Vec3 const middle = mass_properties(other->surface).centroid;
        WindowBox const& box = b->gas.kinds.box();
        double const left = box.lower[0] + box.first[0] * box.h, right = left + box.size[0] * box.h;
        Vec3 const inside{std::clamp(middle[0], left + 0.1 * box.h, right - 0.1 * box.h), middle[1], middle[2]};
        if (within(inside, other->surface)) CHECK_FALSE(b->gas.kinds.in_medium(inside));
      }
      // the pressure's round-off, on the scale of the solid's stiffness
      for (TriangleState const& t : b->triangles) CHECK(std::fabs(t.pressure / p - 1) < 1e-11);
    }
  }
}

TEST_CASE("gas and bodies fill the box, and gas holds what it has there") {
  SolidMedium const steel = solid_medium("steel");
  Vec3 const u{3, -2, 1};
  GasPoint const stream{500, u, 1.75e8};
  OversetSolver const solver(two_cubes(steel, 16, false, 0.1), [=](Vec3 const&) { return stream; });
  GasIntegrals const gas = gas_integrals(solver);
  double bodies = 0;
  for (auto const& b : solver.bodies()) bodies += mass_properties(b->surface).volume;
  CHECK(gas.volume + bodies == Approx(1).epsilon(1e-12));  // parts of cut cells are scaled to the polyhedra
  CHECK(gas.mass == Approx(500 * gas.volume).epsilon(1e-13));
  double const e = 1.75e8 / 0.4 + 0.5 * 500 * dot(u, u);
  CHECK(gas.energy == Approx(e * gas.volume).epsilon(1e-13));
  for (std::size_t a = 0; a < 3; ++a) CHECK(gas.momentum[a] == Approx(500 * u[a] * gas.volume).epsilon(1e-12));
  auto const share = gas_share(solver);
  double sum = 0;
  for (double s : share) sum += s;
  CHECK(sum * std::pow(size / 16, 3) == Approx(gas.volume).epsilon(1e-12));
}

TEST_CASE("distances of points, triangles and surfaces") {
  std::array<Vec3, 3> const t{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 1, 0}};
  CHECK(distance({0.2, 0.2, 0.7}, t) == Approx(0.7));           // over the middle
  CHECK(distance({-3, -4, 0}, t) == Approx(5));                 // a corner
  CHECK(distance({1, -2, 0}, t) == Approx(2));                  // an edge
  CHECK(distance({2, 1, 0}, t) == Approx(2 / std::sqrt(5.0)));  // the slanting edge, x + 2 y = 2
  TriangleSurface const a = make_box({1, 1, 1}, 0.5);
  TriangleSurface b = a;
  for (Vec3& x : b.vertices) x = x + Vec3{1.25, 0.1, 0};
  CHECK(gap_between(a, b, 1) == Approx(0.25));
  CHECK(gap_between(a, b, 0.1) == 0.1);
  CHECK(within({0.49, 0.49, -0.49}, a));
  CHECK_FALSE(within({0.51, 0, 0}, a));
}
