// The gas-driven piston: closed form against a vacuum, and the equation of motion.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/rigid_piston.hpp"

using namespace g27;

TEST_CASE("a piston that gas drives into a vacuum follows the closed form") {
  double const g = 1.4, rho = 1.4, p = 1, c = 1;
  for (double mass : {0.1, 1.0, 30.0}) {
    RigidPiston const piston({.behind = {g, rho, p}, .ahead = {.p = 0}, .mass_per_area = mass, .t_end = 3});
    for (double t : {0.0, 0.1, 0.77, 3.0}) {
      double const tau = (g + 1) * p * t / (2 * c * mass);
      double const v = 2 * c / (g - 1) * (1 - std::pow(1 + tau, -(g - 1) / (g + 1)));
      // the integrator's tolerance, 1e-13 a step
      CHECK(piston.velocity(t) == Approx(v).epsilon(1e-10).margin(1e-13));
    }
    CHECK(std::isinf(piston.breaking_time()));
  }
}

TEST_CASE("between two gases momentum is the impulse of both pressures, and equal ratios meet at one velocity") {
  RigidPiston const piston({.behind = {1.4, 1.4, 1}, .ahead = {1.4, 0.7, 0.5}, .mass_per_area = 0.5, .t_end = 2});
  double const impulse =
      integrate([&](double t) { return piston.pressure_behind(t) - piston.pressure_ahead(t); }, 0, 1.3, 1e-9);
  CHECK(0.5 * piston.velocity(1.3) == Approx(impulse).epsilon(1e-8));
  CHECK(integrate([&](double t) { return piston.velocity(t); }, 0, 1.3, 1e-9) ==
        Approx(piston.position(1.3)).epsilon(1e-8));
  // a_0 = .5/.5, so that the front breaks after 2 c/(2.4 a_0)
  CHECK(piston.breaking_time() == Approx(2 / 2.4).epsilon(1e-12));
  // the gas beside it is that at it, farther away still at rest, and satisfies its equations between
  double const t = 0.6, x = piston.position(t), d = 1e-4;
  CHECK(piston.behind(x, t).p == Approx(piston.pressure_behind(t)).epsilon(1e-11));
  CHECK(piston.ahead(x, t).p == Approx(piston.pressure_ahead(t)).epsilon(1e-11));
  CHECK(piston.behind(-0.601, t).u == 0);
  CHECK(piston.ahead(0.601, t).p == 0.5);
  for (double side : {-1.0, 1.0}) {
    auto const gas = [&](double at, double when) {
      return side < 0 ? piston.behind(at, when) : piston.ahead(at, when);
    };
    double const y = x + 0.2 * side;
    auto const slope = [&](auto const& f) { return (f(gas(y + d, t)) - f(gas(y - d, t))) / (2 * d); };
    auto const rate = [&](auto const& f) { return (f(gas(y, t + d)) - f(gas(y, t - d))) / (2 * d); };
    auto const mass = [](GasState<> const& s) { return s.rho; };
    auto const momentum = [](GasState<> const& s) { return s.rho * s.u; };
    auto const push = [](GasState<> const& s) { return s.rho * s.u * s.u + s.p; };
    CHECK(std::fabs(slope(mass)) > 0.01);
    CHECK(std::fabs(rate(mass) + slope(momentum)) < 1e-6);  // d^2 times third derivatives
    CHECK(std::fabs(rate(momentum) + slope(push)) < 1e-6);
  }
  CHECK_THROWS_AS(RigidPiston({.behind = {1.4, 1, 1}, .ahead = {1.4, 1, 1}}), NumericsError);
}
