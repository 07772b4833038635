/// The superseismic shock against published angles, the equations of both media, and its limits.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/superseismic.hpp"

using namespace g27;

namespace {

SuperseismicSetup const published{.gamma = 1.4,
                                  .gas_density = .1114827,
                                  .gas_pressure = .1114827 * .09375,
                                  .solid_density = 1,
                                  .lambda = .1398307,
                                  .mu = .07203351,
                                  .speed = 1};

SuperseismicSetup with(SuperseismicSetup s, StressNormal normal) {
  s.normal = normal;
  return s;
}

}  // namespace

TEST_CASE("superseismic shock: published angles, for both normals", "[oracle]") {
  // eight decimals are printed
  Superseismic const undeformed(with(published, StressNormal::undeformed));
  CHECK(undeformed.shock_angle() == Approx(.06047046).margin(2e-8));
  CHECK(undeformed.interface_angle() == Approx(.15513736).margin(2e-8));
  Superseismic const deformed(with(published, StressNormal::deformed));
  CHECK(deformed.shock_angle() == Approx(.05882441).margin(2e-8));
  CHECK(deformed.interface_angle() == Approx(.15109012).margin(2e-8));
}

TEST_CASE("superseismic shock: the gas keeps mass, momentum and enthalpy across its shock", "[oracle]") {
  SuperseismicSetup const& s = published;
  Superseismic const w(s);
  // in the frame of the foot, along the normal into the gas ahead and along the front
  double const c = std::cos(w.shock_angle()), d = std::sin(w.shock_angle());
  double const x = w.gas_behind().u[0] - s.speed, y = w.gas_behind().u[1];
  double const u1 = -s.speed * c, u2 = x * c - y * d, t1 = -s.speed * d, t2 = x * d + y * c;
  double const rho = w.gas_behind().rho, p = w.gas_behind().p, h = s.gamma / (s.gamma - 1);
  CHECK(rho * u2 == Approx(s.gas_density * u1).epsilon(1e-13));
  CHECK(p + rho * u2 * u2 == Approx(s.gas_pressure + s.gas_density * u1 * u1).epsilon(1e-13));
  CHECK(h * p / rho + u2 * u2 / 2 == Approx(h * s.gas_pressure / s.gas_density + u1 * u1 / 2).epsilon(1e-13));
  CHECK(t1 == Approx(t2).epsilon(1e-13));
  // it leaves along the surface
  CHECK(std::atan2(-y, -x) == Approx(w.interface_angle()).epsilon(1e-12));
}

TEST_CASE("superseismic shock: fronts in the solid keep momentum, and nothing tears", "[oracle]") {
  SuperseismicSetup const& s = published;
  for (StressNormal normal : {StressNormal::undeformed, StressNormal::deformed}) {
    Superseismic const w(with(s, normal));
    CHECK(w.residual() < 1e-12);
    Superseismic::Solid const rest{};
    struct Front {
      double angle, c;
      Superseismic::Solid const &ahead, &behind;
    };
    double const c_p = std::sqrt(s.lambda + 2 * s.mu), c_s = std::sqrt(s.mu);
    for (Front const& f :
         {Front{w.p_wave_angle(), c_p, rest, w.behind_p()}, {w.s_wave_angle(), c_s, w.behind_p(), w.behind_s()}}) {
      double const n[2] = {std::sin(f.angle), -std::cos(f.angle)};
      CHECK(n[0] == Approx(f.c / s.speed).epsilon(1e-14));
      for (std::size_t i = 0; i < 2; ++i) {
        double const du = f.behind.u[i] - f.ahead.u[i];
        double ds = 0, along = 0;
        for (std::size_t j = 0; j < 2; ++j) {
          ds += (f.behind.stress[i][j] - f.ahead.stress[i][j]) * n[j];
          // the displacement is continuous: its gradient jumps across the front alone
          along += (f.behind.grad[i][j] - f.ahead.grad[i][j]) * (j == 0 ? -n[1] : n[0]);
        }
        CHECK(-f.c * s.solid_density * du == Approx(ds).margin(1e-14));  // of stresses of 0.1
        CHECK(along == Approx(0).margin(1e-15));
      }
    }
  }
}

TEST_CASE("superseismic shock: regions seen from the foot", "[oracle]") {
  Superseismic const w(published);
  CHECK(w.in_gas(1, 0.01));
  CHECK(!w.in_gas(1, -0.01));
  CHECK(w.in_gas(-1, -0.14));
  CHECK(!w.in_gas(-1, -0.16));
  CHECK(w.gas(0.05, 1).p == w.gas_behind().p);  // the shock leans forward by .0588
  CHECK(w.gas(0.07, 1).p == published.gas_pressure);
  CHECK(w.solid(0.5, -1).u[1] == 0);
  CHECK(w.solid(-2, -1).u[1] == w.behind_p().u[1]);
  CHECK(w.solid(-4, -1).u[1] == w.behind_s().u[1]);
  CHECK(w.behind_s().u[1] < 0);
}

TEST_CASE("superseismic shock: a stiff solid is a wall, and both normals agree on it", "[oracle]") {
  SuperseismicSetup stiff = published;
  // as fast waves in a denser solid
  double const by = 1e4;
  stiff.solid_density *= by, stiff.lambda *= by, stiff.mu *= by;
  Superseismic const a(with(stiff, StressNormal::undeformed)), b(with(stiff, StressNormal::deformed));
  CHECK(a.interface_angle() < 2e-5);
  CHECK(a.interface_angle() == Approx(b.interface_angle()).epsilon(1e-4));  // to the angle itself
  // the normal shock
  double const M2 = published.speed * published.speed / (1.4 * .09375);
  CHECK(a.gas_behind().p / stiff.gas_pressure == Approx(1 + 2.8 / 2.4 * (M2 - 1)).epsilon(1e-9));
  // doubling the load doubles the angle: linear elasticity
  SuperseismicSetup twice = stiff;
  twice.gas_density *= 2, twice.gas_pressure *= 2;
  CHECK(Superseismic(twice).interface_angle() == Approx(2 * b.interface_angle()).epsilon(1e-4));
}

TEST_CASE("superseismic shock: what has no solution is refused", "[oracle]") {
  SuperseismicSetup slow = published, subsonic = published, soft = published;
  slow.speed = 0.5;
  CHECK_THROWS_AS(Superseismic(slow), NumericsError);
  subsonic.gas_pressure *= 20;
  CHECK_THROWS_AS(Superseismic(subsonic), NumericsError);
  soft.solid_density /= 10, soft.lambda /= 10, soft.mu /= 10;
  CHECK_THROWS_AS(Superseismic(soft), NumericsError);
}
