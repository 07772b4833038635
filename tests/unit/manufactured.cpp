/// Automatic differentiation and manufactured sources against independent forms of the same derivatives.
#include "tests/catch.hpp"
#include "verification/mms/manufactured_1d.hpp"

using namespace g27;

namespace {

double const scale = 2 * M_PI;

/// Fields around a base state, away from symmetric points.
template <class Law>
auto wave(Law law, double rho0, double u0, double p0, Symmetry symmetry) {
  auto rho = [=](auto x, auto t) { return rho0 * (1 + 0.1 * sin(scale * x + 0.3 - 2 * t)); };
  auto u = [=](auto x, auto t) { return u0 * (1 + 0.2 * cos(1.5 * x + t)); };
  auto p = [=](auto x, auto t) { return p0 * (1 + 0.15 * exp(-x * x) * sin(t + 0.7)); };
  return Manufactured1d(rho, u, p, law, symmetry);
}

template <class F>
double difference(F f, double h) {  // fourth order
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

template <class Law>
void check(Law law, double rho0, double u0, double p0, Symmetry symmetry) {
  auto const m = wave(law, rho0, u0, p0, symmetry);
  INFO(eos_name(law) << " symmetry " << static_cast<int>(symmetry));
  double const x = 0.6, t = 0.2, h = 1e-3;
  auto const q = m.state(x, t);
  auto const rate = m.primitive_rate(x, t);
  auto dx = [&](auto field) { return difference([&](double d) { return field(m.state(x + d, t)); }, h); };
  auto dt = [&](auto field) { return difference([&](double d) { return field(m.state(x, t + d)); }, h); };
  auto rho = [](auto const& s) { return s.rho; };
  auto u = [](auto const& s) { return s.u; };
  auto p = [](auto const& s) { return s.p; };
  double const spread = static_cast<int>(symmetry) * q.u / x, divergence = dx(u) + spread;
  double const K = law.bulk_modulus(q.rho, q.p);
  // The primitive form of the equations, with the bulk modulus instead of e(rho, p); differences err by h^4 (2 pi)^5/30
  double const tolerance = 1e-8;
  CHECK(std::fabs(rate.rho - (dt(rho) + q.u * dx(rho) + q.rho * divergence)) < tolerance * q.rho * (1 + u0));
  CHECK(std::fabs(rate.u - (dt(u) + q.u * dx(u) + dx(p) / q.rho)) < tolerance * (u0 * (1 + u0) + K / q.rho));
  CHECK(std::fabs(rate.p - (dt(p) + q.u * dx(p) + K * divergence)) < tolerance * K * (1 + u0));
}

}  // namespace

TEST_CASE("duals differentiate", "[mms]") {
  using D = Dual<2>;
  auto f = [](auto x, auto y) {
    return exp(x * y) / sqrt(1 + x) - log(y) * pow(x, 2.5) + tanh(x - y) * cos(y) / sin(x);
  };
  double const x = 0.7, y = 1.3, h = 1e-3;
  D const value = f(D::variable(x, 0), D::variable(y, 1));
  auto g = [&](double a, double b) {
    using std::exp, std::sqrt, std::log, std::pow, std::tanh, std::cos, std::sin;
    return exp(a * b) / sqrt(1 + a) - log(b) * pow(a, 2.5) + tanh(a - b) * cos(b) / sin(a);
  };
  CHECK(value.value == Approx(g(x, y)).epsilon(1e-14));
  // fourth-order differences: h^4 = 1e-12, times fifth derivatives of a few hundred
  CHECK(value.d[0] == Approx(difference([&](double d) { return g(x + d, y); }, h)).epsilon(1e-9));
  CHECK(value.d[1] == Approx(difference([&](double d) { return g(x, y + d); }, h)).epsilon(1e-9));
}

TEST_CASE("bulk moduli equal rho dp/drho at constant entropy, from p(rho, e) alone", "[mms][eos]") {
  using D = Dual<2>;
  auto agrees = [](auto const& law, double rho, double p) {
    double const e = law.energy(rho, p);
    CHECK(law.pressure(rho, e) == Approx(p).epsilon(1e-12));
    D const q = law.pressure(D::variable(rho, 0), D::variable(e, 1));
    CHECK(rho * (q.d[0] + p / (rho * rho) * q.d[1]) == Approx(law.bulk_modulus(rho, p)).epsilon(1e-12));
  };
  agrees(IdealLaw{1.3}, 1.1, 2e5);
  agrees(StiffenedLaw{3.1, 5e8}, 900, 2e7);
  agrees(JwlLaw{}, 2100, 3e10);
  agrees(JwlLaw{}, 40, 3e7);
  agrees(MieGruneisenLaw{}, 3300, 4e10);
  agrees(MieGruneisenLaw{}, 2500, 1e9);
}

TEST_CASE("manufactured sources balance the primitive equations", "[mms]") {
  for (Symmetry symmetry : {Symmetry::planar, Symmetry::cylindrical, Symmetry::spherical}) {
    check(IdealLaw{1.3}, 1.1, 0.8, 1.7, symmetry);
    check(StiffenedLaw{3.1, 5}, 2.0, 0.4, 1.2, symmetry);
    check(JwlLaw{.A = 7.1, .B = .13, .R1 = 4.9, .R2 = 1.3, .omega = .28, .rho0 = 1.65}, 1.5, 0.9, 0.9, symmetry);
    check(MieGruneisenLaw{.rho0 = 2.7, .c0 = 5.3, .s = 1.34, .Gamma0 = 2}, 3.2, 0.5, 20, symmetry);
  }
}

TEST_CASE("mean sources integrate the balance over a cell and a step", "[mms]") {
  // change of the cell's content plus outflow equals source: each term by its own quadrature
  for (Symmetry symmetry : {Symmetry::planar, Symmetry::cylindrical, Symmetry::spherical}) {
    IdealLaw const law{1.4};
    auto const m = wave(law, 1.1, 0.8, 1.7, symmetry);
    int const n = static_cast<int>(symmetry);
    double const a = 0.5, b = 0.55, t = 0.1, dt = 0.03;
    double const measure = (std::pow(b, n + 1) - std::pow(a, n + 1)) / (n + 1);
    GasConserved<> const before = m.average(a, b, t), after = m.average(a, b, t + dt);
    GasConserved<> const s = m.mean_source(a, b, t, dt);
    double mass_flux = 0, energy_flux = 0, momentum_flux = 0;
    for (std::size_t j = 0; j < gauss5_node.size(); ++j) {
      double const time = t + dt * gauss5_node[j], w = gauss5_weight[j] * dt;
      for (double side : {-1.0, 1.0}) {
        double const x = side < 0 ? a : b, area = side * std::pow(x, n);
        GasState<> const q = m.state(x, time);
        mass_flux += w * area * q.rho * q.u;
        momentum_flux += w * area * (q.rho * q.u * q.u + q.p);
        energy_flux += w * area * (q.rho * (law.energy(q.rho, q.p) + q.u * q.u / 2) + q.p) * q.u;
      }
      // pressure on the cone's side walls
      for (std::size_t i = 0; i < gauss5_node.size() && n > 0; ++i) {
        double const x = a + (b - a) * gauss5_node[i];
        momentum_flux -= w * gauss5_weight[i] * (b - a) * n * std::pow(x, n - 1) * m.state(x, time).p;
      }
    }
    CHECK(after.mass - before.mass + mass_flux / measure == Approx(dt * s.mass).epsilon(1e-10));
    CHECK(after.momentum - before.momentum + momentum_flux / measure == Approx(dt * s.momentum).epsilon(1e-10));
    CHECK(after.energy - before.energy + energy_flux / measure == Approx(dt * s.energy).epsilon(1e-10));
  }
}
