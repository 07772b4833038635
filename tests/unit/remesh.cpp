/// Remeshing keeps the body and its sharp edges and brings the edges to the length asked for.
#include "fsi/surface/remesh.hpp"

#include <algorithm>
#include <numbers>

#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/shapes.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

struct Remeshed {
  Diagnosis diagnosis;
  double volume_change;
  double within;  ///< share of the edges within 0.7 to 1.4 of the length
};

Remeshed remeshed(TriangleSurface const& before, double edge) {
  TriangleSurface const after = remesh(before, {.edge = edge});
  auto const lengths = edge_lengths(after);
  auto const fit =
      std::count_if(lengths.begin(), lengths.end(), [&](double l) { return l > 0.7 * edge && l < 1.4 * edge; });
  return {diagnose(after), mass_properties(after).volume / mass_properties(before).volume - 1,
          static_cast<double>(fit) / static_cast<double>(lengths.size())};
}

}  // namespace

TEST_CASE("flat sides and sharp edges stay", "[surface]") {
  for (double const before : {0.05, 0.4, 3.0}) {  // coarser, finer, from a few triangles
    for (auto const& [body, angle] : {std::pair{make_box({1, 0.7, 1}, before), std::numbers::pi / 2},
                                      std::pair{make_tetrahedron(1, before), std::acos(1.0 / 3)}}) {
      Remeshed const r = remeshed(body, 0.1);
      CAPTURE(before, body.size());
      CHECK(r.diagnosis.healthy());
      CHECK(std::fabs(r.volume_change) < 1e-11);  // vertices move in planes
      CHECK(r.diagnosis.angles.smallest == Approx(angle).epsilon(1e-6));
      CHECK(r.within > 0.9);
      CHECK(r.diagnosis.edges.largest < 0.2);  // twice the length: what the method works with
    }
  }
}

TEST_CASE("edges that are far too short are refused", "[surface]") {
  CHECK_THROWS_AS(remesh(make_box({1, 1, 1}, 0.5), {.edge = 1e-6}), SurfaceError);
}

TEST_CASE("curved sides lose no more than their chords", "[surface]") {
  // a chord of length l stays l^2/(8 R) within: 3 l^2/(8 R^2) of a ball's volume, less for triangles
  for (double const before : {0.05, 0.1}) {
    Remeshed const ball = remeshed(make_sphere(0.5, before), 0.1);
    CHECK(ball.diagnosis.healthy());
    CHECK(ball.volume_change < 0);
    CHECK(ball.volume_change > -3 * 0.01 / (8 * 0.25));
    CHECK(ball.within > 0.9);
    Remeshed const can = remeshed(make_cylinder(0.5, 1, before), 0.1);
    CHECK(can.diagnosis.healthy());
    CHECK(std::fabs(can.volume_change) < 3 * 0.01 / (8 * 0.25));
    CHECK(can.within > 0.9);
  }
}
