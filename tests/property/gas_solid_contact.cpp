// Properties of the exact contact of a gas and a solid, over every equation of state.
#include <algorithm>
#include <cmath>
#include <random>

#include "riemann/contact/fixed_point.hpp"
#include "riemann/eos/registry.hpp"
#include "tests/catch.hpp"
#include "verification/exact/gas_riemann.hpp"
#include "verification/exact/numerics.hpp"

using namespace g27;

namespace {

// Parameters away from the defaults.
IdealGas other(IdealGas) { return {5.0 / 3.0}; }
StiffenedGas other(StiffenedGas) { return {7.15, 3e8}; }
Jwl other(Jwl) { return {3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630.0}; }
MieGruneisen other(MieGruneisen) { return {8930.0, 3940.0, 1.489, 1.99}; }

ExactEos law_of(IdealGas const& e) { return IdealLaw{e.gamma}; }
ExactEos law_of(StiffenedGas const& e) { return StiffenedLaw{e.gamma, e.p_inf}; }
ExactEos law_of(Jwl const& e) { return JwlLaw{e.A, e.B, e.R1, e.R2, e.omega, e.rho0}; }
ExactEos law_of(MieGruneisen const& e) { return MieGruneisenLaw{e.rho0, e.c0, e.s, e.Gamma0}; }

class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * unit_(random_); }
  double decades(double low, double high) { return low * std::pow(high / low, unit_(random_)); }
  GasState<> state(IdealGas const&) { return {decades(1e-2, 1e2), 0.0, decades(1e3, 1e8)}; }
  GasState<> state(StiffenedGas const& e) { return {decades(1e2, 2e3), 0.0, e.p_inf * decades(1e-2, 1e2)}; }
  GasState<> state(Jwl const& e) {
    double const rho = e.rho0 * decades(1e-3, 1.5);
    return {rho, 0.0, e.cold_pressure(rho) + decades(1e5, 1e11)};
  }
  GasState<> state(MieGruneisen const& e) {
    double const rho = e.rho0 * between(0.6, 1.6);
    return {rho, 0.0, e.cold_pressure(rho) + e.rho0 * e.c0 * e.c0 * decades(1e-3, 1.0)};
  }

 private:
  std::mt19937_64 random_{27};
  std::uniform_real_distribution<double> unit_;
};

template <class E>
struct Problem {
  E eos;
  GasState<> gas;
  double c, z;  ///< of the gas
  SolidTrace solid;
  [[nodiscard]] GasSolidContact solve() const { return gas_solid_contact(eos, gas, solid); }
};

/// Random problems from expansion to impact, six decades of impedance on both sides of the gas's, a third with a
/// plastic branch.
template <class F>
void over_problems(int count, F check) {
  EosList::for_each([&]<class E>() {
    Draw draw;
    for (int i = 0; i < count; ++i) {
      E const eos = i % 2 ? other(E{}) : E{};
      GasState<> gas = draw.state(eos);
      double const c = std::sqrt(eos.bulk_modulus(gas.rho, gas.p) / gas.rho), z = gas.rho * c;
      gas.u = c * draw.between(-2.0, 2.0);
      double const du = i % 5 == 0 ? 0.0 : c * draw.between(-3.0, 3.0);
      SolidTrace solid = elastic_trace(gas.u - du, gas.p, z * draw.decades(1e-6, 1e6));
      if (i % 3 == 0) {
        solid.yield_pressure = gas.p + z * c * draw.between(-0.2, 1.0);
        solid.plastic_impedance = solid.impedance * draw.between(0.05, 1.0);
      }
      INFO(E::name << " problem " << i);
      check(Problem<E>{eos, gas, c, z, solid});
    }
  });
}

}  // namespace

TEST_CASE("the closed bound of the velocity that a gas gains by expanding to a vacuum is below it", "[contact]") {
  // What saves the integral where a solid recedes. Round-off of the quadrature: 1e-12.
  Draw draw;
  EosList::for_each([&]<class E>() {
    for (int n = 0; n < 2000; ++n) {
      E const eos = n % 2 == 0 ? E{} : other(E{});
      WaveCurve<double, E> curve(eos, draw.state(eos));
      double const least = curve.escape_at_least(), all = curve.escape(true);
      INFO(E::name << ": " << least << " of " << all);
      CHECK(least >= 0);
      CHECK(least <= all * (1 + 1e-12));
    }
  });
}

