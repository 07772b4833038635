// Identities of every registered equation of state, at default and at other parameters.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <vector>

#include "riemann/eos/factory.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

std::vector<IdealGas> variants(IdealGas) { return {{}, {1.1}, {5.0 / 3.0}, {3.0}}; }
std::vector<StiffenedGas> variants(StiffenedGas) { return {{}, {1.5, 0.0}, {7.15, 3e8}, {2.0, 1e10}}; }
std::vector<Jwl> variants(Jwl) {
  return {{}, {8.545e11, 2.05e10, 4.6, 1.35, 0.25, 1840.0}, {3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630.0}};
}
std::vector<MieGruneisen> variants(MieGruneisen) {
  return {{}, {8930.0, 3940.0, 1.489, 1.99}, {998.0, 1647.0, 1.921, 0.5}, {7850.0, 4570.0, 1.0, 1.9}};
}

/// A density over the range of interest and a pressure `thermal` above the admissible limit.
struct Point {
  double rho, p;
};
template <class E>
std::vector<Point> points(E const& eos, double rho_low, double rho_high, double scale) {
  std::mt19937_64 random(27);
  std::uniform_real_distribution<double> unit;
  std::vector<Point> all;
  for (int i = 0; i < 400; ++i) {
    double const rho = rho_low * std::pow(rho_high / rho_low, unit(random));
    double const coldest = -eos.pressure_margin(rho, 0.0);
    all.push_back({rho, coldest + scale * std::pow(10.0, 5.0 * unit(random) - 3.0)});
  }
  return all;
}
std::vector<Point> points(IdealGas const& e) { return points(e, 1e-3, 1e3, 1e5); }
std::vector<Point> points(StiffenedGas const& e) { return points(e, 1.0, 1e4, e.p_inf + 1e5); }
std::vector<Point> points(Jwl const& e) { return points(e, 1e-3 * e.rho0, 2.5 * e.rho0, 1e9); }
std::vector<Point> points(MieGruneisen const& e) {
  double const densest = e.s > 1.2 ? e.rho0 / (1.0 - 0.9 / e.s) : 4.0 * e.rho0;
  return points(e, 0.5 * e.rho0, densest, e.rho0 * e.c0 * e.c0);
}

