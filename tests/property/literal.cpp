// Readings of the paper that are compared: each does what it says, and what is used does not.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "fsi/overset/overset_solver.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

/// A turned cube of steel, 6 cells an edge, in gas at rest.
OversetSetup cube_in_gas(Literal const& literal) {
  SolidMedium const steel = solid_medium("steel");
  int const n = 16;
  double const h = 1.0 / n, edge = 6 * h;
  OversetSetup s{.gas = gas_cube(IdealGas{1.4}, 1, n), .bodies = {}};
  BodySetup b{.surface = placed(make_box({edge, edge, edge}, h), {0.3, 0.5, 1}, 0.6, {0.503, 0.507, 0.493}),
              .material = steel.scheme,
              .cell = h,
              .initial = [=](Vec3 const&) {
                return solid_state(steel, steel.rho0, {0, 0, 0}, 0);
              }};
  auto const box = bounding_box(b.surface);
  b.lower = box.lower - Vec3{h, h, h}, b.upper = box.upper + Vec3{h, h, h};
  s.bodies.push_back(std::move(b));
  s.literal = literal;
  return s;
}

constexpr double p_gas = 1e9;

/// The gas presses, more from one side: waves are in the cube after a few steps.
struct PressedCube {
  OversetSolver solver;
  explicit PressedCube(Literal const& literal)
      : solver(cube_in_gas(literal), [](Vec3 const& x) {
          return GasPoint{100, {0, 0, 0}, p_gas * (1 + x[0])};
        }) {
    for (int k = 0; k < 5; ++k) REQUIRE(solver.step(1e300).status == StepStatus::ok);
  }
  [[nodiscard]] Body const& body() const { return *solver.bodies()[0]; }
};

Body cube(Literal const& literal) {
  OversetSetup const s = cube_in_gas(literal);
  return Body(s.bodies[0], GasGrid(s.gas), s.solid_options, literal);
}

/// Ways of the vertices in a unit of time.
std::vector<Vec3> ways(Body& body) {
  std::vector<Vec3> way = body.surface.vertices;
  body.move_vertices(1, 0);
  for (std::size_t v = 0; v < way.size(); ++v) way[v] = body.surface.vertices[v] - way[v];
  return way;
}

/// Cells within a sphere, and points beneath its surface.
struct Ball {
  static constexpr double h = 0.15;
  CellKinds kinds{{.lower = {-9 * h, -9 * h, -9 * h}, .h = h, .grid = {18, 18, 18}, .first = {}, .size = {18, 18, 18}},
                  true};
  TriangleSurface surface = make_sphere(1, 0.2);
  std::vector<CloudPoint<SolidFields>> cloud{};

  Ball() {
    TriangleSurface const* const one = &surface;
    kinds.classify(std::span(&one, 1));
    for (std::size_t t = 0; t < surface.size(); ++t) {
      Vec3 const x = surface.centre(t) - 0.07 * surface.normal(t);
      cloud.push_back({x, field(x), 0});
    }
  }
  static SolidFields field(Vec3 const& x) {
    SolidFields q{};
    q[0] = 1, q[1] = 1 + x[0] - 2 * x[1], q[2] = 0.5 * x[2], q[3] = x[0] + x[1] + x[2];
    return q;
  }
  /// Calls f with random points within.
  template <class F>
  static void for_each_point(F const& f) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-0.7, 0.7);
    for (int n = 0; n < 4000; ++n) {
      if (Vec3 const x{place(random), place(random), place(random)}; length(x) < 0.98) f(x);
    }
  }
};

}  // namespace

TEST_CASE("local grids start from the cores' own states, or from what is interpolated to their places") {
  for (bool const anew : {false, true}) {
    PressedCube const pressed({.reinterpolated_cores = anew});
    Body const& b = pressed.body();
    Body::Nearby nearby(b);
    double const h = b.setup.cell, h_gas = pressed.solver.gas().widths()[0];
    int other = 0, wrong = 0, cores = 0;
    auto const judge = [&](double used, double own, double interpolated) {
      ++cores, other += std::fabs(interpolated - own) > 1e-6 * p_gas ? 1 : 0;
      // the donors may be summed up in another order: round-off of some fifty terms
      double const error = anew ? std::fabs(used - interpolated) / p_gas : std::fabs(used - own);
      wrong += error <= (anew ? 1e-12 : 0) ? 0 : 1;
    };
    for (std::size_t n = 0; n < b.triangles.size(); ++n) {
      TriangleState const& t = b.triangles[n];
      ModelStencil const s = b.stencil(n, nearby);
      for (std::size_t k = 0; k < core_layers; ++k) {
        Vec3 const x = core_centre(t, k, h_gas), y = core_centre(t, k, -h);
        if (!b.gas.kinds.in_medium(x) || !b.solid.kinds.in_medium(y)) continue;
        // there local grids have a quadratic fit, and what only has a place has a linear one
        if (s.inner && !b.solid.kinds.resolved(y)) continue;
        GasFields const q = b.gas.donors.at(x, Donors<GasFields>::From::valid, {});
        SolidFields const r = b.solid.donors.at(y, Donors<SolidFields>::From::valid, {});
        judge(s.gas[k][1][1][gas_field::p], t.gas[k][gas_field::p], q[gas_field::p]);
        judge(s.solid[k][1][1][solid_field_of::p], t.solid[k][solid_field_of::p], r[solid_field_of::p]);
      }
    }
    CHECK(cores > 500);
    CHECK(other > cores / 2);
    CHECK(wrong == 0);
  }
}

