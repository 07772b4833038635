/// Manufactured sources in two and three dimensions against finite differences and the integral balance.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/eos.hpp"
#include "verification/mms/manufactured_nd.hpp"

using namespace g27;

namespace {

/// Fields around a base state, away from symmetric points.
struct Fields {
  double rho0, u0, p0;
  template <class T>
  FlowOf<T> operator()(std::array<T, 3> const& x, T const& t) const {
    using std::cos, std::exp, std::sin;
    return {rho0 * (1.0 + 0.1 * sin(2.0 * x[0] + 0.3 - 2.0 * t + 1.5 * x[1] - x[2])),
            {u0 * (1.0 + 0.2 * cos(1.5 * x[0] - x[1] + t + 0.5 * x[2])), u0 * (0.4 - 0.3 * sin(x[0] * x[1] + t - x[2])),
             u0 * 0.5 * cos(x[0] - 2.0 * x[1] + 1.2 * x[2] - t)},
            p0 * (1.0 + 0.15 * exp(-1.0 * x[0] * x[0]) * sin(t + 0.7 + x[1] + 0.8 * x[2]))};
  }
};

template <class F>
double difference(F f, double h) {  // fourth order
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

template <std::size_t D, class Law>
void check(Law law, Fields const& fields) {
  ManufacturedNd<D, Fields, Law> const m(fields, law);
  INFO(eos_name(law) << " in " << D << " dimensions");
  Vec3 const x{0.6, -0.3, D > 2 ? 0.4 : 0.0};
  double const t = 0.2, h = 1e-3;
  GasPoint const q = m.state(x, t), rate = m.primitive_rate(x, t);
  auto d = [&](auto field, std::size_t axis) {
    return difference(
        [&](double s) {
          Vec3 y = x;
          if (axis < 3) y[axis] += s;
          return field(m.state(y, axis < 3 ? t : t + s));
        },
        h);
  };
  auto material = [&](auto field) {
    double sum = d(field, 3);
    for (std::size_t a = 0; a < D; ++a) sum += q.u[a] * d(field, a);
    return sum;
  };
  auto rho = [](GasPoint const& s) { return s.rho; };
  auto p = [](GasPoint const& s) { return s.p; };
  auto u = [](std::size_t k) { return [k](GasPoint const& s) { return s.u[k]; }; };
  double divergence = 0;
  for (std::size_t a = 0; a < D; ++a) divergence += d(u(a), a);
  double const K = law.bulk_modulus(q.rho, q.p), u0 = fields.u0, tolerance = 1e-9;  // h^4 times fifth derivatives
  CHECK(std::fabs(rate.rho - (material(rho) + q.rho * divergence)) < tolerance * q.rho * (1 + u0));
  CHECK(std::fabs(rate.p - (material(p) + K * divergence)) < tolerance * K * (1 + u0));
  for (std::size_t k = 0; k < 3; ++k) {
    double const slope = k < D ? d(p, k) / q.rho : 0;
    CHECK(std::fabs(rate.u[k] - (material(u(k)) + slope)) < tolerance * (u0 * (1 + u0) + K / q.rho));
  }
  // conserved form: S = U_t + div F
  auto mass_flux = [](std::size_t a) { return [a](GasPoint const& s) { return s.rho * s.u[a]; }; };
  auto energy = [&](GasPoint const& s) {
    return s.rho * (law.energy(s.rho, s.p) + (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]) / 2);
  };
  GasDensities const source = m.source(x, t);
  double mass = d(rho, 3), total = d(energy, 3);
  for (std::size_t a = 0; a < D; ++a) {
    mass += d(mass_flux(a), a);
    total += d([&](GasPoint const& s) { return (energy(s) + s.p) * s.u[a]; }, a);
  }
  CHECK(std::fabs(source.mass - mass) < tolerance * q.rho * (1 + u0));
  CHECK(std::fabs(source.energy - total) < tolerance * (std::fabs(energy(q)) + K) * (1 + u0));
  for (std::size_t k = 0; k < 3; ++k) {
    double momentum = d([&](GasPoint const& s) { return s.rho * s.u[k]; }, 3) + (k < D ? d(p, k) : 0);
    for (std::size_t a = 0; a < D; ++a) momentum += d([&](GasPoint const& s) { return s.rho * s.u[k] * s.u[a]; }, a);
    CHECK(std::fabs(source.momentum[k] - momentum) < tolerance * (q.rho * u0 * (1 + u0) + K));
  }
}

}  // namespace

