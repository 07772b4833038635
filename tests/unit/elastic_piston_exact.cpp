/// Gas and elastic solid in smooth motion: both sides obey their equations and agree at the contact.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/elastic_piston.hpp"
#include "verification/exact/numerics.hpp"

using namespace g27;

namespace {

/// Fourth-order central difference.
template <class F>
double slope(F const& f, double x, double h) {
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

ElasticPistonSetup const setups[] = {{},
                                     {.eos = StiffenedLaw{4.4, 1},
                                      .gas = {1.2, 0, 0.3},
                                      .law = {.K = 9, .rho0 = 3},
                                      .mu = 2,
                                      .velocity = 0.05,
                                      .period = 1.3,
                                      .depth = 0.6}};

}  // namespace

TEST_CASE("both sides agree at the contact", "[oracle]") {
  for (auto const& setup : setups) {
    ElasticPiston const exact(setup);
    CHECK(exact.truncation() < 1e-10);
    for (double const t : {0.0, 0.2, 0.777}) {
      double const x = exact.position(t);
      CHECK(slope([&](double s) { return exact.position(s); }, t, 1e-3) == Approx(exact.velocity(t)).margin(1e-11));
      GasState<> const g = exact.gas(t).at(x);
      SolidPoint const s = exact.solid(x, t);
      CHECK(g.u == Approx(exact.velocity(t)).margin(1e-12));
      CHECK(s.u[0] == Approx(exact.velocity(t)).margin(1e-12));
      CHECK(g.p == Approx(exact.pressure(t)).epsilon(1e-11));
      CHECK(-s.stress(0, 0) == Approx(exact.pressure(t)).epsilon(1e-11));
    }
    CHECK(exact.pressure(0) == Approx(setup.gas.p).epsilon(1e-11));
    CHECK(exact.gas(0).at(0).rho == Approx(setup.gas.rho).epsilon(1e-11));
  }
}

TEST_CASE("mass and momentum hold on both sides, isentropic in the gas", "[oracle]") {
  double const h = 2e-3;
  for (auto const& setup : setups) {
    ElasticPiston const exact(setup);
    Isentrope const isentrope(setup.eos, setup.gas.rho, setup.gas.p);
    double const rate = 2 * 3.14159265 * setup.velocity / setup.period;  // what the terms are of the size of
    for (double const t : {0.1, 0.6}) {
      for (double const x : {-0.4, -0.1}) {
        auto const in_t = [&](auto f) { return slope([&](double s) { return f(exact.gas(s).at(x)); }, t, h); };
        auto const now = exact.gas(t);
        auto const in_x = [&](auto f) { return slope([&](double s) { return f(now.at(s)); }, x, h); };
        GasState<> const g = now.at(x);
        CHECK(std::fabs(in_t([](auto q) { return q.rho; }) + in_x([](auto q) { return q.rho * q.u; })) < 1e-6 * rate);
        CHECK(std::fabs(in_t([](auto q) { return q.u; }) + g.u * in_x([](auto q) { return q.u; }) +
                        in_x([](auto q) { return q.p; }) / g.rho) < 1e-6 * rate);
        CHECK(g.p == Approx(isentrope.pressure(g.rho)).epsilon(1e-12));
      }
      for (double const x : {0.1, 0.4}) {
        auto const in_t = [&](auto f) { return slope([&](double s) { return f(exact.solid(x, s)); }, t, h); };
        auto const in_x = [&](auto f) { return slope([&](double s) { return f(exact.solid(s, t)); }, x, h); };
        SolidPoint const s = exact.solid(x, t);
        double const stretch = in_x([](auto q) { return q.u[0]; });
        auto const along = [&](auto f) { return in_t(f) + s.u[0] * in_x(f); };
        CHECK(std::fabs(along([](auto q) { return q.rho; }) + s.rho * stretch) < 1e-5 * rate);
        CHECK(std::fabs(along([](auto q) { return q.u[0]; }) - in_x([](auto q) { return q.stress(0, 0); }) / s.rho) <
              1e-5 * rate);
        CHECK(std::fabs(along([](auto q) { return q.S[0]; }) - 4.0 / 3 * setup.mu * stretch) < 1e-5 * rate);
        CHECK(s.p == Approx(setup.law.pressure(s.rho, 0.0)).epsilon(1e-14));
        CHECK(exact.particle_velocity(exact.particle(x, t), t) == Approx(s.u[0]).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a wave that breaks is an error", "[oracle]") {
  CHECK_THROWS_AS(ElasticPiston({.velocity = 0.2}), NumericsError);
}
