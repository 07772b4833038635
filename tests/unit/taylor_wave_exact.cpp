/// Chapman-Jouguet states and Taylor-Zeldovich waves: published figures, an independent table, conservation.
#include "tests/catch.hpp"
#include "tests/reference_table.hpp"
#include "verification/exact/taylor_wave.hpp"

using namespace g27;

namespace {
JwlLaw const products{};  // TNT-RDX, rho0 1650 kg/m^3
double const isentrope_C = 1.058238e9;
}  // namespace

TEST_CASE("the JWL set of TNT-RDX closes on its round figures", "[oracle][detonation]") {
  ChapmanJouguet const cj = chapman_jouguet_of_isentrope(products, isentrope_C);
  CHECK(1650 / cj.state.rho == Approx(0.7504629).epsilon(1e-7));
  CHECK(cj.state.p == Approx(23.7e9).epsilon(1e-6));  // the printed coefficients have seven digits
  CHECK(cj.E0 == Approx(8.2e9).epsilon(1e-6));
  CHECK(1650 * cj.D * cj.D == Approx(94.976e9).epsilon(1e-5));
  CHECK(cj.D == Approx(7586.90).epsilon(1e-6));
  CHECK(cj.state.u == Approx(1893.214).epsilon(1e-6));
  CHECK(cj.state.rho == Approx(2198.643).epsilon(1e-6));
}

TEST_CASE("Chapman-Jouguet states are sonic and satisfy the jump conditions", "[oracle][detonation]") {
  IdealLaw const ideal{3};
  for (auto const& [eos, cj] : {std::pair<ExactEos, ChapmanJouguet>{products, chapman_jouguet(products, 1650, 8.2e9)},
                                {products, chapman_jouguet(products, 1700, 9e9, 1e5)},
                                {products, chapman_jouguet_of_isentrope(products, isentrope_C)},
                                {ideal, chapman_jouguet_of_speed(ideal, 1875, 8000)}}) {
    double const p0 = cj.rho0 == 1700 ? 1e5 : 0;
    auto const& [rho, u, p] = cj.state;
    CHECK(cj.D - u == Approx(sound_speed(eos, rho, p)).epsilon(1e-10));
    CHECK(rho * (cj.D - u) == Approx(cj.rho0 * cj.D).epsilon(1e-13));
    CHECK(p - p0 == Approx(cj.rho0 * cj.D * u).epsilon(1e-13));
    double const ahead = cj.E0 / cj.rho0 + p0 / cj.rho0 + cj.D * cj.D / 2;
    CHECK(energy(eos, rho, p) + p / rho + (cj.D - u) * (cj.D - u) / 2 == Approx(ahead).epsilon(1e-13));
  }
}

TEST_CASE("energy, isentrope and speed define the same wave", "[oracle][detonation]") {
  ChapmanJouguet const a = chapman_jouguet_of_isentrope(products, isentrope_C),
                       b = chapman_jouguet(products, 1650, a.E0);
  // near the touching point D is stationary but the density is not: half the digits of the Hugoniot residual
  CHECK(b.D == Approx(a.D).epsilon(1e-12));
  CHECK(b.state.rho == Approx(a.state.rho).epsilon(1e-9));
  IdealLaw const ideal{3};
  ChapmanJouguet const c = chapman_jouguet_of_speed(ideal, 1875, 8000), d = chapman_jouguet(ideal, 1875, c.E0);
  CHECK(c.state.p == Approx(3e10));
  CHECK(c.E0 == Approx(1875 * 8000. * 8000 / 16).epsilon(1e-13));  // D^2 = 2 (gamma^2 - 1) q
  CHECK(d.D == Approx(8000).epsilon(1e-12));
}

TEST_CASE("spherical wave against an independent integration", "[oracle][detonation]") {
  TaylorWave const wave(products, chapman_jouguet_of_isentrope(products, isentrope_C), 2);
  auto const table = read_reference("taylorwave_paperJWL_rho1.65_sph.csv", {"r", "u", "rho", "p"});
  REQUIRE(table.rows.size() > 400);
  for (auto const& row : table.rows) {
    double const u = 1000 * row[1];
    if (u <= 0) continue;
    INFO("u " << u);
    double const r = wave.position(u);
    GasState<> const s = wave.state_of(u);
    // ten digits are printed; the table's own integration tolerance is about 1e-9
    CHECK(r == Approx(row[0]).epsilon(1e-8));
    CHECK(s.rho == Approx(1000 * row[2]).epsilon(1e-8));
    CHECK(s.p == Approx(1e9 * row[3]).epsilon(1e-8));
  }
}

