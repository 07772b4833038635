/// Sedov's and Noh's problems: published constants, ExactPack's tables, the Euler equations and conservation.
#include "tests/catch.hpp"
#include "tests/reference_table.hpp"
#include "verification/exact/noh.hpp"
#include "verification/exact/sedov.hpp"

using namespace g27;

TEST_CASE("Sedov's alpha", "[oracle]") {
  Sedov const sphere(1.4, 2, 1, 1);
  CHECK(sphere.alpha() == Approx(0.851072).epsilon(6e-7));            // published digits
  CHECK(sphere.alpha() == Approx(0.8510718547931913).epsilon(1e-9));  // ExactPack's quadrature
  CHECK(Sedov(5.0 / 3, 2, 1, 1).alpha() == Approx(0.4936).epsilon(1e-4));
  Sedov const blast(1.4, 2, 0.851072, 1);
  CHECK(blast.shock_radius(1) == Approx(1).epsilon(1e-6));
}

TEST_CASE("energy and entropy are conserved together", "[oracle]") {
  for (double gamma : {1.2, 1.4, 5.0 / 3, 3.0})
    for (int symmetry : {0, 1, 2}) CHECK(Sedov(gamma, symmetry, 1, 1).residual() < 1e-9);
}

TEST_CASE("Sedov's blast contains the mass it swept and the energy it got", "[oracle]") {
  for (int symmetry : {0, 1, 2}) {
    double const E = 3.7, rho0 = 1.3, t = 0.8;
    Sedov const blast(1.4, symmetry, E, rho0);
    double const R = 1.1 * blast.shock_radius(t);
    double const directions = symmetry == 0 ? 2 : symmetry == 1 ? 2 * M_PI : 4 * M_PI;
    double mass = 0, energy = 0;
    int const cells = 400;
    for (int i = 0; i < cells; ++i) {
      double const a = R * i / cells, b = R * (i + 1) / cells;
      double const measure = (std::pow(b, symmetry + 1) - std::pow(a, symmetry + 1)) / (symmetry + 1);
      GasConserved<> const c = blast.average(a, b, t);
      mass += c.mass * measure;
      energy += c.energy * measure;
    }
    // Gauss quadrature of r^power near the centre
    CHECK(mass == Approx(rho0 * std::pow(R, symmetry + 1) / (symmetry + 1)).epsilon(1e-8));
    CHECK(energy * directions == Approx(E).epsilon(1e-8));
  }
}

TEST_CASE("Sedov's profile satisfies the Euler equations", "[oracle]") {
  double const gamma = 1.4, t = 0.9;
  for (int symmetry : {0, 1, 2}) {
    Sedov const blast(gamma, symmetry, 1, 1);
    double const R = blast.shock_radius(t);
    for (double ratio : {0.3, 0.7, 0.95}) {
      double const r = ratio * R, h = 1e-4 * r, k = 1e-4 * t;
      auto d = [](auto f, double step) {
        return (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step);
      };
      auto dr = [&](auto field) { return d([&](double x) { return field(blast.at(r + x, t)); }, h); };
      auto dt = [&](auto field) { return d([&](double x) { return field(blast.at(r, t + x)); }, k); };
      auto rho = [](auto const& s) { return s.rho; };
      auto u = [](auto const& s) { return s.u; };
      auto p = [](auto const& s) { return s.p; };
      GasState<> const s = blast.at(r, t);
      double const divergence = dr(u) + symmetry * s.u / r;
      // fourth-order differences of fields with exponents up to 20: round-off of 1e-13/1e-4 dominates
      CHECK(std::fabs(dt(rho) + s.u * dr(rho) + s.rho * divergence) < 1e-7 * s.rho / t);
      CHECK(std::fabs(dt(u) + s.u * dr(u) + dr(p) / s.rho) < 1e-7 * (s.u / t + s.p / (s.rho * R)));
      CHECK(std::fabs(dt(p) + s.u * dr(p) + gamma * s.p * divergence) < 1e-7 * s.p / t);
    }
  }
}

TEST_CASE("Sedov's profile agrees with ExactPack away from the centre", "[oracle]") {
  auto const table = read_reference("sedov_spherical.csv");
  Sedov const blast(1.4, 2, 0.851072, 1);
  auto const r = table.column("position"), rho = table.column("density"), u = table.column("velocity"),
             p = table.column("pressure");
  int compared = 0;
  double worst_outer = 0, worst_p = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (r[i] > blast.shock_radius(1)) continue;
    GasState<> const s = blast.at(r[i], 1);
    worst_p = std::max(worst_p, std::fabs(s.p / p[i] - 1));
    if (r[i] < 0.5) continue;  // ExactPack's density is wrong by decades near the centre
    ++compared;
    worst_outer = std::max({worst_outer, std::fabs(s.rho / rho[i] - 1), std::fabs(s.u / u[i] - 1)});
  }
  CHECK(compared > 200);
  // ExactPack inverts its similarity functions on a grid: a few 1e-6, and 2e-5 in the steep layer below the shock
  CHECK(worst_outer < 3e-5);
  CHECK(worst_p < 2e-5);
}

TEST_CASE("Noh's states and ExactPack's tables", "[oracle]") {
  for (auto const& [symmetry, name] : {std::pair{0, "planar"}, {1, "cylindrical"}, {2, "spherical"}}) {
    Noh const noh{.gamma = 5.0 / 3, .rho0 = 1, .speed = 1, .symmetry = symmetry};
    CHECK(noh.shocked().rho == Approx(std::pow(4, symmetry + 1)));
    CHECK(noh.shocked().p == Approx(std::pow(4, symmetry + 1) / 3));
    CHECK(noh.shock_speed() == Approx(1.0 / 3));
    auto const table = read_reference(std::string("noh_") + name + ".csv");
    auto const r = table.column("position"), rho = table.column("density"), u = table.column("velocity"),
               p = table.column("pressure");
    REQUIRE(r.size() > 400);
    for (std::size_t i = 0; i < r.size(); ++i) {
      GasState<> const s = noh.at(r[i], 0.6);
      CHECK(s.rho == Approx(rho[i]).epsilon(1e-9));  // ten digits are printed
      CHECK(s.u == Approx(u[i]).margin(1e-9));
      CHECK(s.p == Approx(p[i]).epsilon(1e-9).margin(1e-12));
    }
  }
}

TEST_CASE("Noh's shock satisfies the jump conditions for any gamma", "[oracle]") {
  for (double gamma : {1.3, 5.0 / 3, 2.2}) {
    for (int symmetry : {0, 1, 2}) {
      Noh const noh{.gamma = gamma, .rho0 = 0.7, .speed = 2.5, .symmetry = symmetry};
      double const t = 0.4, r = noh.shock_speed() * t, D = noh.shock_speed();
      GasState<> const a = noh.shocked(), b = noh.at(r * (1 + 1e-14), t);
      CHECK(a.rho * D == Approx(b.rho * (D - b.u)).epsilon(1e-12));
      CHECK(a.p == Approx(b.rho * (D - b.u) * -b.u).epsilon(1e-12));
      CHECK(a.p / ((gamma - 1) * a.rho) == Approx(b.u * b.u / 2).epsilon(1e-12));
      // mass inside 2 r is what was there at the start and what flowed in
      GasConserved<> const c = noh.average(0, 2 * r, t);
      CHECK(c.mass * std::pow(2 * r, symmetry + 1) ==
            Approx(0.7 * std::pow(2 * r + 2.5 * t, symmetry + 1)).epsilon(1e-12));
      CHECK(c.energy == Approx(c.mass * 2.5 * 2.5 / 2).epsilon(1e-12));
    }
  }
}
