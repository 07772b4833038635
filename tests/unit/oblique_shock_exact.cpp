/// Oblique shocks against the tables of NACA Report 1135, and against the jump conditions.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/oblique_shock.hpp"

using namespace g27;

namespace {
double const degree = M_PI / 180;
}

TEST_CASE("oblique shocks agree with published charts", "[oracle]") {
  // Anderson, Modern Compressible Flow, 3rd ed., example 4.1 reads theta-beta-M charts; normal shocks from table A.2
  NormalShock const n = normal_shock(1.4, 2);
  CHECK(n.pressure_ratio == Approx(4.5).epsilon(1e-14));
  CHECK(n.density_ratio == Approx(8.0 / 3).epsilon(1e-14));
  CHECK(n.mach_behind == Approx(0.5774).epsilon(1e-4));
  ObliqueShock const s = oblique_shock(1.4, 3, 20 * degree);
  CHECK(s.angle / degree == Approx(37.76).epsilon(2e-4));
  CHECK(s.pressure_ratio == Approx(3.771).epsilon(5e-4));
  CHECK(s.mach_behind == Approx(1.994).epsilon(5e-4));
  // NACA 1135, chart 2 and the largest deflection of Mach 2: 22.97 degrees at 64.67 degrees
  double const detached = detachment_angle(1.4, 2);
  CHECK(detached / degree == Approx(64.67).epsilon(2e-4));
  CHECK(shock_deflection(1.4, 2, detached) / degree == Approx(22.97).epsilon(3e-4));
}

TEST_CASE("oblique shocks conserve mass, momentum along and across, and enthalpy", "[oracle]") {
  for (double const gamma : {1.2, 1.4, 5.0 / 3}) {
    for (double const mach : {1.6, 3.0, 8.0}) {
      for (ShockBranch const branch : {ShockBranch::weak, ShockBranch::strong}) {
        double const deflection = 7 * degree;
        ObliqueShock const s = oblique_shock(gamma, mach, deflection, branch);
        INFO("gamma " << gamma << " Mach " << mach << " shock at " << s.angle / degree);
        double const rho1 = 1.3, p1 = 0.7, c1 = std::sqrt(gamma * p1 / rho1), w1 = mach * c1;
        double const rho2 = rho1 * s.density_ratio, p2 = p1 * s.pressure_ratio;
        double const w2 = s.mach_behind * std::sqrt(gamma * p2 / rho2);
        double const n1 = w1 * std::sin(s.angle), n2 = w2 * std::sin(s.angle - deflection);
        double const a1 = w1 * std::cos(s.angle), a2 = w2 * std::cos(s.angle - deflection);
        CHECK(rho2 * n2 == Approx(rho1 * n1).epsilon(1e-12));
        CHECK(p2 + rho2 * n2 * n2 == Approx(p1 + rho1 * n1 * n1).epsilon(1e-12));
        CHECK(a2 == Approx(a1).epsilon(1e-11));
        double const h1 = gamma / (gamma - 1) * p1 / rho1, h2 = gamma / (gamma - 1) * p2 / rho2;
        CHECK(h2 + w2 * w2 / 2 == Approx(h1 + w1 * w1 / 2).epsilon(1e-12));
        CHECK(p2 > p1);
        CHECK((branch == ShockBranch::weak) == (s.angle < detachment_angle(gamma, mach)));
      }
    }
  }
}

TEST_CASE("the largest deflection is the largest", "[oracle]") {
  for (double const mach : {1.3, 2.7, 12.0}) {
    double const at = detachment_angle(1.4, mach), most = shock_deflection(1.4, mach, at);
    CHECK(shock_deflection(1.4, mach, at - 0.01) < most);
    CHECK(shock_deflection(1.4, mach, at + 0.01) < most);
    CHECK_THROWS_AS(oblique_shock(1.4, mach, 1.001 * most), NumericsError);
  }
  CHECK_THROWS_AS(oblique_shock(1.4, 0.9, 0.1), NumericsError);
}