TEST_CASE("manufactured sources in space balance the equations", "[mms]") {
  JwlLaw const jwl{.A = 7.1, .B = .13, .R1 = 4.9, .R2 = 1.3, .omega = .28, .rho0 = 1.65};
  check<2>(IdealLaw{1.3}, {1.1, 0.8, 1.7});
  check<3>(IdealLaw{1.3}, {1.1, 0.8, 1.7});
  check<2>(jwl, {1.5, 0.9, 0.9});
  check<3>(jwl, {1.5, 0.9, 0.9});
  check<3>(StiffenedLaw{3.1, 5}, {2.0, 0.4, 1.2});
  check<3>(MieGruneisenLaw{.rho0 = 2.7, .c0 = 5.3, .s = 1.34, .Gamma0 = 2}, {3.2, 0.5, 20});
}

namespace {

/// Change of a cell's content over a step plus its outflow, each by its own quadrature, less the source: per time.
double defect(double scale) {
  IdealLaw const law{1.4};
  ManufacturedNd<3, Fields, IdealLaw> const m({1.1, 0.8, 1.7}, law);
  Vec3 const x{0.5, 0.1, -0.2}, h{0.05 * scale, 0.04 * scale, 0.06 * scale};
  double const t = 0.1 - 0.015 * scale, dt = 0.03 * scale;
  GasDensities const before = m.average(x, h, t), after = m.average(x, h, t + dt), s = m.mean_source(x, h, t, dt);
  GasDensities out{};
  auto const gauss = gauss_points(4);
  for (std::size_t a = 0; a < 3; ++a) {
    std::size_t const b = (a + 1) % 3, c = (a + 2) % 3;
    for (double const side : {-1.0, 1.0}) {
      for (int n = 0; n < 4 * 4 * 4; ++n) {
        auto const &gb = gauss[static_cast<std::size_t>(n % 4)], &gc = gauss[static_cast<std::size_t>(n / 4 % 4)],
                   &gt = gauss[static_cast<std::size_t>(n / 16)];
        Vec3 at = x;
        at[a] += side * h[a] / 2, at[b] += gb.x * h[b] / 2, at[c] += gc.x * h[c] / 2;
        GasPoint const q = m.state(at, t + dt * (1 + gt.x) / 2);
        double const w = side * gb.weight * gc.weight * gt.weight / 8 * dt / h[a];
        double const kinetic = (q.u[0] * q.u[0] + q.u[1] * q.u[1] + q.u[2] * q.u[2]) / 2;
        out.mass += w * q.rho * q.u[a];
        for (std::size_t k = 0; k < 3; ++k) out.momentum[k] += w * (q.rho * q.u[k] * q.u[a] + (k == a ? q.p : 0));
        out.energy += w * (q.rho * (law.energy(q.rho, q.p) + kinetic) + q.p) * q.u[a];
      }
    }
  }
  double sum = std::fabs(after.mass - before.mass + out.mass - dt * s.mass) +
               std::fabs(after.energy - before.energy + out.energy - dt * s.energy);
  for (std::size_t k = 0; k < 3; ++k) {
    sum += std::fabs(after.momentum[k] - before.momentum[k] + out.momentum[k] - dt * s.momentum[k]);
  }
  return sum / dt;
}

}  // namespace

TEST_CASE("mean sources in space integrate the balance over a cell and a step to fourth order", "[mms]") {
  double const coarse = defect(2), fine = defect(1);
  INFO(coarse << " " << fine);
  // fourth derivatives of order ten on widths of 0.05: the defect is h^4 times that, over about a thousand
  CHECK(fine < 1e-5);
  // halving every width and the step divides it by 16; the next term of the series is some per cent of it
  CHECK(coarse / fine > 14);
  CHECK(coarse / fine < 18);
}
