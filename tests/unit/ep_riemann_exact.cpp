/// Riemann problems of elastoplastic solids: figures of independent programs, the gas limit, symmetry, conservation.
#include "tests/catch.hpp"
#include "verification/exact/elastic_riemann.hpp"
#include "verification/exact/ep_riemann.hpp"
#include "verification/exact/gas_riemann.hpp"

using namespace g27;

namespace {

// mm, us, g/cm^3, GPa
SolidMaterial const steel{LinearBulkLaw{175, 7.8}, 80.77, .34, .24};
SolidMaterial const elastic_steel{LinearBulkLaw{175, 7.8}, 80.77};
SolidMaterial const aluminium{LinearBulkLaw{79.06, 2.785}, 27.6, .3, 0};
SolidMaterial const copper{MieGruneisenLaw{8.93, 3.94, 1.49, 2}, 45, .09, .4};
SolidMaterial const products{JwlLaw{708.6056, 13.16457, 4.94, 1.35, .28, 1.65}};

struct Pair {
  SolidMaterial material_l;
  SolidPoint left;
  SolidMaterial material_r;
  SolidPoint right;
};
std::vector<Pair> const pairs{
    {steel, axial_state(steel, 7.8, .3, 0), aluminium, axial_state(aluminium, 2.785, 0, 0)},
    {copper, axial_state(copper, 8.93, -.1, 0), aluminium, axial_state(aluminium, 2.785, .05, 0)},
    {copper, axial_state(copper, 9.3, .2, 9, -.04, .1), copper, axial_state(copper, 8.93, -.1, 0, .05)},
    {products, axial_state(products, 2.1, -.3, 15), steel, axial_state(steel, 7.8, .1, 0)},
    {steel, axial_state(steel, 7.9, .1, 175 * (7.9 / 7.8 - 1), .1), products, axial_state(products, 1.9, .2, 12)}};

}  // namespace

TEST_CASE("detonation products against steel, and steel against aluminium", "[oracle]") {
  // independent figures: Chapman-Jouguet products of density 2.198643 at 23.70 GPa
  SolidPoint const cj = axial_state(products, 2.198643, 1.893214, 23.70), rest = axial_state(steel, 7.8, 0, 0);
  EpRiemann const plastic(products, cj, steel, rest), elastic(products, cj, elastic_steel, rest);
  CHECK(plastic.sigma_star() == Approx(37.650235).epsilon(3e-8));  // seven or eight digits are printed
  CHECK(plastic.u_star() == Approx(.9218290).epsilon(1e-7));
  CHECK(plastic.left().behind().rho == Approx(2.582736).epsilon(3e-7));
  CHECK(plastic.right().behind().rho == Approx(9.467112).epsilon(1e-7));
  CHECK(plastic.right().waves().back().head == Approx(5.22697).epsilon(1e-6));
  CHECK(plastic.right().behind().ep == Approx(.127604).epsilon(4e-6));
  CHECK(elastic.sigma_star() == Approx(39.654921).epsilon(3e-8));
  CHECK(elastic.u_star() == Approx(.7996630).epsilon(1e-7));
  CHECK(elastic.right().behind().rho == Approx(8.922239).epsilon(1e-7));
  CHECK(elastic.right().waves().back().head == Approx(6.35763).epsilon(1e-6));
  SolidPoint still = cj;
  still.u[0] = 0;
  EpRiemann const slow(products, still, steel, rest);
  CHECK(slow.sigma_star() == Approx(18.265024).epsilon(3e-8));
  CHECK(slow.u_star() == Approx(.4674338).epsilon(2e-7));
  CHECK(slow.left().behind().rho == Approx(2.019769).epsilon(3e-7));
  CHECK(slow.right().behind().rho == Approx(8.603540).epsilon(1e-7));
  CHECK(slow.right().waves().back().head == Approx(4.98353).epsilon(1e-6));
  CHECK(slow.right().behind().ep == Approx(.063900).epsilon(1e-5));
  EpRiemann const bonded(steel, axial_state(steel, 7.8, .3, 0), aluminium, axial_state(aluminium, 2.785, 0, 0));
  CHECK(bonded.sigma_star() == Approx(3.342057).epsilon(2e-7));
  CHECK(bonded.u_star() == Approx(.2137409).epsilon(2e-7));
}

