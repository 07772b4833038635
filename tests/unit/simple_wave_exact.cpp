/// Isentropes and simple waves: closed forms against integrations, and the Euler equations themselves.
#include "tests/catch.hpp"
#include "verification/exact/simple_wave.hpp"

using namespace g27;

namespace {

struct Base {
  ExactEos eos;
  GasState<> state;
};
std::vector<Base> const bases{{IdealLaw{1.4}, {1.2, 30, 1e5}},        {StiffenedLaw{4.4, 6e8}, {1000, 0, 1e5}},
                              {JwlLaw{}, {1500, 100, 12e9}},          {JwlLaw{}, {3, 0, 3e6}},
                              {MieGruneisenLaw{}, {3000, 0, 1.2e10}}, {MieGruneisenLaw{}, {2750, -50, 1e8}}};

}  // namespace

TEST_CASE("closed isentropes agree with the first law", "[oracle]") {
  for (auto const& [eos, s] : bases) {
    INFO(eos_name(eos) << " rho " << s.rho);
    Isentrope const isentrope(eos, s.rho, s.p);
    for (double ratio : {0.5, 0.8, 1.1, 1.25}) {
      auto const point = integrate_isentrope(eos, s.rho, s.p, {ratio * s.rho}).front();
      // tolerance of the integration is 1e-13 a step
      CHECK(std::fabs(isentrope.pressure(point.rho) - point.p) <
            1e-11 * (std::fabs(point.p) + point.rho * point.c * point.c));
      CHECK(isentrope.sound_speed(point.rho) == Approx(point.c).epsilon(1e-10));
      CHECK(isentrope.invariant(point.rho) == Approx(point.invariant).epsilon(1e-11));
      CHECK(isentrope.density(isentrope.pressure(point.rho)) == Approx(point.rho).epsilon(1e-12));
      CHECK(isentrope.density_of_invariant(isentrope.invariant(point.rho)) == Approx(point.rho).epsilon(1e-12));
    }
  }
}

TEST_CASE("sound speeds are slopes of the isentrope", "[oracle]") {
  for (auto const& [eos, s] : bases) {
    INFO(eos_name(eos) << " rho " << s.rho);
    Isentrope const isentrope(eos, s.rho, s.p);
    double const h = 1e-4 * s.rho, c = sound_speed(eos, s.rho, s.p);
    double const slope = (8 * (isentrope.pressure(s.rho + h) - isentrope.pressure(s.rho - h)) -
                          (isentrope.pressure(s.rho + 2 * h) - isentrope.pressure(s.rho - 2 * h))) /
                         (12 * h);
    CHECK(slope == Approx(c * c).epsilon(1e-9));  // fourth order: h^4 = 1e-16, round-off 1e-12
  }
}

TEST_CASE("an expansion to vacuum ends at the limit of the invariant", "[oracle]") {
  for (auto const& [eos, s] : bases) {
    INFO(eos_name(eos) << " rho " << s.rho);
    Isentrope const isentrope(eos, s.rho, s.p);
    double last = 0;
    for (double ratio : {1e-1, 1e-3, 1e-6, 1e-9}) {
      double const w = isentrope.invariant(ratio * s.rho);
      CHECK(w <= last + 1e-12 * std::fabs(last));  // deep in tension nothing is left but round-off
      last = w;
      CHECK(w > isentrope.vacuum_invariant() * (1 + 1e-12));
    }
    // c ~ rho^(omega/2) at worst: (1e-9)^0.14 = 5 % is left
    CHECK(last == Approx(isentrope.vacuum_invariant()).epsilon(0.2));
  }
}

TEST_CASE("a simple wave of an ideal gas is that of the textbook", "[oracle]") {
  // Landau and Lifshitz (101.5): c = c0 + (gamma - 1)/2 w, x = foot + (u + c) t
  double const gamma = 1.4, c0 = std::sqrt(gamma * 1e5 / 1.2);
  auto w = [](double x) { return 20 * std::sin(2 * M_PI * x); };
  SimpleWave const wave(IdealLaw{gamma}, {1.2, 30, 1e5}, w, 20);
  double const t = 0.7 * wave.breaking_time(0, 1);
  CHECK(wave.breaking_time(0, 1) == Approx(1 / ((gamma + 1) / 2 * 20 * 2 * M_PI)).epsilon(1e-6));
  for (double foot = 0; foot < 1; foot += 0.09) {
    double const c = c0 + (gamma - 1) / 2 * w(foot), x = foot + (30 + w(foot) + c) * t;
    GasState<> const s = wave.at(x, t);
    CHECK(s.u == Approx(30 + w(foot)).epsilon(1e-12));
    CHECK(s.rho == Approx(1.2 * std::pow(c / c0, 2 / (gamma - 1))).epsilon(1e-12));
    CHECK(s.p == Approx(1e5 * std::pow(c / c0, 2 * gamma / (gamma - 1))).epsilon(1e-12));
  }
}

TEST_CASE("a simple wave satisfies the Euler equations", "[oracle]") {
  for (Running running : {Running::right, Running::left}) {
    for (auto const& [eos, s] : bases) {
      INFO(eos_name(eos) << " rho " << s.rho << (running == Running::right ? " right" : " left"));
      double const c = sound_speed(eos, s.rho, s.p), amplitude = 0.02 * c;
      SimpleWave const wave(
          eos, s, [&](double x) { return amplitude * std::sin(2 * M_PI * x); }, amplitude, running);
      double const t = 0.5 * wave.breaking_time(0, 1), h = 1e-3, dt = h / c;
      // fourth-order differences of the conserved variables and their fluxes: (2 pi h)^4 = 1.6e-9, times the steepening
      for (double x : {0.1, 0.37, 0.82}) {
        auto pair = [&](double xx, double tt) {
          GasState<> const q = wave.at(xx, tt);
          double const total = q.rho * (energy(eos, q.rho, q.p) + q.u * q.u / 2);
          return std::array<double, 6>{
              q.rho, q.rho * q.u, total, q.rho * q.u, q.rho * q.u * q.u + q.p, (total + q.p) * q.u};
        };
        auto const tp = pair(x, t + dt), tm = pair(x, t - dt), tpp = pair(x, t + 2 * dt), tmm = pair(x, t - 2 * dt);
        auto const xp = pair(x + h, t), xm = pair(x - h, t), xpp = pair(x + 2 * h, t), xmm = pair(x - 2 * h, t);
        for (std::size_t k = 0; k < 3; ++k) {
          double const rate = (8 * (tp[k] - tm[k]) - (tpp[k] - tmm[k])) / (12 * dt);
          double const flux = (8 * (xp[k + 3] - xm[k + 3]) - (xpp[k + 3] - xmm[k + 3])) / (12 * h);
          double const scale = std::fabs(rate) + std::fabs(flux) + 0.01 * std::fabs(pair(x, t)[k]) * c;
          CHECK(std::fabs(rate + flux) < 2e-6 * scale);
        }
      }
    }
  }
}
