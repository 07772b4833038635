/// Properties of two solids bonded end to end: the linear Riemann problem, rest, symmetry, conservation, agreement with
/// one line where both are one material.
#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "fsi/line/solid_solid_line.hpp"
#include "tests/catch.hpp"
#include "verification/exact/elastic_families.hpp"

using namespace g27;
using Kind = SolidBoundary::Kind;

namespace {

constexpr Predictor predictors[]{Predictor::godunov, Predictor::linear, Predictor::parabolic};

/// A material as the scheme and as the exact solutions know it, with a state of it.
struct Solid {
  AnySolid scheme;
  SolidMaterial exact;
  SolidPoint state;
};

class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * unit_(random_); }
  /// Moduli and densities over two decades, a deviator up to a tenth of mu.
  Solid solid(int law) {
    double const rho0 = 1000 * std::pow(20.0, between(0, 1)), c = between(1000, 6000), K = rho0 * c * c;
    double const mu = K * between(0.1, 0.9), Gamma = between(0.5, 2);
    Solid s;
    s.scheme.mu = s.exact.mu = mu;
    s.state.rho = rho0 * between(0.95, 1.05);
    if (law == 0) {
      s.scheme.eos = BulkModulus{rho0, K}, s.exact.law = LinearBulkLaw{K, rho0};
      s.state.p = pressure(s.exact.law, s.state.rho, 0);
    } else {
      s.scheme.eos = MieGruneisen{rho0, c, 1.4, Gamma}, s.exact.law = MieGruneisenLaw{rho0, c, 1.4, Gamma};
      s.state.p = pressure(s.exact.law, s.state.rho, 0) + K * between(0, 0.05);
    }
    s.state.e = energy(s.exact.law, s.state.rho, s.state.p);
    for (double& u : s.state.u) u = c * between(-0.1, 0.1);
    for (double& S : s.state.S) S = mu * between(-0.1, 0.1);
    s.state.S[2] = -s.state.S[0] - s.state.S[1];
    return s;
  }

 private:
  std::mt19937_64 random_{27};
  std::uniform_real_distribution<double> unit_;
};

std::vector<double> equal_faces(double x0, double x1, int n) {
  std::vector<double> x;
  for (int f = 0; f <= n; ++f) x.push_back(x0 + (x1 - x0) * f / n);
  return x;
}

SolidSolidLine bonded(AnySolid const& l, AnySolid const& r, int n_l, int n_r, SolidSchemeOptions const& options = {},
                      SolidBoundary const& low = {.kind = Kind::free},
                      SolidBoundary const& high = {.kind = Kind::free}) {
  SolidBoundary const contact{.kind = Kind::contact};
  return {{.material = l, .faces = equal_faces(-1, 0, n_l), .left = low, .right = contact, .options = options},
          {.material = r, .faces = equal_faces(0, 1, n_r), .left = contact, .right = high, .options = options}};
}

SolidBoundary held(SolidPoint const& s) {
  return {.kind = Kind::traction, .traction = [=](Vec3 const&, double) {
            return Vec3{s.stress(0, 0), s.stress(0, 1), s.stress(0, 2)};
          }};
}

Eigen::Matrix3d impedance(ElasticFamilies const& w) {
  Eigen::Matrix3d R, Z = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    auto const f = static_cast<std::size_t>(k);
    for (int i = 0; i < 3; ++i) R(i, k) = w.vectors()[f][static_cast<std::size_t>(i)];
    Z(k, k) = w.base().rho * w.speeds()[f];
  }
  return R * Z * R.inverse();
}
Eigen::Vector3d velocity(SolidPoint const& s) { return {s.u[0], s.u[1], s.u[2]}; }
Eigen::Vector3d traction(SolidPoint const& s) { return {s.stress(0, 0), s.stress(0, 1), s.stress(0, 2)}; }

void run(SolidSolidLine& line, double t_end) {
  while (line.time() < t_end) REQUIRE(line.step(t_end).status == StepStatus::ok);
}

}  // namespace