TEST_CASE("without shear modulus the solution is that of gas dynamics", "[oracle]") {
  auto check = [](ExactSolidLaw const& law_l, ExactEos const& eos_l, GasState<> const& l, ExactSolidLaw const& law_r,
                  ExactEos const& eos_r, GasState<> const& r) {
    SolidMaterial const m_l{law_l}, m_r{law_r};
    EpRiemann const solid(m_l, axial_state(m_l, l.rho, l.u, l.p), m_r, axial_state(m_r, r.rho, r.u, r.p));
    GasRiemann const gas(eos_l, l, eos_r, r);
    INFO(gas.pattern());
    // CVODE along the fans against their isentropes
    CHECK(solid.sigma_star() == Approx(gas.p_star()).epsilon(1e-10));
    CHECK(solid.u_star() == Approx(gas.u_star()).epsilon(1e-10));
    for (double xi = -2; xi < 2; xi += .0837) {
      CHECK(solid.at(xi).rho == Approx(gas.at(xi).rho).epsilon(1e-8));
      CHECK(solid.at(xi).p == Approx(gas.at(xi).p).epsilon(1e-8));
      CHECK(solid.at(xi).u[0] == Approx(gas.at(xi).u).epsilon(1e-8).margin(1e-8));
    }
  };
  IdealLaw const ideal{1.4};
  StiffenedLaw const water{4.4, .6};
  check(ideal, ideal, {1, 0, 1}, ideal, ideal, {.125, 0, .1});
  check(ideal, ideal, {1, -.3, 1}, ideal, ideal, {1.2, .2, .9});
  check(water, water, {1, .5, 2}, ideal, ideal, {.3, 0, .2});
  JwlLaw const jwl{8.545, .205, 4.6, 1.35, .25, 1.84};
  check(jwl, jwl, {1.7, 0, 10}, jwl, jwl, {1, 0, .5});
}

TEST_CASE("the contact is the same in the mirror and from a moving train", "[oracle]") {
  for (auto const& [m_l, l, m_r, r] : pairs) {
    EpRiemann const plain(m_l, l, m_r, r);
    INFO(plain.left().pattern() << " | " << plain.right().pattern());
    CHECK(plain.residual() < 1e-11);
    SolidPoint l2 = l, r2 = r;
    l2.u[0] = -l.u[0], r2.u[0] = -r.u[0];
    EpRiemann const mirrored(m_r, r2, m_l, l2);
    CHECK(mirrored.sigma_star() == Approx(plain.sigma_star()).epsilon(1e-12));
    CHECK(mirrored.u_star() == Approx(-plain.u_star()).epsilon(1e-12));
    l2.u[0] = l.u[0] + 3.1, r2.u[0] = r.u[0] + 3.1;
    EpRiemann const moving(m_l, l2, m_r, r2);
    CHECK(moving.sigma_star() == Approx(plain.sigma_star()).epsilon(1e-12));
    CHECK(moving.u_star() == Approx(plain.u_star() + 3.1).epsilon(1e-12));
  }
}

TEST_CASE("mass, momentum and energy of the whole solution are conserved", "[oracle]") {
  double const t = .4;
  for (auto const& [m_l, l, m_r, r] : pairs) {
    EpRiemann const solution(m_l, l, m_r, r);
    INFO(solution.left().pattern() << " | " << solution.right().pattern());
    double const X = 8 * t;  // beyond all waves
    SolidDensities const mean = solution.average(-X, X, t), before = solution.average(-X, X, 0);
    auto flux = [](SolidPoint const& s) {
      double const sigma = s.p - s.S[0], u = s.u[0];
      return std::array<double, 3>{s.rho * u, s.rho * u * u + sigma, (densities(s).energy + sigma) * u};
    };
    auto const f_l = flux(l), f_r = flux(r);
    double const lapse = t / (2 * X);
    CHECK(std::fabs(mean.mass - before.mass - lapse * (f_l[0] - f_r[0])) < 1e-12 * before.mass);
    CHECK(std::fabs(mean.momentum[0] - before.momentum[0] - lapse * (f_l[1] - f_r[1])) < 1e-11 * before.mass);
    CHECK(std::fabs(mean.energy - before.energy - lapse * (f_l[2] - f_r[2])) < 1e-11 * before.mass);
  }
}

TEST_CASE("one state on both sides stays, and a weak jump is the linear one", "[oracle]") {
  SolidPoint const s = axial_state(copper, 9.1, .3, 4, -.02);
  EpRiemann const still(copper, s, copper, s);
  CHECK(still.sigma_star() == Approx(4.02).epsilon(1e-14));
  CHECK(still.u_star() == Approx(.3).epsilon(1e-14));
  SolidPoint r = s;
  double const small = 1e-6;
  r.u[0] -= small;
  r.p += 20 * small;
  r.e = energy(copper.law, r.rho, r.p);
  EpRiemann const weak(copper, s, copper, r);
  ElasticRiemann const linear(copper, s, s, r);
  // errs by the square of the jump
  CHECK(std::fabs(weak.u_star() - linear.u_star()[0]) < 10 * small * small);
  CHECK(std::fabs(weak.sigma_star() + linear.traction_star()[0]) < 500 * small * small);
  CHECK(std::fabs(weak.right().waves()[0].head - linear.rays().back()) < 10 * small);
}

TEST_CASE("a contact that opens is refused", "[oracle]") {
  SolidPoint const fast = axial_state(products, 2.1, -30, 15);
  CHECK_THROWS(EpRiemann(products, fast, steel, axial_state(steel, 7.8, 0, 0)));
}
