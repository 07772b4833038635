/// Lighting times around a sphere against the eikonal equation, and without one against Kenamond's table.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/reference_table.hpp"
#include "verification/exact/kenamond.hpp"

using namespace g27;

namespace {

using Point = std::array<double, 3>;

Kenamond const problem{.speed = 1.7, .radius = 0.6, .centre = {0.2, -0.1, 0.3}, .ignition = {-0.9, 0.4, 0.1}};

/// Centre, direction and distance from there.
Point at(Point const& direction, double r) {
  double const size = std::hypot(direction[0], direction[1], direction[2]);
  Point x = problem.centre;
  for (std::size_t a = 0; a < 3; ++a) x[a] += r * direction[a] / size;
  return x;
}

}  // namespace

TEST_CASE("without a sphere lighting times are those of Kenamond's table", "[oracle]") {
  Kenamond const first{.ignition = {0, 0, 0}};
  ReferenceTable const table = read_reference("kenamond1.csv", {"x", "y", "burntime"});
  REQUIRE(table.rows.size() > 400);
  // ten digits
  for (auto const& row : table.rows) CHECK(std::fabs(first.time({row[0], row[1], 0}) - row[2]) <= 1e-8);
}

TEST_CASE("lighting times around a sphere satisfy the eikonal equation, lit directly and behind", "[oracle]") {
  // lit, behind and far behind; none opposite to the point of ignition, where ways meet
  int behind = 0;
  for (Point const& direction : {Point{-1, 0.2, 0.4}, {0.3, 1, 0}, {1, 0.3, -0.2}, {1, -0.7, 0.3}, {0.4, -1, 1}}) {
    for (double const r : {0.65, 1.0, 2.3}) {
      Point const x = at(direction, r);
      behind += problem.arc(x) > 0 ? 1 : 0;
      double squared = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        constexpr double h = 1e-5;
        Point low = x, high = x;
        low[a] -= h, high[a] += h;
        double const slope = (problem.time(high) - problem.time(low)) / (2 * h);
        squared += slope * slope;
      }
      // second differences over lengths of a tenth and more: h^2 / 0.1^2 and round-off over h
      CHECK(squared * problem.speed * problem.speed == Approx(1).epsilon(1e-7));
    }
  }
  CHECK(behind >= 5);
}

TEST_CASE("behind the sphere a front goes on without a jump, and leaves the sphere along tangents", "[oracle]") {
  // from the tangent on: the straight way on one side of the shadow's border, the arc on the other
  double const a = std::hypot(-1.1, 0.5, -0.2), R = problem.radius;
  Kenamond const plain{.speed = 1, .radius = R, .centre = {0, 0, 0}, .ignition = {-a, 0, 0}};
  double const opening = std::asin(R / a);
  for (double const r : {0.1, 0.5, 2.0}) {  // beyond the point of touch, over the way to it
    double const way = (1 + r) * std::sqrt(a * a - R * R);
    for (double const off : {-1e-6, 1e-6}) {
      Point const x{-a + way * std::cos(opening + off), way * std::sin(opening + off), 0};
      CHECK((plain.arc(x) > 0) == (off < 0));
      // continuous to the first derivative: off^2
      CHECK(plain.time(x) == Approx(way).epsilon(1e-9));
    }
  }
  // opposite: two tangents and the arc between them
  double const b = 1.4, t = std::sqrt(a * a - R * R) + std::sqrt(b * b - R * R);
  double const arc = std::acos(-1.0) - std::acos(R / a) - std::acos(R / b);
  CHECK(plain.time({b, 0, 0}) == Approx(t + R * arc).epsilon(1e-14));
  // between the way along the ray through the centre, and around the square about the sphere
  CHECK(plain.time({b, 0, 0}) > a + b);
  CHECK(plain.time({b, 0, 0}) < std::hypot(a - R, R) + 2 * R + std::hypot(b - R, R));
}
