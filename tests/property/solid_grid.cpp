/// Properties of the solid scheme: eigensystem, symmetries, invariances, conservation, boundaries, elastic and plastic
/// waves.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "riemann/solid/tangent.hpp"
#include "tests/catch.hpp"
#include "tests/solid_waves.hpp"

using namespace g27;
using namespace g27_test;
using Kind = SolidBoundary::Kind;

namespace {

AnySolid steel() { return {.eos = BulkModulus{7800, 175e9}, .mu = 80.77e9}; }
AnySolid yielding_steel() { return {.eos = BulkModulus{7800, 175e9}, .mu = 80.77e9, .Y0 = 0.34e9, .H = 0.24e9}; }
AnySolid aluminium() { return {.eos = MieGruneisen{2785, 5328, 1.338, 2.0}, .mu = 27.6e9}; }

constexpr Sym3 stress{1.3e9, -0.5e9, -0.8e9, 0.7e9, -0.6e9, 0.4e9};

/// Components of a tensor in the frame of axis 1, as stored, to a matrix.
Matrix matrix(double const* S) { return tensor({S[0], S[1], S[2], S[3], S[4], S[5]}); }

FrozenSolid<double> frozen_state(Sym3 const& S) {
  FrozenSolid<double> q{8100, 190e9, 1.7, 3e9, {}, 80e9};
  std::copy(S.begin(), S.end(), q.S);
  return q;
}

/// Smooth motion in every field that is periodic in the unit box.
SolidPoint motion(AnySolid const& m, Vec3 const& x, double rho0, double amplitude) {
  double const a = std::sin(2 * M_PI * (x[0] + 0.2)), b = std::cos(2 * M_PI * (x[1] - x[0])),
               c = std::sin(2 * M_PI * (x[2] + x[1]) + 0.5);
  SolidPoint q{.rho = rho0 * (1 + amplitude * (0.3 * a + 0.2 * b * c)),
               .u = {6000 * amplitude * (b + 0.1), 5000 * amplitude * (c - 0.3 * a), 4000 * amplitude * a * c}};
  for (std::size_t k = 0; k < 6; ++k)
    q.S[k] = m.mu * amplitude * (k % 2 == 0 ? a : -b) * (0.5 + 0.1 * static_cast<double>(k));
  q.S[2] = -(q.S[0] + q.S[1]);
  q.p = 1e9 + 50e9 * amplitude * c;
  return q;
}

bool same_bits(SolidGrid const& a, SolidGrid const& b) {
  for (Field f : variables) {
    auto const x = a.field(f), y = b.field(f);
    if (std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0) return false;
  }
  return true;
}

double largest(std::vector<double> const& a, std::vector<double> const& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i]));
  return most;
}

}  // namespace

