/// A clamped beam: published first frequency, the limit of a thin one, its mode.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/clamped_beam.hpp"

using namespace g27;

namespace {

ClampedBeam beam(double slenderness) {
  return {.thickness = 0.2, .length = 0.2 * slenderness, .density = 3, .young = 7, .poisson = 0.3};
}

}  // namespace

TEST_CASE("first frequency of a clamped beam", "[oracle]") {
  // 1.87510 (Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1)
  ClampedBeam const b = beam(20);
  double const per_width = 7 / (1 - 0.09) * std::pow(0.2, 3) / 12;
  CHECK(b.thin() == Approx(std::pow(1.87510, 2) * std::sqrt(per_width / (3 * 0.2 * std::pow(4, 4)))).epsilon(1e-5));
  // shear and rotary inertia lower it by a part that goes with the square of thickness over length
  double const coarse = 1 - beam(20).thick() / beam(20).thin(), fine = 1 - beam(40).thick() / beam(40).thin();
  CHECK(fine > 0);
  CHECK(coarse / fine == Approx(4).epsilon(0.02));
}

TEST_CASE("first mode of a clamped beam", "[oracle]") {
  ClampedBeam const b = beam(10);
  CHECK(b.mode(0).value == 0);
  CHECK(b.mode(0).slope == 0);
  CHECK(b.mode(2).value == Approx(1).epsilon(1e-12));
  double const d = 1e-6;
  CHECK(b.mode(1.3).slope == Approx((b.mode(1.3 + d).value - b.mode(1.3 - d).value) / (2 * d)).epsilon(1e-8));
  // no moment at the free end
  CHECK(std::fabs(b.mode(2).slope - b.mode(2 - d).slope) / d < 1e-5);
}