TEST_CASE("half-speed points and cores", "[oracle][detonation]") {
  ChapmanJouguet const cj = chapman_jouguet_of_isentrope(products, isentrope_C);
  struct Figures {
    int symmetry;
    double half, rho_half, p_half, rho_core, p_core;
  };
  for (auto const& f : {Figures{2, .897422, 1792.057, 12.474438e9, 1348.58, 5.0219e9},
                        Figures{1, .851504, 1802.587, 12.712908e9, 1397.62, 5.60775e9}}) {
    TaylorWave const wave(products, cj, f.symmetry);
    CHECK(wave.position(cj.state.u / 2) == Approx(f.half).margin(5.1e-7));
    GasState<> const s = wave.at(wave.position(cj.state.u / 2));
    CHECK(s.u == Approx(cj.state.u / 2).epsilon(1e-10));
    CHECK(s.rho == Approx(f.rho_half).epsilon(3e-7));
    CHECK(s.p == Approx(f.p_half).epsilon(1e-7));
    CHECK(wave.core_state().rho == Approx(f.rho_core).epsilon(4e-6));
    CHECK(wave.core_state().p == Approx(f.p_core).epsilon(1e-5));
    // the core's edge moves with its sound speed
    GasState<> const core = wave.core_state();
    CHECK(wave.core() * cj.D == Approx(sound_speed(products, core.rho, core.p)).epsilon(1e-12));
  }
  double const edge = TaylorWave(products, cj, 2).core();
  CHECK(edge > 0.44501);
  CHECK(edge < 0.44550);
}

TEST_CASE("the wave contains the explosive's mass and energy", "[oracle][detonation]") {
  // not used in its construction: all of rho0 and E0 swept by the front is found behind it
  for (int symmetry : {0, 1, 2}) {
    TaylorWave const wave(products, chapman_jouguet_of_isentrope(products, isentrope_C), symmetry);
    double const R = 0.05, t = R / wave.front().D;
    GasConserved<> const inside = wave.average(0, R, t);
    CHECK(inside.mass == Approx(1650).epsilon(1e-10));
    CHECK(inside.energy == Approx(wave.front().E0).epsilon(1e-10));
    if (symmetry == 0)
      CHECK(inside.momentum * R == Approx(t * (wave.core_state().p)).epsilon(1e-10));  // impulse of the wall
    // and cells add up to the whole, with and without the front inside
    GasConserved<> sum{0, 0, 0};
    for (int i = 0; i < 12; ++i) {
      double const a = 0.1 * i * R, b = 0.1 * (i + 1) * R;
      GasConserved<> const c = wave.average(a, b, t);
      double const w = std::pow(b, symmetry + 1) - std::pow(a, symmetry + 1);
      sum.mass += w * c.mass;
      sum.momentum += w * c.momentum;
    }
    CHECK(sum.mass == Approx(1650 * std::pow(1.2 * R, symmetry + 1)).epsilon(1e-10));
    CHECK(sum.momentum == Approx(inside.momentum * std::pow(R, symmetry + 1)).epsilon(1e-9));
  }
}

TEST_CASE("Mader's planar wave", "[oracle][detonation]") {
  // gamma 3, D .8 cm/us, rho0 1.875 g/cm3: plateau of Mader's slab, and ExactPack's cell averages (cgs, ten digits)
  IdealLaw const ideal{3};
  TaylorWave const wave(ideal, chapman_jouguet_of_speed(ideal, 1875, 8000), 0);
  CHECK(wave.core_state().p == Approx(8.8888888889e9).epsilon(1e-10));
  CHECK(wave.core_state().rho == Approx(5000. / 3).epsilon(1e-10));
  CHECK(wave.core() == Approx(0.5).epsilon(1e-10));
  auto const table = read_reference("mader.csv");
  auto const x = table.column("xdet"), u = table.column("velocity"), p = table.column("pressure"),
             rho = table.column("density");
  double const h = 0.01, front = 5;  // cm
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // Simpson's rule is exact for the cubic p; the cell at the plateau's edge has a kink
    if (std::fabs(x[i] - 0.5 * front) < h) continue;
    auto at = [&](double d) { return wave.at((x[i] + d) / front); };
    GasState<> const a = at(-h / 2), b = at(0), c = at(h / 2);
    auto mean = [](double l, double m, double r) { return (l + 4 * m + r) / 6; };
    worst = std::max({worst, std::fabs(100 * mean(a.u, b.u, c.u) - u[i]) / 2e5,
                      std::fabs(10 * mean(a.p, b.p, c.p) / p[i] - 1),
                      std::fabs(mean(a.rho, b.rho, c.rho) / 1000 / rho[i] - 1)});
  }
  CHECK(worst < 1e-8);
}