TEST_CASE("the families diagonalise M, as a dense eigenvalue problem does", "[riemann][solid]") {
  for (Sym3 const& S : {stress, Sym3{1e9, -0.5e9, -0.5e9, 0, 0, 0}, Sym3{-20e9, 12e9, 8e9, 9e9, -7e9, 11e9}, Sym3{}}) {
    FrozenSolid<double> const q = frozen_state(S);
    ElasticWaves<double> const w(q);
    Matrix const M = acoustic_matrix(matrix(q.S), q.K, q.f, q.mu);
    Matrix P, R;
    for (int k = 0; k < 3; ++k) {
      Vector const e = Vector::Unit(k);
      auto const p = w.project({{e(0), e(1), e(2)}}), r = w.unproject({{e(0), e(1), e(2)}});
      P.col(k) = Vector(p[0], p[1], p[2]), R.col(k) = Vector(r[0], r[1], r[2]);
    }
    Matrix const D = Vector(w.lambda[0], w.lambda[1], w.lambda[2]).asDiagonal();
    // a few operations on numbers of the size of K
    CHECK((P * M - D * P).cwiseAbs().maxCoeff() < 1e-14 * q.K);
    CHECK((P * R - Matrix::Identity()).cwiseAbs().maxCoeff() < 1e-15 * 8);
    Eigen::EigenSolver<Matrix> const dense(M);
    std::array<double, 3> a{w.lambda[0], w.lambda[1], w.lambda[2]};
    std::array<double, 3> b{dense.eigenvalues()(0).real(), dense.eigenvalues()(1).real(),
                            dense.eigenvalues()(2).real()};
    std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(a[k] == Approx(b[k]).epsilon(1e-13));
      CHECK(w.z[k] * w.z[k] == Approx(q.rho * w.lambda[k]).epsilon(1e-14));
      CHECK(w.inv_lambda[k] * w.lambda[k] == Approx(1.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("the tangent families diagonalise M_ep", "[riemann][solid]") {
  for (Sym3 const& S :
       {stress, Sym3{1e9, -0.5e9, -0.5e9, 0, 0, 0}, Sym3{0.02e9, 0.05e9, -0.07e9, 0.3e9, 0.2e9, -0.1e9}}) {
    FrozenSolid<double> const q = frozen_state(S);
    Strength const strength{.mu = q.mu, .Y0 = 1e9, .H = 2e9};
    TangentWaves<double> const w(q, strength);
    Vector const Sn(q.S[0], q.S[3], q.S[4]);
    double const kap = 3 * q.mu / (1.5 * (matrix(q.S).cwiseProduct(matrix(q.S))).sum() * (1 + strength.H / (3 * q.mu)));
    Matrix const M = acoustic_matrix(matrix(q.S), q.K, q.f, q.mu) - kap * Sn * Sn.transpose();
    Matrix P;
    for (int k = 0; k < 3; ++k) {
      Vector const e = Vector::Unit(k);
      auto const p = w.project({{e(0), e(1), e(2)}});
      P.col(k) = Vector(p[0], p[1], p[2]);
    }
    Matrix const D = Vector(w.lambda[0], w.lambda[1], w.lambda[2]).asDiagonal();
    // two corrections of the symmetric part leave (|S|/gap)^4, here |S|/K ~ 1e-2; and (1e-3 mu/gap)^2 of |S| where
    // values come close
    CHECK((P * M - D * P).cwiseAbs().maxCoeff() < 1e-6 * q.K);
  }
}

TEST_CASE("a uniform stressed state moves through without a trace", "[solid]") {
  for (AnySolid const& m : {steel(), aluminium()}) {
    for (Predictor p : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
      SolidGridSetup s = periodic_box(m, {9, 8, 7});
      s.options.predictor = p;
      SolidGrid g(s);
      SolidPoint const q{.rho = 3000, .u = {310, -200, 170}, .p = 5e9, .S = stress};
      g.set_state([&](Vec3 const&) { return q; });
      auto const before = g.field(Field::sxy), density = g.field(Field::density), speed = g.field(Field::velocity_z);
      for (int k = 0; k < 20; ++k) REQUIRE(g.step(1e9).status == StepStatus::ok);
      // every term is a difference of equal numbers
      CHECK(largest(g.field(Field::sxy), before) <= 1e-14 * 1e9);
      CHECK(largest(g.field(Field::density), density) <= 1e-14 * 3000);
      CHECK(largest(g.field(Field::velocity_z), speed) <= 1e-14 * 310);
    }
  }
}

TEST_CASE("results do not depend on threads nor on tiles", "[solid]") {
  for (AnySolid m : {yielding_steel(), aluminium()}) {
    for (Predictor p : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
      double const rho0 = m.plastic() ? 7800 : 2900;
      auto const make = [&](Int3 tile, int threads) {
        SolidGridSetup s = periodic_box(m, {20, 17, 18});
        s.sides[0] = {.kind = Kind::wall}, s.sides[1] = {.kind = Kind::free};
        s.sides[4] = {.kind = Kind::symmetry}, s.sides[5] = {.kind = Kind::outflow};
        s.options.predictor = p, s.options.tile = tile, s.options.threads = threads, s.options.cells_per_thread = 1;
        SolidGrid g(s);
        g.set_state([&](Vec3 const& x) { return motion(m, x, rho0, 0.01); }, 2);
        for (int k = 0; k < 6; ++k) REQUIRE(g.step(1e9).status == StepStatus::ok);
        if (m.plastic()) CHECK(g.counters().yielded > 100);
        return g;
      };
      SolidGrid const one = make({100, 100, 100}, 1);
      CHECK(same_bits(one, make({8, 5, 4}, 1)));
      CHECK(same_bits(one, make({4, 16, 7}, 2)));
    }
  }
}

TEST_CASE("a solution of one dimension is the same along every axis", "[solid]") {
  for (Predictor p : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
    std::array<std::vector<double>, 3> rho, shear, ep;
    AnySolid const m = yielding_steel();
    for (int axis = 0; axis < 3; ++axis) {
      Int3 cells{1, 1, 1};
      cells[static_cast<std::size_t>(axis)] = 40;
      SolidGridSetup s = periodic_box(m, cells);
      s.options.predictor = p;
      SolidGrid g(s);
      g.set_state([&](Vec3 const& x) {
        SolidPoint const q = motion(m, {x[static_cast<std::size_t>(axis)], 0.3, 0.6}, 7800, 0.01);
        SolidPoint r = q;
        for (int k = 0; k < 3; ++k) r.u[static_cast<std::size_t>((axis + k) % 3)] = q.u[static_cast<std::size_t>(k)];
        for (std::size_t k = 0; k < 6; ++k) r.S[static_cast<std::size_t>(frame_component(axis, k))] = q.S[k];
        return r;
      });
      for (int k = 0; k < 40; ++k) REQUIRE(g.step(1e9).status == StepStatus::ok);
      std::size_t const a = static_cast<std::size_t>(axis);
      rho[a] = g.field(Field::density), ep[a] = g.field(Field::plastic_strain);
      shear[a] = g.field(axis == 0 ? Field::sxy : axis == 1 ? Field::syz : Field::sxz);
    }
    for (std::size_t a : {1u, 2u}) {
      // the same operations but for the order of three sums: round-off, that forty steps of shocks amplify
      CHECK(largest(rho[a], rho[0]) < 1e-11 * 7800);
      CHECK(largest(shear[a], shear[0]) < 1e-11 * 80e9);
      CHECK(largest(ep[a], ep[0]) < 1e-10);
    }
    CHECK(*std::max_element(ep[0].begin(), ep[0].end()) > 1e-3);
  }
}

TEST_CASE("mirror images stay mirror images", "[solid]") {
  AnySolid const m = yielding_steel();
  for (Predictor p : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
    SolidGridSetup s = periodic_box(m, {24, 16, 1});
    s.options.predictor = p;
    auto const state = [&](Vec3 const& x) { return motion(m, {x[0], x[1], 0.2}, 7800, 0.01); };
    SolidGrid g(s), mirrored(s);
    g.set_state(state);
    mirrored.set_state([&](Vec3 const& x) {
      SolidPoint q = state({1 - x[0], x[1], 0});
      q.u[0] = -q.u[0], q.S[3] = -q.S[3], q.S[4] = -q.S[4];
      return q;
    });
    for (int k = 0; k < 20; ++k) g.step(1e9), mirrored.step(1e9);
    double worst = 0;
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 24; ++i) {
        SolidPoint const a = g.primitive({i, j, 0}), b = mirrored.primitive({23 - i, j, 0});
        worst = std::max({worst, std::fabs(a.rho - b.rho) / 7800, std::fabs(a.u[0] + b.u[0]) / 6000,
                          std::fabs(a.S[3] + b.S[3]) / m.mu, std::fabs(a.S[1] - b.S[1]) / m.mu});
      }
    }
    CHECK(worst < 1e-12);  // round-off of twenty steps
  }
}

TEST_CASE("the error does not grow with the speed of the whole", "[solid]") {
  // an accuracy, not an identity: the grid does not move along
  auto const error = [](double speed) {
    PlaneWave const w(steel(), {.rho = 7800, .u = {speed, 0, 0}}, Vector::UnitX(), 0);
    SolidGridSetup s = periodic_box(w.solid, {64, 1, 1});
    SolidGrid g(s), exact(s);
    double const A = 1e-3, T = 1 / w.speed;
    g.set_state([&](Vec3 const& x) { return w.state(A * std::sin(2 * M_PI * x[0])); });
    exact.set_state([&](Vec3 const& x) { return w.state(A * std::sin(2 * M_PI * (x[0] - w.total_speed() * T))); });
    run(g, T);
    return distance(g.field(Field::velocity_x), exact.field(Field::velocity_x)) / A;
  };
  // leading error of the linear predictor (Lax and Wendroff's): lambda (1 - nu^2) in a given time, nu = lambda dt/h
  PlaneWave const still(steel(), {.rho = 7800}, Vector::UnitX(), 0);
  auto const leading = [&](double speed) {
    double const lambda = still.speed + speed, nu = 0.8 * lambda / (still.speed + std::fabs(speed));
    return lambda * (1 - nu * nu);
  };
  double const rest = error(0);
  for (double speed : {600.0, -600.0}) {
    // the next term is O(h^2) of it, h = 1/64 of a wavelength; the last step is shorter than the others
    CHECK(error(speed) / rest == Approx(leading(speed) / leading(0)).epsilon(0.05));
  }
}

TEST_CASE("without shear modulus weak waves are those of the gas", "[solid]") {
  StiffenedGas const water{4.4, 6e8};
  double const rho0 = 1000, p0 = 1e7, c = std::sqrt(water.bulk_modulus(rho0, p0) / rho0), A = 1e-6 * c;
  double across = 0;
  auto const wave = [&](Vec3 const& x) {
    double const v = A * std::sin(2 * M_PI * (x[0] + across * x[1]));
    return GasPoint{rho0 * (1 + 1.4 * v / c), {20 + v, -10 + 0.5 * v, 0}, p0 + rho0 * c * v};
  };
  for (int dims : {1, 2}) {
    across = dims == 2 ? 1 : 0;
    Int3 const cells{32, dims == 2 ? 32 : 1, 1};
    SolidGridSetup s = periodic_box({.eos = water, .mu = 0}, cells);
    s.options.monotonicity = Switch::off;
    GasGridSetup t{.eos = water, .cells = cells};
    for (GridBoundary& b : t.sides) b.kind = GridBoundary::Kind::periodic;
    t.options.monotonicity = Switch::off;
    SolidGrid solid(s);
    GasGrid gas(t);
    solid.set_state([&](Vec3 const& x) {
      GasPoint const q = wave(x);
      return SolidPoint{.rho = q.rho, .u = q.u, .p = q.p};
    });
    gas.set_state(wave);
    double const t_end = 0.5 / c;
    run(solid, t_end);
    while (gas.time() < t_end) gas.step(t_end);
    // the two differ by products of the amplitude, 1e-6 of it, a step
    double const steps = static_cast<double>(solid.counters().steps);
    CHECK(largest(solid.field(Field::velocity_x), gas.field(GasGrid::Field::velocity_x)) < 1e-6 * steps * A);
    CHECK(largest(solid.field(Field::pressure), gas.field(GasGrid::Field::pressure)) < 1e-6 * steps * rho0 * c * A);
    CHECK(largest(solid.field(Field::density), gas.field(GasGrid::Field::density)) < 1e-6 * steps * rho0 * A / c);
    CHECK(largest(solid.field(Field::velocity_y), gas.field(GasGrid::Field::velocity_y)) < 1e-6 * steps * A);
  }
}

TEST_CASE("the ledger closes", "[solid]") {
  for (AnySolid const& m : {yielding_steel(), aluminium()}) {
    SolidGridSetup s{.material = m, .cells = {16, 12, 10}};
    s.sides = {SolidBoundary{.kind = Kind::wall, .normal_velocity = [](Vec3 const&, double) { return 30.0; }},
               SolidBoundary{.kind = Kind::free},
               SolidBoundary{.kind = Kind::fixed,
                             .velocity =
                                 [](Vec3 const&, double) {
                                   return Vec3{1, 2, 3};
                                 }},
               SolidBoundary{.kind = Kind::traction,
                             .traction =
                                 [](Vec3 const& x, double t) {
                                   return Vec3{1e8 * x[0], 3e8, 1e12 * t};
                                 }},
               SolidBoundary{.kind = Kind::symmetry},
               SolidBoundary{.kind = Kind::outflow}};
    SolidGrid g(s);
    g.set_state([&](Vec3 const& x) { return motion(m, x, m.plastic() ? 7800 : 2900, 0.005); });
    for (int k = 0; k < 30; ++k) REQUIRE(g.step(1e9).status == StepStatus::ok);
    SolidLedger const l = g.ledger();
    // sums of 2000 cells and 30 steps in double precision
    CHECK(std::fabs(l.mass.residual()) < 1e-13);
    CHECK(std::fabs(l.energy.residual()) < 1e-13);
    for (LedgerEntry const& e : l.momentum) CHECK(std::fabs(e.residual()) < 1e-13);
    CHECK((l.plastic_work > 0) == m.plastic());
  }
}

TEST_CASE("an elastic step has no overshoot", "[solid]") {
  for (bool shear : {false, true}) {
    for (auto [predictor, kind] : {std::pair{Predictor::linear, Switch::graded},
                                   {Predictor::linear, Switch::binary},
                                   {Predictor::parabolic, Switch::graded}}) {
      SolidGridSetup s{.material = steel(), .cells = {200, 1, 1}};
      s.options.predictor = predictor, s.options.monotonicity = kind;
      SolidGrid g(s);
      double const jump = 20;
      g.set_state([&](Vec3 const& x) {
        SolidPoint q{.rho = 7800};
        q.u[shear ? 1 : 0] = x[0] < 0.5 ? jump : 0.0;
        return q;
      });
      run(g, 0.35 / 6022);
      auto const u = g.field(shear ? Field::velocity_y : Field::velocity_x);
      CHECK(*std::max_element(u.begin(), u.end()) <= jump * (1 + 1e-3));
      CHECK(*std::min_element(u.begin(), u.end()) >= -1e-3 * jump);
      CHECK(u[100] == Approx(0.5 * jump).epsilon(1e-3));  // between the two waves
    }
  }
}

namespace {

/// Two shocks of a linear bulk modulus with linear hardening, from the jump conditions; logarithmic strain.
struct TwoWaves {
  double K, mu, Y0, H, rho0, rho1, s1, u1, D1, rho2, s2, D2;
  [[nodiscard]] double stress(double rho) const {
    double const e = std::log(rho / rho0), elastic = K * (rho / rho0 - 1);
    if (2 * mu * e <= Y0) return elastic + 4.0 / 3.0 * mu * e;
    double const ep = (4.0 / 3.0 * mu * e - 2.0 / 3.0 * Y0) / (2 * mu + 2.0 / 3.0 * H);
    return elastic + 2.0 / 3.0 * (Y0 + H * ep);
  }
  TwoWaves(double K_, double mu_, double Y, double hardening, double rho, double piston)
      : K(K_), mu(mu_), Y0(Y), H(hardening), rho0(rho) {
    rho1 = rho0 * std::exp(Y0 / (2 * mu)), s1 = stress(rho1), u1 = std::sqrt(s1 * (1 / rho0 - 1 / rho1));
    D1 = u1 / (1 - rho0 / rho1);
    double low = rho1, high = 1.5 * rho1;
    for (int k = 0; k < 200; ++k) {
      rho2 = 0.5 * (low + high), s2 = stress(rho2);
      (u1 + std::sqrt((s2 - s1) * (1 / rho1 - 1 / rho2)) < piston ? low : high) = rho2;
    }
    D2 = u1 + (s2 - s1) / (rho1 * (piston - u1));
  }
};

}  // namespace

TEST_CASE("an elastic-plastic piston reaches both plateaus", "[solid]") {
  double const piston = 50;
  AnySolid const m = yielding_steel();
  TwoWaves const w(175e9, m.mu, m.Y0, m.H, 7800, piston);
  for (Predictor p : {Predictor::linear, Predictor::parabolic}) {
    SolidGridSetup s{.material = m, .cells = {800, 1, 1}};
    s.sides[0] = {.kind = Kind::wall};
    s.options.predictor = p;
    SolidGrid g(s);
    g.set_state([&](Vec3 const&) { return SolidPoint{.rho = 7800, .u = {-piston, 0, 0}}; });
    double const t = 0.9 / w.D1;
    run(g, t);
    auto stress = g.field(Field::sxx);
    auto const pressure = g.field(Field::pressure), ep = g.field(Field::plastic_strain);
    for (std::size_t i = 0; i < stress.size(); ++i) stress[i] = pressure[i] - stress[i];
    auto const at = [&](double x) { return stress[static_cast<std::size_t>(x * 800)]; };
    auto const front = [&](double level) {  // where the stress falls through the level
      for (std::size_t i = stress.size() - 1; i > 0; --i) {
        if (stress[i - 1] >= level)
          return (static_cast<double>(i) - 0.5 + (stress[i - 1] - level) / (stress[i - 1] - stress[i])) / 800;
      }
      return 0.0;
    };
    double const x1 = (w.D1 - piston) * t, x2 = (w.D2 - piston) * t;
    double const D1 = front(0.5 * w.s1) / t + piston, D2 = front(0.5 * (w.s1 + w.s2)) / t + piston;
    INFO("plateaus " << at(0.5 * (x1 + x2)) << " " << at(0.5 * x2) << " exact " << w.s1 << " " << w.s2);
    INFO("fronts " << D1 << " " << D2 << " exact " << w.D1 << " " << w.D2 << " most "
                   << *std::max_element(stress.begin(), stress.end()));
    // the aims set for the scheme: 0.1 % and 0.3 %
    CHECK(at(0.5 * (x1 + x2)) == Approx(w.s1).epsilon(1e-3));
    CHECK(at(0.5 * x2) == Approx(w.s2).epsilon(1e-3));
    CHECK(D1 == Approx(w.D1).epsilon(3e-3));
    CHECK(D2 == Approx(w.D2).epsilon(3e-3));
    // but for the cells in which the shocks started at the wall
    CHECK(*std::max_element(stress.begin() + 20, stress.end()) <= w.s2 * (1 + 1e-3));
    CHECK(g.counters().tangent > 0);
  }
}