/// Pressure on the isentrope through (rho, p) at rho exp(x), |x| small: de = -p dv by the classical Runge-Kutta rule
/// in one step of ln(rho); e and p(rho, e) are all it uses.
template <class E>
double isentrope(E const& eos, Point const& k, double x) {
  auto const rate = [&](double y, double e) {
    double const rho = k.rho * std::exp(y);
    return eos.pressure(rho, e) / rho;
  };
  double const e = eos.energy(k.rho, k.p);
  double const a = rate(0.0, e), b = rate(0.5 * x, e + 0.5 * x * a), c = rate(0.5 * x, e + 0.5 * x * b);
  double const d = rate(x, e + x * c);
  return eos.pressure(k.rho * std::exp(x), e + x * (a + 2.0 * b + 2.0 * c + d) / 6.0);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("p(rho, e(rho, p)) = p", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    for (Point const& k : points(eos)) {
      double const e = eos.energy(k.rho, k.p);
      // round-off of the largest term on the way, which the bulk modulus bounds
      double const scale = std::fabs(k.p) + eos.bulk_modulus(k.rho, k.p) + eos.gruneisen(k.rho) * k.rho * std::fabs(e);
      CHECK(std::fabs(eos.pressure(k.rho, e) - k.p) <= 1e-14 * scale);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("K, G and Gamma are the derivatives that p(rho, e) implies", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    double worst_K = 0, worst_G = 0, worst_Gamma = 0;
    for (Point const& k : points(eos)) {
      if constexpr (std::same_as<TestType, MieGruneisen>) {
        if (std::fabs(k.rho / eos.rho0 - 1.0) < 0.02) {
          continue;  // the third derivative jumps at rho0, which the five-point formulae straddle
        }
      }
      double const K = eos.bulk_modulus(k.rho, k.p), G = eos.fundamental_derivative(k.rho, k.p);
      // five-point differences in ln(rho) along the isentrope: error of order (h (K' + R))^4, and eps/h^2
      double const h = 5e-4;
      double const p1 = isentrope(eos, k, h), m1 = isentrope(eos, k, -h), p2 = isentrope(eos, k, 2 * h),
                   m2 = isentrope(eos, k, -2 * h);
      double const K_fd = (8.0 * (p1 - m1) - (p2 - m2)) / (12.0 * h);
      double const curvature = (16.0 * (p1 + m1) - (p2 + m2) - 30.0 * k.p) / (12.0 * h * h);
      worst_K = std::max(worst_K, std::fabs(K_fd / K - 1.0));
      // K c^2-free form: d^2p/d(ln rho)^2 = K (2 G - 1)
      worst_G = std::max(worst_G, std::fabs(0.5 * (curvature / K + 1.0) / G - 1.0));
      double const e = eos.energy(k.rho, k.p), de = K / k.rho;
      double const Gamma = (eos.pressure(k.rho, e + de) - eos.pressure(k.rho, e - de)) / (2.0 * de * k.rho);
      worst_Gamma = std::max(worst_Gamma, std::fabs(Gamma / eos.gruneisen(k.rho) - 1.0));
    }
    CAPTURE(worst_K, worst_G, worst_Gamma);
    CHECK(worst_K < 1e-7);
    CHECK(worst_G < 1e-6);
    CHECK(worst_Gamma < 1e-11);  // p is linear in e: round-off only
  }
}

TEMPLATE_LIST_TEST_CASE("every admissible state is hyperbolic and convex", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    for (Point const& k : points(eos)) {
      CHECK(eos.pressure_margin(k.rho, k.p) > 0.0);
      CHECK(eos.bulk_modulus(k.rho, k.p) > 0.0);
      CHECK(eos.fundamental_derivative(k.rho, k.p) > 0.0);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("the second differential of rho e is that of its differences", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    auto const density = [&](double rho, double p) { return rho * eos.energy(rho, p); };
    for (auto const& [rho, p] : points(eos)) {
      double const h = 2e-4, d_rho = h * rho, d_p = 0.7 * h * eos.bulk_modulus(rho, p);
      double const up = density(rho + d_rho, p + d_p), down = density(rho - d_rho, p - d_p), here = density(rho, p);
      double const difference = (up - here) - (here - down);
      // what the second difference loses to round-off of rho e, and its next term: h^2 of it, over the law's exponents
      double const size = std::fabs(up) + std::fabs(down) + std::fabs(here) + eos.bulk_modulus(rho, p);
      CHECK(eos.energy_bend(rho, d_rho, d_p) ==
            Approx(difference).epsilon(1e-4).margin(1e-15 * size + 1e-4 * h * h * size));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("the admissible set is convex in the conserved variables", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    auto const all = points(eos);
    for (std::size_t i = 1; i < all.size(); ++i) {
      Point const &a = all[i - 1], &b = all[i];
      for (double const w : {0.01, 0.3, 0.5, 0.9}) {
        // at equal velocities: the kinetic energy of a mixture only adds to its internal energy
        double const rho = w * a.rho + (1.0 - w) * b.rho;
        double const e = (w * a.rho * eos.energy(a.rho, a.p) + (1.0 - w) * b.rho * eos.energy(b.rho, b.p)) / rho;
        CHECK(eos.pressure_margin(rho, eos.pressure(rho, e)) > 0.0);
      }
    }
  }
}

TEMPLATE_LIST_TEST_CASE("the admissible set is invariant along isentropes", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    auto const all = points(eos);
    double densest = 0;
    for (Point const& k : all) {
      densest = std::max(densest, k.rho);
    }
    for (Point k : all) {
      // on its boundary the state stays on the boundary: margin 0 is an isentrope
      k.p = -eos.pressure_margin(k.rho, 0.0);
      double const scale = std::fabs(k.p) + std::fabs(eos.vacuum_pressure()) + eos.bulk_modulus(k.rho, k.p);
      double const reach = 1e-3 * k.rho / densest;  // where v is large the cold curve falls as exp(-R v)
      for (double const x : {-reach, reach}) {
        double const p = isentrope(eos, k, x);
        // Runge-Kutta's error in one step of 1e-3, (R v x)^5/120, is below 1e-12
        CHECK(std::fabs(eos.pressure_margin(k.rho * std::exp(x), p)) <=
              1e-12 * scale + 1e-280);  // where exp(-R v) is cut off
      }
    }
  }
}

TEMPLATE_LIST_TEST_CASE("vector lanes agree with the scalar", "[eos]", AnyEos) {
  for (auto const& eos : variants(TestType{})) {
    auto const all = points(eos);
    for (std::size_t i = 0; i + width<Simd> <= all.size(); i += width<Simd>) {
      Simd rho, p;
      for (std::size_t j = 0; j < width<Simd>; ++j) {
        rho[j] = all[i + j].rho;
        p[j] = all[i + j].p;
      }
      Simd const e = eos.energy(rho, p), back = eos.pressure(rho, e), K = eos.bulk_modulus(rho, p),
                 margin = eos.pressure_margin(rho, p), G = eos.fundamental_derivative(rho, p);
      for (std::size_t j = 0; j < width<Simd>; ++j) {
        auto const [r, q] = all[i + j];
        // the same operations: bit for bit on one instruction set
        CHECK(lane(e, j) == eos.energy(r, q));
        CHECK(lane(back, j) == eos.pressure(r, lane(e, j)));
        CHECK(lane(K, j) == eos.bulk_modulus(r, q));
        CHECK(lane(margin, j) == eos.pressure_margin(r, q));
        CHECK(lane(G, j) == eos.fundamental_derivative(r, q));
      }
    }
  }
}

TEST_CASE("Mie-Grueneisen reproduces its principal Hugoniot U_s = c0 + s u_p", "[eos]") {
  for (MieGruneisen const& eos : variants(MieGruneisen{})) {
    for (double const u_p : {1.0, 100.0, 1000.0, 5000.0}) {
      double const U_s = eos.c0 + eos.s * u_p, p = eos.rho0 * U_s * u_p, rho = eos.rho0 * U_s / (U_s - u_p);
      double const e = 0.5 * u_p * u_p;  // jump conditions into the gas at rest, p = 0, e = 0
      // the rounding of rho moves F by K0 eps: c0^2/Gamma0 eps of energy where eta is small, s eta/(1 - s eta) more
      // else
      CHECK(eos.energy(rho, p) == Approx(e).epsilon(1e-12).margin(1e-15 * eos.c0 * eos.c0 / eos.Gamma0));
    }
  }
}

TEST_CASE("Mie-Grueneisen is continuous at rho0 up to its second derivative", "[eos]") {
  for (MieGruneisen const& eos : variants(MieGruneisen{})) {
    double const K0 = eos.rho0 * eos.c0 * eos.c0;
    for (double const p : {1e-4 * K0, K0}) {
      double const below = eos.rho0 * (1.0 - 1e-9), above = eos.rho0 * (1.0 + 1e-9);
      CHECK(eos.energy(above, p) == Approx(eos.energy(below, p)).margin(3e-9 * eos.c0 * eos.c0 / eos.Gamma0));
      CHECK(eos.bulk_modulus(above, p) == Approx(eos.bulk_modulus(below, p)).epsilon(1e-7));
      CHECK(eos.fundamental_derivative(above, p) == Approx(eos.fundamental_derivative(below, p)).epsilon(1e-7));
    }
    CHECK(eos.fundamental_derivative(eos.rho0, 0.0) == Approx(2.0 * eos.s).epsilon(1e-14));
  }
}

TEST_CASE("the factory builds every law from its own metadata and names what is wrong", "[eos][factory]") {
  using Catch::Matchers::Contains;
  for (std::string const& name : eos_names()) {
    std::map<std::string, double> values;
    for (auto const& p : eos_parameters(name)) {
      values[p.name] = p.default_value;
    }
    AnyEos const eos = make_eos(name, values);
    CHECK(eos_name(eos) == name);
    CHECK(eos_values(eos) == values);
    auto missing = values;
    missing.erase(missing.begin());
    CHECK_THROWS_WITH(make_eos(name, missing), Contains("missing") && Contains(values.begin()->first));
    auto negative = values;
    negative.begin()->second = -1.0;
    CHECK_THROWS_WITH(make_eos(name, negative), Contains("is not in"));
  }
  CHECK_THROWS_WITH(make_eos("jlw", {}), Contains("'jwl'"));
  CHECK_THROWS_WITH(make_eos("ideal", {{"gama", 1.4}}), Contains("did you mean 'gamma'"));
  CHECK_THROWS_WITH(make_eos("ideal", {{"gamma", std::nan("")}}), Contains("is not in"));
  CHECK_THROWS_WITH(make_eos("mie-gruneisen", {{"rho0", 2785.0}, {"c0", 5328.0}, {"s", 1.0}, {"Gamma0", 2.5}}),
                    Contains("below 2 s"));
}