TEST_CASE("the bonded face is the linear Riemann problem of both solids, each with its own families",
          "[fsi][contact]") {
  Draw draw;
  for (int i = 0; i < 300; ++i) {
    INFO("pair " << i);
    Solid const l = draw.solid(i % 2), r = draw.solid(i / 2 % 2);
    SolidSolidLine line = bonded(l.scheme, r.scheme, 4, 6, {.predictor = predictors[i % 3]});
    line.left().set_state([&](double) { return l.state; });
    line.right().set_state([&](double) { return r.state; });
    double const dt = 1e-9;
    REQUIRE(line.step(dt).status == StepStatus::ok);
    Eigen::Matrix3d const Z_l = impedance(ElasticFamilies(l.exact, l.state)),
                          Z_r = impedance(ElasticFamilies(r.exact, r.state));
    // s - s_l = Z_l (u - u_l), s - s_r = -Z_r (u - u_r)
    Eigen::Vector3d const u = (Z_l + Z_r).lu().solve(Z_l * velocity(l.state) + Z_r * velocity(r.state) +
                                                     traction(r.state) - traction(l.state));
    Eigen::Vector3d const s = traction(l.state) + Z_l * (u - velocity(l.state));
    // round-off of the energy and of the pressure that is made of it, over the least impedance
    double const modulus = Z_l.norm() + Z_r.norm(), stress = s.norm() + traction(l.state).norm() + modulus * u.norm();
    for (int k = 0; k < 3; ++k) {
      auto const c = static_cast<std::size_t>(k);
      CHECK(line.contact().u[c] == Approx(u[k]).margin(1e-11 * stress / std::fmin(Z_l.norm(), Z_r.norm())));
      CHECK(line.contact().s[c] == Approx(s[k]).margin(1e-11 * stress));
    }
    // both sides took it
    CHECK(line.left().face_speeds().back() == line.contact().u[0]);
    CHECK(line.right().face_speeds().front() == line.contact().u[0]);
    CHECK(line.left().faces().back() == line.right().faces().front());
  }
}

TEST_CASE("two solids of one velocity and one traction move on as they are", "[fsi][contact]") {
  Draw draw;
  for (Predictor p : predictors) {
    for (int i = 0; i < 10; ++i) {
      Solid const l = draw.solid(i % 2);
      Solid r = draw.solid(1);
      // the traction of the left one
      r.state.u = l.state.u;
      r.state.S[3] = l.state.S[3], r.state.S[4] = l.state.S[4];
      r.state.p = r.state.S[0] - l.state.stress(0, 0);
      r.state.e = energy(r.exact.law, r.state.rho, r.state.p);
      SolidSolidLine line = bonded(l.scheme, r.scheme, 20, 16, {.predictor = p}, held(l.state), held(r.state));
      line.left().set_state([&](double) { return l.state; });
      line.right().set_state([&](double) { return r.state; });
      for (int n = 0; n < 30; ++n) REQUIRE(line.step(1).status == StepStatus::ok);
      double const c_l = ElasticFamilies(l.exact, l.state).speeds()[0];
      double const c_r = ElasticFamilies(r.exact, r.state).speeds()[0], c = std::fmax(c_l, c_r);
      double const ratio =
          std::fmax(l.state.rho * c_l, r.state.rho * c_r) / std::fmin(l.state.rho * c_l, r.state.rho * c_r);
      for (std::size_t k = 0; k < 3; ++k) {
        // the round-off of positions and energies, in the solid of less impedance
        CHECK(line.contact().u[k] == Approx(l.state.u[k]).margin(1e-11 * c * ratio));
        for (std::size_t j = 0; j < 16; ++j) {
          CHECK(line.right().primitive(j).u[k] == Approx(l.state.u[k]).margin(1e-11 * c * ratio));
        }
      }
    }
  }
}

TEST_CASE("bonded solids have no handedness", "[fsi][contact]") {
  Draw draw;
  Solid l = draw.solid(0), r = draw.solid(1);
  l.scheme.Y0 = 0.02 * l.scheme.mu, r.scheme.Y0 = 0.02 * r.scheme.mu;
  l.state.S = r.state.S = {};
  auto const mirrored = [](SolidPoint s) {
    s.u[0] = -s.u[0], s.S[3] = -s.S[3], s.S[4] = -s.S[4];
    return s;
  };
  for (Predictor p : predictors) {
    SolidSolidLine a = bonded(l.scheme, r.scheme, 20, 30, {.predictor = p});
    SolidSolidLine b = bonded(r.scheme, l.scheme, 30, 20, {.predictor = p});
    a.left().set_state([&](double) { return l.state; }), a.right().set_state([&](double) { return r.state; });
    b.left().set_state([&](double) { return mirrored(r.state); });
    b.right().set_state([&](double) { return mirrored(l.state); });
    for (int n = 0; n < 40; ++n) {
      REQUIRE(a.step(1).status == StepStatus::ok);
      REQUIRE(b.step(1).status == StepStatus::ok);
    }
    CHECK(a.left().counters().yielded > 0);
    CHECK(a.right().counters().yielded > 0);
    double const c = 6000;
    CHECK(a.position() == Approx(-b.position()).margin(1e-13));
    for (std::size_t i = 0; i < 20; ++i) {
      SolidPoint const s = a.left().primitive(i), m = mirrored(b.right().primitive(19 - i));
      for (std::size_t k = 0; k < 3; ++k) CHECK(s.u[k] == Approx(m.u[k]).margin(1e-11 * c));
    }
  }
}