TEST_CASE("interpolated velocities leave the donors' range as linear fields do, or stay within it") {
  Ball const ball;
  std::vector<SolidFields> states(ball.kinds.count());
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = Ball::field(ball.kinds.centre(ball.kinds.cell(i)));
  Donors<SolidFields> used(ball.kinds, states, {}), clipped(ball.kinds, states, {}, {.clipped_velocities = true});
  used.set_cloud(ball.cloud, false), clipped.set_cloud(ball.cloud, false);
  int beyond = 0;
  Ball::for_each_point([&](Vec3 const& x) {
    // those of a fit are within 1.6 cells, the eight cells around a point within the root of 3
    SolidFields low, high;
    low.fill(1e300), high.fill(-1e300);
    auto const add = [&](Vec3 const& y, SolidFields const& q) {
      if (length(y - x) > 1.7321 * Ball::h) return;
      for (std::size_t f = 0; f < q.size(); ++f) low[f] = std::min(low[f], q[f]), high[f] = std::max(high[f], q[f]);
    };
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (ball.kinds.valid(i)) add(ball.kinds.centre(ball.kinds.cell(i)), states[i]);
    }
    for (auto const& point : ball.cloud) add(point.x, point.q);
    SolidFields const exact = Ball::field(x), free = used.at(x, Donors<SolidFields>::From::valid, {}),
                      held = clipped.at(x, Donors<SolidFields>::From::valid, {});
    for (std::size_t f = 1; f <= 3; ++f) {
      CHECK(std::fabs(free[f] - exact[f]) < 1e-11);
      CHECK(held[f] >= low[f]);
      CHECK(held[f] <= high[f]);
      beyond += exact[f] < low[f] - 1e-3 || exact[f] > high[f] + 1e-3 ? 1 : 0;
    }
  });
  CHECK(beyond > 10);
}

TEST_CASE("vertices take the velocity of their sides, or its parts along the normals alone") {
  Vec3 const u{0.3, -0.2, 0.5};
  for (bool const normal : {false, true}) {
    Body body = cube({.normal_motion = normal});
    for (TriangleState& t : body.triangles) t.velocity = u;
    std::vector<Vec3> const way = ways(body);
    int on_sides = 0;
    for (std::size_t v = 0; v < way.size(); ++v) {
      // the cube's normals are at right angles: each side around adds its part
      std::vector<Vec3> sides;
      Vec3 along{0, 0, 0};
      for (int t : body.around[v]) {
        Vec3 const n = body.triangles[static_cast<std::size_t>(t)].frame.n;
        if (std::any_of(sides.begin(), sides.end(), [&](Vec3 const& m) { return dot(n, m) > 0.9; })) continue;
        sides.push_back(n), along = along + dot(u, n) * n;
      }
      on_sides += sides.size() == 1 ? 1 : 0;
      CHECK(length(way[v] - (normal ? along : u)) < 1e-13);
    }
    CHECK(on_sides > 100);
  }
}

TEST_CASE("vertices move linearly between triangles, or by the velocities of their centres") {
  auto const linear = [](Vec3 const& x) { return Vec3{3 + x[0] - 2 * x[1], 0.5 * x[2] - x[0], x[0] + x[1] + x[2]}; };
  for (bool const level : {false, true}) {
    Body body = cube({.level_motion = level}), still = cube({.level_motion = level});
    auto const place = body.surface.vertices;
    for (std::size_t n = 0; n < body.triangles.size(); ++n) {
      TriangleState& t = body.triangles[n];
      t.velocity = still.triangles[n].velocity = linear(t.centre);
      t.gradient = {linear(t.frame.a) - linear({0, 0, 0}), linear(t.frame.b) - linear({0, 0, 0})};
    }
    std::vector<Vec3> const way = ways(body), without = ways(still);
    double from_linear = 0;
    for (std::size_t v = 0; v < way.size(); ++v) {
      from_linear = std::max(from_linear, length(way[v] - linear(place[v])));
      if (level) CHECK(way[v] == without[v]);
    }
    CHECK((from_linear < 1e-13) == !level);
  }
}

TEST_CASE("cells beside the surface are donors, or are not read") {
  Ball const ball;
  std::vector<SolidFields> states(ball.kinds.count());
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i] = Ball::field(ball.kinds.centre(ball.kinds.cell(i)));
    if (ball.kinds.kind(i) == CellKind::shallow) states[i].fill(std::numeric_limits<double>::quiet_NaN());
  }
  for (bool const deep : {false, true}) {
    Donors<SolidFields> donors(ball.kinds, states, {}, {.deep_donors = deep});
    donors.set_cloud(ball.cloud, false);
    int read = 0;
    Ball::for_each_point([&](Vec3 const& x) {
      for (double q : donors.at(x, Donors<SolidFields>::From::valid, {})) read += std::isnan(q) ? 1 : 0;
    });
    CHECK((read > 0) == !deep);
  }
}

TEST_CASE("beyond sides of the body is the traction of the gas, or the stress within") {
  for (bool const continued : {false, true}) {
    PressedCube const pressed({.continued_stress = continued});
    Body const& b = pressed.body();
    Body::Nearby nearby(b);
    int ghosts = 0, as_within = 0;
    for (std::size_t n = 0; n < b.triangles.size(); ++n) {
      ModelStencil const s = b.stencil(n, nearby);
      for (std::size_t i = 0; i < 9; ++i) {
        SolidFields const &q = s.solid[0][i / 3][i % 3], &centre = s.solid[0][1][1];
        if (!s.solid_ghost[0][i / 3][i % 3]) continue;
        bool same = true;
        for (std::size_t f = solid_field_of::p; f < q.size(); ++f) same = same && q[f] == centre[f];
        ++ghosts, as_within += same ? 1 : 0;
      }
    }
    CHECK(ghosts > 100);
    CHECK(as_within == (continued ? ghosts : 0));
  }
}