TEST_CASE("the contact lies on the gas's wave curve and on the solid's line", "[riemann][contact]") {
  int vacua = 0;
  over_problems(600, [&](auto const& p) {
    GasSolidContact const r = p.solve();
    REQUIRE(r.converged);
    CHECK(r.contact.u == p.solid.velocity(r.contact.p));
    vacua += r.vacuum;
    if (r.vacuum) {
      CHECK(r.contact.p == p.eos.vacuum_pressure());
      CHECK(r.front <= r.contact.u);
      CHECK(r.rho == 0.0);
      return;
    }
    // the gas against its own image in a wall that moves with the contact: the general solver
    GasState<> const image{p.gas.rho, 2 * r.contact.u - p.gas.u, p.gas.p};
    RiemannStar<> const star = exact_star(p.eos, p.eos, p.gas, image, true);
    double const K = p.z * p.c;
    // both stop where the velocities fit to a part of those that meet; a soft solid's velocity is a difference of large
    // ones, known to the round-off of a pressure that is counted from the vacuum's
    double const counted = std::fabs(r.contact.p) + std::fabs(r.contact.p - p.eos.vacuum_pressure());
    double const soft = 1e-3 * counted * p.solid.compliance(r.contact.p);
    double const speeds = p.c + std::fabs(p.gas.u - p.solid.velocity(p.gas.p)) + soft;
    CHECK(r.contact.p == Approx(star.p).epsilon(1e-9).margin(1e-12 * p.z * speeds + 1e-11 * K));
    CHECK(r.rho == Approx(star.rho_l).epsilon(1e-9));
    if (std::fabs(r.contact.p - p.gas.p) > 1e-11 * K) CHECK(r.shock == (r.contact.p > p.gas.p));
    CHECK(r.front == r.contact.u);
  });
  CHECK(vacua > 20);
}

TEST_CASE("a state that fits the solid's stays", "[riemann][contact]") {
  over_problems(100, [](auto const& p) {
    SolidTrace const solid = elastic_trace(p.gas.u, p.gas.p, p.solid.impedance);
    GasSolidContact const r = gas_solid_contact(p.eos, p.gas, solid);
    REQUIRE(r.converged);
    CHECK(r.contact.p == Approx(p.gas.p).epsilon(1e-13).margin(1e-13 * p.z * p.c));
    CHECK(r.contact.u == Approx(p.gas.u).margin(1e-13 * p.c));
    CHECK(r.rho == Approx(p.gas.rho).epsilon(1e-12));
  });
}

TEST_CASE("the contact does not depend on the frame", "[riemann][contact]") {
  over_problems(200, [](auto p) {
    GasSolidContact const before = p.solve();
    double const frame = 0.7 * p.c;
    p.gas.u += frame, p.solid.free_velocity += frame;
    GasSolidContact const after = p.solve();
    double const K = p.z * p.c;
    CHECK(before.vacuum == after.vacuum);
    CHECK(after.contact.p == Approx(before.contact.p).epsilon(1e-9).margin(1e-11 * K));
    double const scale = p.c + std::fabs(p.gas.u - p.solid.velocity(p.gas.p)) + std::fabs(p.solid.free_velocity);
    CHECK(after.contact.u - frame == Approx(before.contact.u).margin(1e-11 * scale));
  });
}

TEST_CASE("great impedance is a rigid wall, and so is a heavy body", "[riemann][contact]") {
  over_problems(100, [](auto const& p) {
    double const wall = p.solid.velocity(p.gas.p);
    GasSolidContact const rigid = gas_wall_contact(p.eos, p.gas, wall);
    REQUIRE(rigid.converged);
    CHECK(rigid.contact.u == wall);
    GasSolidContact const heavy = gas_solid_contact(p.eos, p.gas, elastic_trace(wall, p.gas.p, 1e14 * p.z));
    GasSolidContact const body = gas_solid_contact(p.eos, p.gas, rigid_body_trace(wall, 1e10 * p.z, 1e-4));
    double const K = p.z * p.c;
    if (rigid.vacuum) return;  // where the gas hardly reaches the wall a little more is none
    CHECK(heavy.contact.p == Approx(rigid.contact.p).epsilon(1e-8).margin(1e-10 * K));
    CHECK(body.contact.p == Approx(rigid.contact.p).epsilon(1e-8).margin(1e-10 * K));
  });
}

TEST_CASE("small impedance is a free surface", "[riemann][contact]") {
  over_problems(100, [](auto const& p) {
    if (p.eos.vacuum_pressure() < 0) return;  // a liquid is held by its strength in tension
    double const light = 1e-9 * p.z;
    GasSolidContact const r = gas_solid_contact(p.eos, p.gas, {.free_velocity = p.gas.u, .impedance = light});
    REQUIRE(r.converged);
    CHECK(r.contact.p < 1e-6 * std::max(p.gas.p, p.z * p.c));
    CHECK(r.contact.p >= 0.0);
  });
}

