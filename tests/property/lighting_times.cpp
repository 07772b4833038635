/// What holds for lighting times around any obstacles.
#include <algorithm>
#include <cmath>
#include <limits>

#include "scheme/grid/cell_place.hpp"
#include "scheme/step/lighting_times.hpp"
#include "scheme/step/programmed_burn.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

constexpr double never = std::numeric_limits<double>::infinity(), D = 7.5;

Obstacle box(Vec3 const& lower, Vec3 const& upper) {
  return [=](Vec3 const& x) {
    double most = -1e300;
    for (std::size_t a = 0; a < 3; ++a) most = std::max({most, lower[a] - x[a], x[a] - upper[a]});
    return most - 1e-9;
  };
}
Obstacle ball(Vec3 const& c, double r) {
  return [=](Vec3 const& x) { return std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]) - r; };
}

/// A ball of explosive of radius 1 in a box of 24 x 24 x 20 cells.
LightingSetup charge(std::vector<Obstacle> obstacles, std::vector<IgnitionPoint> ignition) {
  return {.lower = {-1.2, -1.2, -1},
          .upper = {1.2, 1.2, 1},
          .cells = {24, 24, 20},
          .first = {1, 2, 0},
          .last = {23, 22, 20},
          .explosive = [](Vec3 const& x) { return std::hypot(x[0], x[1], x[2]) <= 1; },
          .obstacles = std::move(obstacles),
          .ignition = std::move(ignition),
          .speed = D};
}

template <class F>
void each_centre(LightingSetup const& setup, F const& f) {
  Vec3 const h = cell_widths(setup.lower, setup.upper, setup.cells);
  for_each_cell(setup.cells, [&](Int3 const& cell) { f(cell_centre(setup.lower, h, {true, true, true}, cell)); });
}

double way(Vec3 const& a, Vec3 const& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

/// Of times that are the same but for the order in which bends were found: no farther apart than times are wrong, which
/// around a sphere are late by a fifth of a cell at most, and by a hundredth in the mean; here ways turn up to three
/// times.
struct Gap {
  double sum = 0, most = 0;
  int count = 0;
  void add(double a, double b) {
    REQUIRE((a >= 0) == (b >= 0));
    if (!(a >= 0)) return;
    double const cells = std::fabs(a - b) * D / 0.1;
    ++count, sum += cells, most = std::max(most, cells);
  }
  void check() const {
    CHECK(count > 3000);
    CHECK(most <= 0.3);
    CHECK(sum <= 0.01 * count);
  }
};

std::vector<Obstacle> const three{box({-0.4, -0.5, -0.6}, {0.1, 0.2, 0.3}), box({0.1, -0.3, -0.6}, {0.4, 0.6, 0}),
                                  ball({0.2, 0.5, 0.4}, 0.25)};
Vec3 const corner{-0.6, -0.5, 0.2};

}  // namespace

TEST_CASE("without obstacles lighting times are straight, bit by bit", "[lighting]") {
  std::vector<IgnitionPoint> const points{{corner, 0}, {{0.3, 0.2, -0.4}, 0.05}};
  LightingSetup const setup = charge({}, points);
  LightingTimes const times(setup);
  int lit = 0;
  each_centre(setup, [&](Vec3 const& x) {
    double const expected = way({0, 0, 0}, x) <= 1 ? std::min(way(points[0].x, x) / D, 0.05 + way(points[1].x, x) / D)
                                                   : ProgrammedBurn::no_explosive;
    // the cells [first, last) hold the ball but for its poles along y
    bool const part = std::fabs(x[1]) < 1;
    CHECK(times(x) == (part ? expected : ProgrammedBurn::no_explosive));
    lit += times(x) >= 0 ? 1 : 0;
  });
  CHECK(lit > 4000);
}

