/// Reflection and transmission at a bonded face against closed forms, continuity and the linear equations.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/bonded_wave.hpp"

using namespace g27;

namespace {

// mm, us, g/cm^3, GPa
SolidMaterial const steel{LinearBulkLaw{175, 7.8}, 80.77};
SolidMaterial const aluminium{MieGruneisenLaw{2.785, 5.328, 1.338, 2}, 27.6};

double pulse(double x) { return 1e-6 * std::exp(-8 * (x + 1.5) * (x + 1.5)); }

SolidPoint state(SolidMaterial const& m, double rho, double p, Tensor6 const& S) {
  SolidPoint s{.rho = rho, .u = {0.2, -0.1, 0.05}, .p = p, .S = S};
  if (std::holds_alternative<LinearBulkLaw>(m.law)) s.p = pressure(m.law, rho, 0);
  s.e = energy(m.law, rho, s.p);
  return s;
}

/// Of one traction across x: s11 = S11 - p.
std::pair<SolidPoint, SolidPoint> stressed() {
  SolidPoint const l = state(steel, 8.0, 0, {5, -4, -1, 3, 2, 1.5});
  double const S11 = 2;
  return {l, state(aluminium, 2.9, S11 - l.stress(0, 0), {S11, -3, 1, 3, 2, -1})};
}

}  // namespace

TEST_CASE("without pre-stress the coefficients are those of the impedances", "[oracle]") {
  SolidPoint const l = state(steel, 7.8, 0, {}), r = state(aluminium, 2.785, 0, {});
  for (std::size_t family : {0, 1, 2}) {
    BondedWave const wave(steel, l, aluminium, r, family, pulse);
    double const z_l = 7.8 * wave.left_families().speeds()[family];
    double const z_r = 2.785 * wave.right_families().speeds()[family];
    // the velocity along the incoming vector; S waves of equal speed share a plane
    Vector3 reflected{}, transmitted{};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        reflected[i] += wave.reflected()[j] * wave.left_families().vectors()[j][i];
        transmitted[i] += wave.transmitted()[j] * wave.right_families().vectors()[j][i];
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      double const along = wave.left_families().vectors()[family][i];
      CHECK(reflected[i] == Approx((z_l - z_r) / (z_l + z_r) * along).margin(1e-13));
      CHECK(transmitted[i] == Approx(2 * z_l / (z_l + z_r) * along).margin(1e-13));
    }
  }
}

TEST_CASE("nothing is reflected inside one material", "[oracle]") {
  SolidPoint const base = stressed().first;
  for (std::size_t family : {0, 1, 2}) {
    BondedWave const wave(steel, base, steel, base, family, pulse);
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(wave.reflected()[j] == Approx(0).margin(1e-13));
      CHECK(wave.transmitted()[j] == Approx(j == family ? 1 : 0).margin(1e-13));
    }
  }
}

TEST_CASE("velocity and traction are continuous, and both sides obey the equations", "[oracle]") {
  auto const [l, r] = stressed();
  for (std::size_t family : {0, 1, 2}) {
    BondedWave const wave(steel, l, aluminium, r, family, pulse);
    // P waves move material along x alone, S waves in a stressed solid not across x alone
    CHECK((std::fabs(wave.reflected()[0]) > 1e-4) == true);
    CHECK((std::fabs(wave.reflected()[1]) > 1e-4) == (family > 0));
    double const c = wave.left_families().speeds()[family];
    for (double t : {1.3 / c, 1.5 / c, 1.8 / c}) {
      SolidPoint const a = wave.left(0, t), b = wave.right(0, t);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(a.u[i] == Approx(b.u[i]).margin(1e-15));
        CHECK(a.stress(0, i) == Approx(b.stress(0, i)).margin(1e-13));  // of 9 GPa
      }
    }
    double const t = 1.7 / c, d = 1e-4;
    for (bool low : {true, false}) {
      SolidPoint const& base = low ? l : r;
      SolidMaterial const& m = low ? steel : aluminium;
      auto const at = [&](double x, double time) { return low ? wave.left(x, time) : wave.right(x, time); };
      double const x = low ? -0.2 : 0.15;
      SolidPoint const xp = at(x + d, t), xm = at(x - d, t), tp = at(x, t + d), tm = at(x, t - d);
      double L[3][3]{};
      for (std::size_t i = 0; i < 3; ++i) L[i][0] = (xp.u[i] - xm.u[i]) / (2 * d);
      SolidPoint const rate = elastic_rate(m, base, L);
      // differences of second order, and the round-off of 9 GPa over d: 1e-7 of rates of 1e-4
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(base.rho * (tp.u[i] - tm.u[i]) == Approx(xp.stress(0, i) - xm.stress(0, i)).margin(3e-14));
      }
      for (std::size_t k = 0; k < 6; ++k) CHECK((tp.S[k] - tm.S[k]) / (2 * d) == Approx(rate.S[k]).margin(1e-9));
      CHECK((tp.p - tm.p) / (2 * d) == Approx(rate.p).margin(1e-9));
    }
  }
}

TEST_CASE("base states that do not fit are refused", "[oracle]") {
  auto [l, r] = stressed();
  r.u[1] += 1e-3;
  CHECK_THROWS(BondedWave(steel, l, aluminium, r, 0, pulse));
  r.u[1] -= 1e-3, r.p += 1e-3;
  CHECK_THROWS(BondedWave(steel, l, aluminium, r, 0, pulse));
}
