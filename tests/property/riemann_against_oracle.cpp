/// The general Riemann solver of the scheme against the oracle, which shares no formula with it, on random problems of
/// every pair of laws: star states, vacuums and the state on the face.
#include <random>

#include "riemann/eos/registry.hpp"
#include "riemann/gas/exact.hpp"
#include "tests/catch.hpp"
#include "verification/exact/gas_riemann.hpp"

using namespace g27;

namespace {

using Random = std::mt19937_64;
double uniform(Random& r, double a, double b) { return std::uniform_real_distribution<>(a, b)(r); }
double decades(Random& r, double a, double b) { return std::pow(10, uniform(r, a, b)); }

// Each law twice, and random states that it admits.
struct Air {
  IdealGas scheme{.gamma = 1.4};
  IdealLaw oracle{1.4};
  GasState<> state(Random& r) const { return {decades(r, -1, 1), uniform(r, -500, 500), 1e5 * decades(r, -2, 2)}; }
};
struct Water {
  StiffenedGas scheme{.gamma = 4.4, .p_inf = 6e8};
  StiffenedLaw oracle{4.4, 6e8};
  GasState<> state(Random& r) const { return {uniform(r, 800, 1200), uniform(r, -300, 300), 1e5 * decades(r, 0, 4)}; }
};
struct Products {
  Jwl scheme{.A = 708.6056e9, .B = 13.16457e9, .R1 = 4.94, .R2 = 1.35, .omega = 0.28, .rho0 = 1650};
  JwlLaw oracle{};
  GasState<> state(Random& r) const {
    double const rho = decades(r, 1, 3.3);
    return {rho, uniform(r, -1000, 1000), 1e9 * rho / 1650 * decades(r, -2, 0.5) - oracle.thermal(rho, 0.0)};
  }
};
struct Aluminium {
  MieGruneisen scheme{.rho0 = 2785, .c0 = 5328, .s = 1.338, .Gamma0 = 2};
  MieGruneisenLaw oracle{.rho0 = 2785, .c0 = 5328, .s = 1.338, .Gamma0 = 2};
  GasState<> state(Random& r) const {
    double const rho = uniform(r, 2600, 3300);
    return {rho, uniform(r, -800, 800), Isentrope(oracle, 2785, 0).pressure(rho) + decades(r, 5, 9)};
  }
};

template <class L, class R>
void compare(char const* name, double tolerance) {
  L const l{};
  R const r{};
  Random random(20);
  double worst_p = 0, worst_u = 0, worst_rho = 0, worst_face = 0;
  int unsolved = 0, other_pattern = 0;
  for (int i = 0; i < 200; ++i) {
    GasState<> const a = l.state(random), b = r.state(random);
    GasRiemann const exact(l.oracle, a, r.oracle, b);
    auto const star = exact_star<double>(l.scheme, r.scheme, a, b, true);
    unsolved += !star.converged;
    other_pattern += star.vacuum != exact.vacuum();
    if (!exact.vacuum()) {
      double const p_floor = 1e-3 * std::min(std::fabs(a.p), std::fabs(b.p));
      worst_p = std::max(worst_p, std::fabs(star.p - exact.p_star()) / (std::fabs(exact.p_star()) + p_floor));
      double const c = sound_speed(l.oracle, a.rho, a.p) + sound_speed(r.oracle, b.rho, b.p);
      worst_u = std::max(worst_u, std::fabs(star.u - exact.u_star()) / c);
      worst_rho = std::max(
          {worst_rho, std::fabs(star.rho_l / exact.rho_star_l() - 1), std::fabs(star.rho_r / exact.rho_star_r() - 1)});
      auto const face = exact_face<double>(l.scheme, r.scheme, a, b, true).face;
      GasState<> const sample = exact.at(0);
      worst_face = std::max({worst_face, std::fabs(face.rho / sample.rho - 1),
                             std::fabs(face.p - sample.p) / (std::fabs(sample.p) + p_floor)});
    }
  }
  INFO(name);
  CHECK(unsolved == 0);
  CHECK(other_pattern == 0);
  CHECK(worst_p < tolerance);
  CHECK(worst_u < 1e-12);  // where the scheme's iteration stops
  CHECK(worst_rho < tolerance);
  CHECK(worst_face < tolerance);
}

}  // namespace

TEST_CASE("the general Riemann solver agrees with the oracle", "[riemann]") {
  // The iteration stops at velocity residuals of 1e-12 c; of p that is 1e-12 K, of densities 1e-12 times their ratio.
  compare<Air, Air>("air, air", 1e-12);
  compare<Water, Air>("water, air", 1e-11);
  compare<Air, Products>("air, products", 1e-12);
  compare<Products, Products>("products, products", 1e-12);
  compare<Products, Water>("products, water", 1e-11);
  // here p* may be as small as a thousandth of K
  compare<Aluminium, Aluminium>("aluminium, aluminium", 1e-10);
  compare<Water, Aluminium>("water, aluminium", 1e-10);
  compare<Aluminium, Air>("aluminium, air", 1e-10);
}
