/// Blake's problem against ExactPack's table and the equations of elasticity.
#include "tests/catch.hpp"
#include "tests/reference_table.hpp"
#include "verification/exact/blake.hpp"

using namespace g27;

TEST_CASE("Blake's problem: ExactPack's table", "[oracle]") {
  Blake const blake;
  double const t = 160e-6;
  CHECK(blake.at(.1, t).displacement == Approx(1.0017698e-6).epsilon(1e-7));
  CHECK(blake.at(.7, t).displacement == Approx(6.909425e-8).epsilon(1e-7));
  auto const table = read_reference("blake_default.csv");
  auto const r = table.column("position"), u = table.column("displacement"), e_rr = table.column("strain_rr"),
             e_tt = table.column("strain_qq"), s_rr = table.column("stress_rr"), s_tt = table.column("stress_qq"),
             p = table.column("pressure");
  REQUIRE(r.size() > 400);
  int inside = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (std::fabs(r[i] - blake.front(t)) < 1e-12) continue;  // on the front itself either side is right
    inside += r[i] < blake.front(t) ? 1 : 0;
    Blake::Point const s = blake.at(r[i], t);
    INFO("r " << r[i]);
    // ten digits are printed; strains and stresses are sums that cancel
    CHECK(s.displacement == Approx(u[i]).epsilon(1e-9).margin(1e-17));
    CHECK(s.strain_rr == Approx(e_rr[i]).epsilon(1e-9).margin(1e-15));
    CHECK(s.strain_tt == Approx(e_tt[i]).epsilon(1e-9).margin(1e-16));
    CHECK(s.stress_rr == Approx(s_rr[i]).epsilon(1e-9).margin(1e-4));
    CHECK(s.stress_tt == Approx(s_tt[i]).epsilon(1e-9).margin(1e-4));
    CHECK(-(s.stress_rr + 2 * s.stress_tt) / 3 == Approx(p[i]).epsilon(1e-9).margin(1e-4));
  }
  CHECK(inside > 350);
}

TEST_CASE("Blake's solution satisfies the equations of motion and the traction on the wall", "[oracle]") {
  Blake const blake{.lambda = 3, .mu = 0.8, .rho = 1.7, .radius = 0.6, .pressure = 0.9};
  for (double const t : {0.3, 1.7, 4.0}) {
    CHECK(blake.at(blake.radius, t).stress_rr == Approx(-blake.pressure).epsilon(1e-12));
    for (double const fraction : {0.2, 0.6, 0.9}) {
      double const r = blake.radius + fraction * (blake.front(t) - blake.radius), h = 1e-3;
      auto d = [&](auto field, double er, double et) {
        auto f = [&](double s) { return field(blake.at(r + s * er, t + s * et)); };
        return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
      };
      auto u = [](Blake::Point const& s) { return s.displacement; };
      auto v = [](Blake::Point const& s) { return s.velocity; };
      auto srr = [](Blake::Point const& s) { return s.stress_rr; };
      Blake::Point const s = blake.at(r, t);
      // fourth-order differences of fields of order one over lengths and times of order one
      double const tolerance = 1e-9;
      CHECK(std::fabs(d(u, 0, 1) - s.velocity) < tolerance);
      CHECK(std::fabs(d(u, 1, 0) - s.strain_rr) < tolerance);
      CHECK(std::fabs(blake.rho * d(v, 0, 1) - d(srr, 1, 0) - 2 * (s.stress_rr - s.stress_tt) / r) < tolerance);
    }
    // the front carries rho c [v] = -[s_rr]
    Blake::Point const front = blake.at(blake.front(t) * (1 - 1e-12), t);
    CHECK(front.stress_rr == Approx(-blake.rho * blake.sound_speed() * front.velocity).epsilon(1e-10));
    CHECK(front.stress_rr == Approx(-blake.pressure * blake.radius / blake.front(t)).epsilon(1e-10));
    CHECK(blake.at(blake.front(t) * (1 + 1e-12), t).velocity == 0);
  }
  // at rest in the end, displaced by P a/(4 mu)
  CHECK(blake.at(blake.radius, 300).displacement == Approx(blake.static_displacement()).epsilon(1e-12));
  CHECK(blake.at(2 * blake.radius, 300).displacement == Approx(blake.static_displacement() / 4).epsilon(1e-12));
}
