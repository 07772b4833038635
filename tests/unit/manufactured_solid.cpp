/// Manufactured sources of elastic solids against finite differences of the primitive equations and the integral
/// balance.
#include "verification/mms/manufactured_solid.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

// mm, us, g/cm^3, GPa
PeriodicSolid fields(double rho, double e) {
  return {.length = 2.5,
          .frequency = 0.4,
          .rho = rho,
          .density_wave = 0.07,
          .u = {0.3, -0.2, 0.1},
          .velocity_wave = 0.2,
          .e = e,
          .energy_wave = 0.4,
          .S = {2, -0.5, 0, 0.7, -0.6, 0.4},
          .stress_wave = 1.5};
}

template <class F>
double difference(F f, double h) {  // sixth order
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

/// Sources as the primitive equations have them: the bulk modulus and elastic_rate instead of fluxes of energy.
template <std::size_t D, class Law>
void check(Law law, PeriodicSolid const& flow) {
  double const mu = 27.6;
  ManufacturedSolid<D, PeriodicSolid, Law> const m(flow, law, mu);
  SolidMaterial const material{law, mu};
  INFO(D << " dimensions, law " << material.law.index());
  double const h = 4e-3;
  double largest[12] = {};  // that every source acts
  for (int sample = 0; sample < 40; ++sample) {
    // dense and without a pattern: multiples of irrational numbers
    Vector3 const x{std::fmod(sample * 0.7548776662, 1.0) * flow.length,
                    std::fmod(sample * 0.5698402910, 1.0) * flow.length,
                    std::fmod(sample * 0.3819660113, 1.0) * flow.length};
    double const t = 0.1 * sample;
    SolidPoint const q = m.state(x, t), rate = m.primitive_rate(x, t);
    auto d = [&](auto field, std::size_t axis) {
      return difference(
          [&](double s) {
            Vector3 y = x;
            if (axis < 3) y[axis] += s;
            return field(m.state(y, axis < 3 ? t : t + s));
          },
          h);
    };
    auto along = [&](auto field) {
      double sum = d(field, 3);
      for (std::size_t a = 0; a < D; ++a) sum += q.u[a] * d(field, a);
      return sum;
    };
    double L[3][3] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t a = 0; a < D; ++a) L[i][a] = d([i](SolidPoint const& s) { return s.u[i]; }, a);
    SolidPoint const solid = elastic_rate(material, q, L);
    // differences of sixth order: h^6 (2 pi/2.5)^7/140 = 1e-13 of moduli of 300, round-off 1e-15/h of the same
    double const tolerance = 1e-9;
    auto compare = [&](std::size_t k, double source, double expected) {
      INFO("component " << k);
      CHECK(std::fabs(source - expected) < tolerance);
      largest[k] = std::max(largest[k], std::fabs(source));
    };
    compare(0, rate.rho, along([](SolidPoint const& s) { return s.rho; }) - solid.rho);
    compare(1, rate.p, along([](SolidPoint const& s) { return s.p; }) - solid.p);
    compare(2, rate.e, along([](SolidPoint const& s) { return s.e; }) - solid.e);
    for (std::size_t i = 0; i < 3; ++i) {
      double force = 0;
      for (std::size_t a = 0; a < D; ++a) force += d([&](SolidPoint const& s) { return s.stress(i, a); }, a);
      compare(3 + i, rate.u[i], along([i](SolidPoint const& s) { return s.u[i]; }) - force / q.rho);
    }
    for (std::size_t c = 0; c < 6; ++c)
      compare(6 + c, rate.S[c], along([c](SolidPoint const& s) { return s.S[c]; }) - solid.S[c]);
    // the trace stays zero under the sources
    CHECK(std::fabs(q.S[0] + q.S[1] + q.S[2]) < 1e-14);
    CHECK(std::fabs(rate.S[0] + rate.S[1] + rate.S[2]) < 1e-11);
    // conserved sources from primitive ones
    SolidDensities const s = m.source(x, t);
    double energy = s.mass * (q.e + (q.u[0] * q.u[0] + q.u[1] * q.u[1] + q.u[2] * q.u[2]) / 2) + q.rho * rate.e;
    CHECK(s.mass == Approx(rate.rho).margin(1e-13));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(s.momentum[i] == Approx(q.rho * rate.u[i] + q.u[i] * s.mass).margin(1e-11));
      energy += q.rho * q.u[i] * rate.u[i];
    }
    CHECK(s.energy == Approx(energy).margin(1e-10));
    for (std::size_t c = 0; c < 6; ++c) CHECK(s.rho_S[c] == Approx(q.rho * rate.S[c] + q.S[c] * s.mass).margin(1e-11));
  }
  for (std::size_t k = 0; k < 12; ++k) CHECK(largest[k] > 0.01);
}

}  // namespace