TEST_CASE("momentum and energy of two bonded solids change at their outer ends alone", "[fsi][contact]") {
  AnySolid const steel{.eos = BulkModulus{7800, 175e9}, .mu = 80.77e9, .Y0 = 0.34e9, .H = 0.24e9};
  AnySolid const aluminium{.eos = MieGruneisen{2785, 5328, 1.338, 2.0}, .mu = 27.6e9, .Y0 = 0.3e9};
  for (Predictor p : predictors) {
    SolidSolidLine line = bonded(steel, aluminium, 40, 50, {.predictor = p});
    line.left().set_state([](double) { return SolidPoint{.rho = 7800, .u = {300, 40, -20}}; });
    line.right().set_state([](double) { return SolidPoint{.rho = 2785}; });
    run(line, 1e-4);
    SolidLedger const l = line.left().ledger(), r = line.right().ledger();
    auto const gap = [](LedgerEntry const& a, LedgerEntry const& b) {
      return std::fabs(a.current + b.current - a.initial - b.initial) / (a.scale + b.scale);
    };
    // the outer ends are free: nothing is lost at all; shear is carried over
    for (std::size_t k = 0; k < 3; ++k) CHECK(gap(l.momentum[k], r.momentum[k]) < 1e-14);
    CHECK(gap(l.energy, r.energy) < 1e-14);
    CHECK(r.momentum[1].current > 0.01 * l.momentum[1].initial);
    CHECK(line.left().counters().yielded > 0);
    CHECK(line.right().counters().yielded > 0);
  }
}

TEST_CASE("of one material the bonded pair is one line, up to the truncation of its traces", "[fsi][contact]") {
  AnySolid const steel{.eos = BulkModulus{7800, 175e9}, .mu = 80.77e9};
  double const c = std::sqrt((175e9 + 4.0 / 3 * 80.77e9) / 7800);
  auto const gap = [&](Predictor p, int n, double a) {
    auto const state = [=](double x) {
      double const f = a * std::exp(-30 * (x + 0.35) * (x + 0.35));
      return SolidPoint{.rho = 7800 * (1 + f), .u = {c * f, 0.7 * c * f, 0}};
    };
    SolidSchemeOptions const options{.predictor = p, .monotonicity = Switch::off};
    SolidSolidLine pair = bonded(steel, steel, n, n, options);
    pair.left().set_state(state, 5), pair.right().set_state(state, 5);
    SolidLine line({.material = steel, .faces = equal_faces(-1, 1, 2 * n), .options = options});
    line.set_state(state, 5);
    double const t_end = 0.5 / c;
    run(pair, t_end);
    while (line.time() < t_end) REQUIRE(line.step(t_end).status == StepStatus::ok);
    double sum = 0;
    for (std::size_t i = 0; i < line.cells(); ++i) {
      auto const m = static_cast<std::size_t>(n);
      SolidPoint const s = i < m ? pair.left().primitive(i) : pair.right().primitive(i - m), o = line.primitive(i);
      for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(s.u[k] - o.u[k]) / (a * c * n);
    }
    return sum;
  };
  // Godunov's traces are the same: the round-off of positions, 1e-16/h, over the amplitude
  CHECK(gap(Predictor::godunov, 50, 1e-6) < 1e-8);
  // traces from one side and across the face differ in second order of the width, in the cells beside it
  for (Predictor p : {Predictor::linear, Predictor::parabolic}) {
    double const order = std::log2(gap(p, 50, 1e-6) / gap(p, 100, 1e-6));
    CHECK(order > 2.6);
    CHECK(order < 3.2);
  }
}

TEST_CASE("pairs that make no sense are refused", "[fsi][contact]") {
  AnySolid const steel{.eos = BulkModulus{7800, 175e9}};
  AnySolid fluid = steel;
  fluid.mu = 0;
  SolidBoundary const contact{.kind = Kind::contact};
  SolidLineSetup const l{.material = steel, .faces = equal_faces(-1, 0, 4), .right = contact};
  SolidLineSetup const r{.material = steel, .faces = equal_faces(0, 1, 4), .left = contact};
  SolidLineSetup apart = r, loose = l, curved = r, chained = r, wet_l = l, wet_r = r;
  apart.faces = equal_faces(0.1, 1, 4), loose.right = {.kind = Kind::free};
  curved.symmetry = Symmetry::cylindrical, chained.right = contact;
  wet_l.material = wet_r.material = fluid;
  CHECK_NOTHROW(SolidSolidLine(l, r));
  CHECK_NOTHROW(SolidSolidLine(wet_l, r));
  CHECK_THROWS_AS(SolidSolidLine(l, apart), std::invalid_argument);
  CHECK_THROWS_AS(SolidSolidLine(loose, r), std::invalid_argument);
  CHECK_THROWS_AS(SolidSolidLine(l, curved), std::invalid_argument);
  CHECK_THROWS_AS(SolidSolidLine(l, chained), std::invalid_argument);
  CHECK_THROWS_AS(SolidSolidLine(wet_l, wet_r), std::invalid_argument);
}