TEST_CASE("obstacles delay a front, and of several the soonest counts", "[lighting]") {
  Vec3 const other{0.5, -0.5, 0.5};
  LightingSetup const setup = charge(three, {{corner}});
  LightingTimes const free(charge({}, {{corner}})), one(setup), second(charge(three, {{other, 0.03}})),
      both(charge(three, {{corner}, {other, 0.03}}));
  int delayed = 0, none = 0;
  Gap gap;
  each_centre(setup, [&](Vec3 const& x) {
    if (std::any_of(three.begin(), three.end(), [&](Obstacle const& o) { return o(x) < 0; })) {
      ++none;
      CHECK(one(x) == ProgrammedBurn::no_explosive);
      return;
    }
    if (free(x) == ProgrammedBurn::no_explosive) return;
    CHECK(one(x) >= free(x));
    CHECK(one(x) < never);
    delayed += one(x) > free(x) ? 1 : 0;
    gap.add(both(x), std::min(one(x), second(x)));
  });
  gap.check();
  CHECK(delayed > 500);
  CHECK(none > 400);
}

TEST_CASE("a front does not take longer from a cell to the next than the way between them", "[lighting]") {
  LightingSetup const setup = charge(three, {{corner}});
  LightingTimes const times(setup);
  Vec3 const h = cell_widths(setup.lower, setup.upper, setup.cells);
  int pairs = 0;
  each_centre(setup, [&](Vec3 const& x) {
    if (!(times(x) >= 0)) return;
    for (std::size_t a = 0; a < 3; ++a) {
      Vec3 y = x;
      y[a] += h[a];
      if (y[a] > setup.upper[a] || !(times(y) >= 0)) continue;
      ++pairs;
      // gains of less than 1e-4 of a cell are not sought
      CHECK(std::fabs(times(y) - times(x)) <= h[a] / D * (1 + 1.01e-4));
    }
  });
  CHECK(pairs > 9000);
}

TEST_CASE("lighting times of a mirror image are the mirror image", "[lighting]") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const mirrored = [axis](Vec3 x) {
      x[axis] = -x[axis];
      return x;
    };
    std::vector<Obstacle> images;
    for (Obstacle const& o : three) images.push_back([=](Vec3 const& x) { return o(mirrored(x)); });
    LightingSetup const setup = charge(three, {{corner}});
    LightingSetup image = charge(images, {{mirrored(corner)}});
    LightingTimes const times(setup), other(image);
    Gap gap;
    each_centre(setup, [&](Vec3 const& x) { gap.add(times(x), other(mirrored(x))); });
    gap.check();
  }
}

TEST_CASE("a half between planes of symmetry is lit as the whole", "[lighting]") {
  // a bar across the plane x = 0, lit on it
  LightingSetup const setup = charge({box({-0.5, -0.1, -0.6}, {0.5, 0.2, 0.3})}, {{{0, -0.6, 0.1}}});
  LightingSetup half = charge({box({0, -0.1, -0.6}, {0.5, 0.2, 0.3})}, {{{0, -0.6, 0.1}}});
  half.lower[0] = 0, half.cells[0] = 12, half.first[0] = 0, half.last[0] = 12;
  LightingTimes const whole(setup), part(half);
  Gap gap;
  each_centre(setup, [&](Vec3 const& x) { gap.add(whole(x), part(x)); });  // cells beyond the plane are images
  gap.check();
}

TEST_CASE("no front passes between blocks that touch, and none comes to what they enclose", "[lighting]") {
  // a wall of four boxes that meet in a line through the point of ignition's height
  std::vector<Obstacle> wall;
  for (double const y : {-2.0, 0.0}) {
    for (double const z : {-2.0, 0.0}) wall.push_back(box({0, y, z}, {0.3, y + 2, z + 2}));
  }
  LightingSetup const setup = charge(wall, {{{-0.5, 0, 0}}});
  LightingTimes const times(setup);
  int dark = 0;
  each_centre(setup, [&](Vec3 const& x) {
    if (times(x) == ProgrammedBurn::no_explosive) return;
    CHECK((times(x) == never) == (x[0] > 0.3));
    dark += times(x) == never ? 1 : 0;
  });
  CHECK(dark > 800);
  // one box in two parts, with the ray to the part's edge along their common side
  LightingTimes const parts(
      charge({box({-0.2, -0.5, -0.5}, {0.3, 0, 0.5}), box({-0.2, 0, -0.5}, {0.3, 0.4, 0.5})}, {{{-0.6, 0, 0}}})),
      one(charge({box({-0.2, -0.5, -0.5}, {0.3, 0.4, 0.5})}, {{{-0.6, 0, 0}}}));
  Gap gap;
  each_centre(setup, [&](Vec3 const& x) { gap.add(parts(x), one(x)); });
  gap.check();
}