TEST_CASE("manufactured sources of solids balance the equations", "[mms]") {
  LinearBulkLaw const linear{175, 7.8};
  MieGruneisenLaw const mie{2.785, 5.328, 1.338, 2};
  StiffenedLaw const stiffened{3.1, 20};
  check<1>(linear, fields(8, 1));
  check<2>(linear, fields(8, 1));
  check<3>(linear, fields(8, 1));
  check<1>(mie, fields(3.2, 2));
  check<2>(mie, fields(3.2, 2));
  check<3>(mie, fields(3.2, 2));
  check<2>(stiffened, fields(2.4, 15));
  check<3>(stiffened, fields(2.4, 15));
}

TEST_CASE("manufactured fields repeat after a period along every axis", "[mms]") {
  PeriodicSolid const flow = fields(8, 1);
  ManufacturedSolid<3, PeriodicSolid, LinearBulkLaw> const m(flow, LinearBulkLaw{175, 7.8}, 27.6);
  Vector3 const x{0.3, 0.8, -0.4};
  double const t = 0.37;
  SolidPoint const q = m.state(x, t);
  auto same = [&](SolidPoint const& s) {
    CHECK(s.rho == Approx(q.rho).epsilon(1e-13));
    CHECK(s.e == Approx(q.e).epsilon(1e-13));
    for (std::size_t i = 0; i < 3; ++i) CHECK(s.u[i] == Approx(q.u[i]).margin(1e-13));
    for (std::size_t c = 0; c < 6; ++c) CHECK(s.S[c] == Approx(q.S[c]).margin(1e-12));
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3 y = x;
    y[axis] += flow.length;
    same(m.state(y, t));
  }
  same(m.state(x, t + 1 / flow.frequency));
  // every component moves
  SolidPoint const later = m.state(x, t + 0.3 / flow.frequency);
  for (std::size_t c = 0; c < 6; ++c) CHECK(std::fabs(later.S[c] - q.S[c]) > 0.05);
}

// what a cell's balance over a step lacks, per unit of time, in a cell and step of `scale` times some size: change of
// the content, outflow and source each by its own quadrature
namespace {
double defect(double scale) {
  MieGruneisenLaw const law{2.785, 5.328, 1.338, 2};
  ManufacturedSolid<3, PeriodicSolid, MieGruneisenLaw> const m(fields(3.2, 2), law, 27.6);
  Vector3 const x{0.5, 0.1, -0.2}, h{0.05 * scale, 0.04 * scale, 0.06 * scale};
  double const t = 0.1 - 0.015 * scale, dt = 0.03 * scale;
  SolidDensities const before = m.average(x, h, t), after = m.average(x, h, t + dt), s = m.mean_source(x, h, t, dt);
  double mass = after.mass - before.mass - dt * s.mass, energy = after.energy - before.energy - dt * s.energy;
  Vector3 momentum;
  for (std::size_t i = 0; i < 3; ++i) momentum[i] = after.momentum[i] - before.momentum[i] - dt * s.momentum[i];
  auto const gauss = gauss_points(4);
  for (std::size_t a = 0; a < 3; ++a) {
    std::size_t const b = (a + 1) % 3, c = (a + 2) % 3;
    for (double const side : {-1.0, 1.0}) {
      for (int n = 0; n < 4 * 4 * 4; ++n) {
        auto const &gb = gauss[static_cast<std::size_t>(n % 4)], &gc = gauss[static_cast<std::size_t>(n / 4 % 4)],
                   &gt = gauss[static_cast<std::size_t>(n / 16)];
        Vector3 at = x;
        at[a] += side * h[a] / 2, at[b] += gb.x * h[b] / 2, at[c] += gc.x * h[c] / 2;
        SolidPoint const q = m.state(at, t + dt * (1 + gt.x) / 2);
        double const w = side * gb.weight * gc.weight * gt.weight / 8 * dt / h[a];
        SolidDensities const d = densities(q);
        mass += w * d.mass * q.u[a];
        energy += w * d.energy * q.u[a];
        for (std::size_t i = 0; i < 3; ++i) {
          momentum[i] += w * (d.momentum[i] * q.u[a] - q.stress(i, a));
          energy -= w * q.u[i] * q.stress(i, a);
        }
      }
    }
  }
  double sum = std::fabs(mass) + std::fabs(energy);
  for (double const& m_i : momentum) sum += std::fabs(m_i);
  return sum / dt;
}
}  // namespace

TEST_CASE("mean sources of solids integrate the balance over a cell and a step to fourth order", "[mms]") {
  // 2^4 = 16 a halving, and the terms of sixth order beside
  double const coarse = defect(1), fine = defect(0.5);
  CHECK(coarse / fine > 14);
  CHECK(coarse / fine < 18.5);
}
