/// Free vibrations: published frequencies, the equations of elasticity, free surfaces.
#include "tests/catch.hpp"
#include "verification/exact/free_vibration.hpp"

using namespace g27;

namespace {

ElasticSolid const quarter{.rho = 1, .lambda = 1, .mu = 1};  // Poisson's ratio 1/4
ElasticSolid const steel{};

}  // namespace

TEST_CASE("frequencies of spheres and bars", "[oracle]") {
  // Love, 4th ed., section 196: k_L a/pi of the radial vibrations for Poisson's ratio 1/4
  double const radial[] = {.8160, 1.9285, 2.9539, 3.9658, 4.9728, 5.9774};
  for (int m = 1; m <= 6; ++m) {
    FreeVibration const wave(FreeBody::sphere, quarter, 1, 0, m);
    CHECK(wave.frequency() / quarter.longitudinal_speed() / M_PI == Approx(radial[m - 1]).margin(6e-5));
  }
  // torsional vibrations of order 1 and 2 have tan x/x = 3/(3 - x^2) and (x^2 - 12)/(5 x^2 - 12)
  for (int m = 1; m <= 5; ++m) {
    double const x = FreeVibration(FreeBody::sphere, quarter, 1, 1, m).wave_number();
    double const y = FreeVibration(FreeBody::sphere, quarter, 1, 2, m).wave_number();
    CHECK(std::tan(x) / x == Approx(3 / (3 - x * x)).epsilon(1e-11));
    CHECK(std::tan(y) / y == Approx((y * y - 12) / (5 * y * y - 12)).epsilon(1e-11));
  }
  CHECK(FreeVibration(FreeBody::sphere, quarter, 1, 1, 1).wave_number() == Approx(5.763).margin(6e-4));
  CHECK(FreeVibration(FreeBody::sphere, quarter, 1, 2, 1).wave_number() == Approx(2.501).margin(6e-4));
  FreeVibration const bar(FreeBody::bar, steel, 0.7, 0, 3);
  CHECK(bar.frequency() == Approx(3 * M_PI * steel.longitudinal_speed() / 0.7).epsilon(1e-14));
}

TEST_CASE("surfaces are free and frequencies are Rayleigh's quotients", "[oracle]") {
  for (ElasticSolid const& solid : {quarter, steel, ElasticSolid{.rho = 2.7, .lambda = -0.2, .mu = 1.1}}) {
    for (FreeBody const body : {FreeBody::bar, FreeBody::disc, FreeBody::sphere}) {
      for (int order = 0; order <= (body == FreeBody::bar ? 0 : 3); ++order) {
        for (int const mode : {1, 3}) {
          FreeVibration const wave(body, solid, 1.3, order, mode, 2);
          INFO("body " << static_cast<int>(body) << " order " << order << " mode " << mode);
          CHECK(wave.residual() < 1e-12);      // Bessel functions and a root to a few bits
          CHECK(wave.rayleigh_gap() < 1e-10);  // quadrature
        }
      }
    }
  }
}

TEST_CASE("frequencies grow with the mode and scale with size and speed of sound", "[oracle]") {
  for (int order = 0; order <= 3; ++order) {
    double last = 0;
    for (int mode = 1; mode <= 5; ++mode) {
      double const w = FreeVibration(FreeBody::disc, steel, 1, order, mode).frequency();
      CHECK(w > last);
      last = w;
    }
    CHECK(FreeVibration(FreeBody::disc, steel, 2, order, 5).frequency() == Approx(last / 2).epsilon(1e-13));
    ElasticSolid stiff = steel;
    stiff.lambda *= 9, stiff.mu *= 9;
    CHECK(FreeVibration(FreeBody::disc, stiff, 1, order, 5).frequency() == Approx(3 * last).epsilon(1e-13));
  }
}

TEST_CASE("standing waves satisfy the equations of linear elasticity", "[oracle]") {
  ElasticSolid const solid{.rho = 1.4, .lambda = 1.9, .mu = 0.8};
  for (FreeBody const body : {FreeBody::bar, FreeBody::disc, FreeBody::sphere}) {
    for (int order = 0; order <= (body == FreeBody::bar ? 0 : 4); ++order) {
      FreeVibration const wave(body, solid, 1.2, order, 2, 1);
      INFO("body " << static_cast<int>(body) << " order " << order);
      double const t = 0.4 / wave.frequency(), h = 2e-3;
      for (Vector3 const& x : {Vector3{0.5, 0.3, -0.4}, Vector3{0, 0, 0}, Vector3{-0.2, 0.9, 0.1}}) {
        SolidPoint const s = wave.at(x, t);
        auto d = [&](auto field, std::size_t axis) {
          auto f = [&](double step) {
            Vector3 y = x;
            if (axis < 3) y[axis] += step;
            return field(y, axis < 3 ? t : t + step);
          };
          // sixth order
          return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
        };
        double strain[3][3];
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            strain[i][j] = d([&](Vector3 const& y, double when) { return wave.displacement(y, when)[i]; }, j);
        double const volume = strain[0][0] + strain[1][1] + strain[2][2];
        // differences of sixth order: h^6 (k a)^7/140, round-off over h
        double const tolerance = 2e-10;
        for (std::size_t i = 0; i < 3; ++i) {
          double force = 0;
          for (std::size_t j = 0; j < 3; ++j) {
            double const stress = (i == j ? solid.lambda * volume : 0) + solid.mu * (strain[i][j] + strain[j][i]);
            CHECK(std::fabs(s.stress(i, j) - stress) < tolerance);
            force += d([&](Vector3 const& y, double when) { return wave.at(y, when).stress(i, j); }, j);
          }
          double const speed = d([&](Vector3 const& y, double when) { return wave.displacement(y, when)[i]; }, 3);
          double const acceleration = d([&](Vector3 const& y, double when) { return wave.at(y, when).u[i]; }, 3);
          CHECK(std::fabs(speed - s.u[i]) < tolerance);
          CHECK(std::fabs(solid.rho * acceleration - force) < 20 * tolerance);  // of order w^2 ~ 20
        }
        CHECK(s.rho == Approx(solid.rho * (1 - volume)).epsilon(1e-9));
        CHECK(std::fabs(s.S[0] + s.S[1] + s.S[2]) < 1e-14);
      }
    }
  }
}

TEST_CASE("the fastest place on the surface has the velocity asked for", "[oracle]") {
  for (int order = 0; order <= 3; ++order) {
    FreeVibration const wave(FreeBody::disc, steel, 0.5, order, 1, 7);
    double fastest = 0;
    for (int i = 0; i < 360; ++i) {
      double const a = M_PI * i / 180;
      Vector3 const u = wave.at({0.5 * std::cos(a), 0.5 * std::sin(a), 0}, 0).u;
      fastest = std::max(fastest, std::hypot(u[0], u[1]));
    }
    CHECK(fastest == Approx(7).epsilon(1e-4));  // sampled every degree
  }
}

TEST_CASE("inadmissible vibrations are refused", "[oracle]") {
  CHECK_THROWS(FreeVibration(FreeBody::bar, steel, 1, 1, 1));
  CHECK_THROWS(FreeVibration(FreeBody::disc, steel, 1, 0, 0));
  CHECK_THROWS(FreeVibration(FreeBody::disc, ElasticSolid{.rho = 1, .lambda = -1, .mu = 1}, 1, 0, 1));
}