TEST_CASE("a solid of the gas's own acoustics meets weak waves as the gas itself does", "[riemann][contact]") {
  over_problems(100, [](auto const& p) {
    double const du = 1e-5 * p.c;
    GasState<> const other{p.gas.rho, p.gas.u - du, p.gas.p};
    GasSolidContact const r = gas_solid_contact(p.eos, p.gas, elastic_trace(other.u, other.p, p.z));
    RiemannStar<> const star = exact_star(p.eos, p.eos, p.gas, other, true);
    // the line is the tangent of the wave curve: they part by the square of the strength
    CHECK(r.contact.u - p.gas.u == Approx(star.u - p.gas.u).margin(20 * 1e-5 * du));
    CHECK(r.contact.p - p.gas.p == Approx(star.p - p.gas.p).margin(20 * 1e-5 * p.z * du));
  });
}

TEST_CASE("an independent solution of the same contact", "[riemann][contact][oracle]") {
  over_problems(30, [](auto const& p) {
    GasSolidContact const r = p.solve();
    if (r.vacuum) return;
    ExactEos const law = law_of(p.eos);
    GasState<> const image{p.gas.rho, 2 * r.contact.u - p.gas.u, p.gas.p};
    GasRiemann const wall(law, p.gas, law, image);
    double const K = p.z * p.c;
    CHECK(wall.p_star() == Approx(r.contact.p).epsilon(1e-9).margin(1e-11 * K));
  });
}

TEST_CASE("a plastic branch softens the solid", "[riemann][contact]") {
  Draw draw;
  over_problems(100, [&](auto const& p) {
    SolidTrace elastic = p.solid;
    elastic.yield_pressure = std::numeric_limits<double>::infinity();
    GasSolidContact const hard = gas_solid_contact(p.eos, p.gas, elastic);
    if (hard.vacuum) return;
    SolidTrace soft = elastic;
    soft.yield_pressure = hard.contact.p - 0.5 * std::fabs(hard.contact.p - p.eos.vacuum_pressure());
    soft.plastic_impedance = 0.3 * elastic.impedance;
    GasSolidContact const yielding = gas_solid_contact(p.eos, p.gas, soft);
    REQUIRE(yielding.converged);
    CHECK(yielding.contact.p <= hard.contact.p * (1 + 1e-12) + 1e-12 * p.z * p.c);
    CHECK(yielding.contact.p >= soft.yield_pressure - 1e-10 * p.z * p.c);
    // above what is asked for, nothing changes
    soft.yield_pressure = hard.contact.p + 1e-3 * p.z * p.c;
    CHECK(gas_solid_contact(p.eos, p.gas, soft).contact.p ==
          Approx(hard.contact.p).epsilon(1e-11).margin(1e-12 * p.z * p.c));
  });
}

TEST_CASE("the fixed point finds the contact where the gas has the smaller impedance, and only there",
          "[riemann][contact]") {
  IdealGas const eos{};
  GasState<> const gas{1.0, 100.0, 1e5};
  double const z = std::sqrt(1.4e5);
  for (double const ratio : {1e-4, 0.1, 0.4}) {
    SolidTrace const solid = elastic_trace(0, 1e5, z / ratio);
    GasSolidContact const newton = gas_solid_contact(eos, gas, solid), fixed = fixed_point_contact(eos, gas, solid, 0);
    REQUIRE(fixed.converged);
    CHECK(fixed.contact.p == Approx(newton.contact.p).epsilon(1e-8));
    // the error shrinks by the ratio: that of the shocked gas is a little more
    double const expected = std::log(1e-10) / std::log(ratio);
    CHECK(fixed.iterations > 0.5 * expected);
    CHECK(fixed.iterations < 2.5 * expected + 2);
  }
  CHECK_FALSE(fixed_point_contact(eos, gas, elastic_trace(0, 1e5, 0.5 * z), 0).converged);
}

TEST_CASE("a rigid body between pushes gains what they give", "[riemann][contact]") {
  // v' = v + dt (P + F)/m is twice the velocity in the middle of the step, less that at its start
  double const v = 3, m = 5, dt = 0.1, F = -2, P = 7;
  SolidTrace const body = rigid_body_trace(v, m, dt, F);
  CHECK(2 * body.velocity(P) - v == Approx(v + dt * (P + F) / m).epsilon(1e-15));
}
