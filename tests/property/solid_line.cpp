/// Properties of solids on cells that move with the material: invariances, equilibrium, conservation, order, agreement
/// with the fixed grid.
#include <algorithm>
#include <cmath>

#include "scheme/step/solid_line.hpp"
#include "tests/catch.hpp"

using namespace g27;
using Kind = SolidBoundary::Kind;
using Field = SolidGrid::Field;

namespace {

constexpr Predictor predictors[]{Predictor::godunov, Predictor::linear, Predictor::parabolic};

AnySolid aluminium(bool plastic) {
  AnySolid m{.eos = MieGruneisen{2785, 5328, 1.338, 2.0}, .mu = 27.6e9};
  if (plastic) m.Y0 = 0.3e9, m.H = 0.2e9;
  return m;
}
double longitudinal_speed(AnySolid const& m) { return std::sqrt((2785.0 * 5328 * 5328 + 4.0 / 3.0 * m.mu) / 2785); }

/// Faces of cells whose widths vary smoothly by a third.
std::vector<double> graded(double x0, double x1, int n) {
  std::vector<double> x;
  for (int f = 0; f <= n; ++f) {
    double const s = static_cast<double>(f) / n;
    x.push_back(x0 + (x1 - x0) * (s + 0.05 * std::sin(2 * M_PI * s)));
  }
  x.front() = x0, x.back() = x1;
  return x;
}

SolidBoundary held(Vec3 const& traction) {
  return {.kind = Kind::traction, .traction = [=](Vec3 const&, double) { return traction; }};
}

void run(SolidLine& line, double t_end) {
  while (line.time() < t_end) REQUIRE(line.step(t_end).status == StepStatus::ok);
}

/// Means over the masses of pairs of cells.
std::vector<double> coarsened(SolidLine const& fine, int component) {
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < fine.cells(); k += 2) {
    double momentum = 0, mass = 0;
    for (std::size_t i : {k, k + 1}) {
      SolidDensities const q = fine.average(i);
      momentum += fine.measure(i) * q.momentum[static_cast<std::size_t>(component)], mass += fine.measure(i) * q.mass;
    }
    out.push_back(momentum / mass);
  }
  return out;
}

double mean_gap(std::vector<double> const& a, std::vector<double> const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("a uniform stressed body flies on as it is", "[solid][line]") {
  for (Predictor p : predictors) {
    for (bool plastic : {false, true}) {
      SolidLineSetup s{.material = aluminium(plastic), .faces = graded(0.2, 1.2, 30)};
      Sym3 const S{0.1e9, -0.03e9, -0.07e9, 0.04e9, -0.05e9, 0.02e9};
      double const pressure = 3e9;
      s.left = s.right = held({S[0] - pressure, S[3], S[4]});
      s.options.predictor = p;
      SolidLine line(s);
      SolidPoint const q{.rho = 2800, .u = {310, -200, 170}, .p = pressure, .S = S, .ep = 0.01};
      line.set_state([&](double) { return q; });
      for (int k = 0; k < 50; ++k) REQUIRE(line.step(1).status == StepStatus::ok);
      for (std::size_t k = 0; k < line.cells(); ++k) {
        SolidPoint const a = line.primitive(k);
        // positions of size 1 in cells of size 1/45 are rounded 50 times: 50 * 45 * 1e-16 of the density at most
        CHECK(a.rho == Approx(q.rho).epsilon(5e-13));
        CHECK(std::fabs(a.p - q.p) < 5e-13 * 80e9);
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::fabs(a.u[c] - q.u[c]) < 5e-13 * 6000);
        for (std::size_t c = 0; c < 6; ++c) CHECK(std::fabs(a.S[c] - q.S[c]) < 5e-13 * 80e9);
      }
      // the left face flew with the velocity
      CHECK(line.faces().front() == Approx(0.2 + 310 * line.time()).epsilon(1e-13));
    }
  }
}

TEST_CASE("uniform pressure is an equilibrium in every symmetry, to the last bit", "[solid][line]") {
  for (Symmetry symmetry : {Symmetry::planar, Symmetry::cylindrical, Symmetry::spherical}) {
    for (double inner : {0.0, 0.3}) {
      for (Predictor p : predictors) {
        SolidLineSetup s{.material = aluminium(true), .faces = graded(inner, 1, 20), .symmetry = symmetry};
        double const pressure = 2e9;
        SolidLine probe(s.faces.front() == 0 ? (s.left.kind = Kind::symmetry, s) : s);
        probe.set_state([&](double) { return SolidPoint{.rho = 2800, .p = pressure}; });
        s.right = held({-pressure, 0, 0});
        if (inner > 0) s.left = held({-pressure, 0, 0});
        s.options.predictor = p;
        SolidLine line(s);
        line.set_state([&](double) { return SolidPoint{.rho = 2800, .p = pressure}; });
        for (int k = 0; k < 20; ++k) REQUIRE(line.step(1).status == StepStatus::ok);
        // the pressure of the cells' averages is the given one to round-off of K, and that starts waves
        for (double u : line.field(Field::velocity_x)) CHECK(std::fabs(u) < 1e-14 * 6000);
        for (double v : line.field(Field::mises)) CHECK(v < 1e-14 * 80e9);
      }
    }
  }
}

TEST_CASE("mass, momentum and energy: the ledger closes", "[solid][line]") {
  for (Symmetry symmetry : {Symmetry::planar, Symmetry::cylindrical, Symmetry::spherical}) {
    for (Predictor p : predictors) {
      SolidLineSetup s{.material = aluminium(true), .faces = graded(0.5, 1.5, 60), .symmetry = symmetry};
      s.options.predictor = p;
      s.left = {.kind = Kind::traction, .traction = [](Vec3 const&, double t) {
                  return Vec3{-4e9 * std::sin(2e4 * t), 0, 0};
                }};
      s.right = {.kind = Kind::wall, .normal_velocity = [](Vec3 const&, double) { return -20.0; }};
      SolidLine line(s);
      line.set_state([](double x) { return SolidPoint{.rho = 2785, .u = {200 * std::sin(6 * x), 0, 0}}; });
      for (int k = 0; k < 200; ++k) REQUIRE(line.step(1).status == StepStatus::ok);
      SolidLedger const l = line.ledger();
      // sums of 60 cells over 200 steps in double precision
      CHECK(l.mass.residual() == 0.0);
      CHECK(std::fabs(l.momentum[0].residual()) < 1e-13);
      CHECK(std::fabs(l.energy.residual()) < 1e-13);
      CHECK(std::fabs(l.energy.through_boundary) > 1e-4 * l.energy.current);
      CHECK(l.plastic_work > 0);
      CHECK(line.counters().tangent > 100);
    }
  }
}

TEST_CASE("a linear P wave between walls: second order", "[solid][line]") {
  AnySolid const m = aluminium(false);
  double const c = longitudinal_speed(m), A = 1e-4, k = 2 * M_PI, t_end = 0.9 / c;
  for (bool equal : {true, false}) {
    for (Kind kind : {Kind::symmetry, Kind::wall, Kind::fixed}) {
      auto const error = [&](int n) {
        SolidLineSetup s{.material = m, .faces = graded(0, 1, n)};
        if (equal) {
          for (int f = 0; f <= n; ++f) s.faces[static_cast<std::size_t>(f)] = static_cast<double>(f) / n;
        }
        s.left.kind = s.right.kind = kind, s.options.monotonicity = Switch::off;
        SolidLine line(s);
        line.set_state([&](double x) { return SolidPoint{.rho = 2785, .u = {A * std::sin(k * x), 0, 0}}; }, 5);
        run(line, t_end);
        double sum = 0;
        for (std::size_t i = 0; i < line.cells(); ++i) {
          double const a = line.faces()[i], b = line.faces()[i + 1];
          double const mean = A * std::cos(k * c * t_end) * (std::cos(k * a) - std::cos(k * b)) / (k * (b - a));
          sum += (b - a) * std::fabs(line.primitive(i).u[0] - mean);
        }
        return sum / A;
      };
      double const coarse = error(80), fine = error(160);
      INFO((equal ? "equal" : "graded") << " cells, boundary " << static_cast<int>(kind) << ": " << coarse << ", "
                                        << fine);
      // the next term of the error is O(h) of it at the walls, where amplitudes are extrapolated
      CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.12));
      CHECK(fine < 2e-3);
    }
  }
}

TEST_CASE("a spherical elastic pulse: second order", "[solid][line]") {
  AnySolid const m = aluminium(false);
  double const c = longitudinal_speed(m);
  for (double inner : {0.0, 0.4}) {
    // before, while and after the pulse passes the inner end
    for (double end : {0.2, 0.45, 0.7}) {
      auto const make = [&](int n) {
        SolidLineSetup s{.material = m, .faces = graded(inner, inner + 1, n), .symmetry = Symmetry::spherical};
        for (int f = 0; f <= n; ++f) s.faces[static_cast<std::size_t>(f)] = inner + static_cast<double>(f) / n;
        s.left.kind = inner > 0 ? Kind::free : Kind::symmetry, s.options.monotonicity = Switch::off;
        SolidLine line(s);
        line.set_state(
            [&](double r) {
              double const y = (r - inner - 0.5) / 0.3,
                           v = std::fabs(y) < 1 ? std::pow(std::cos(M_PI / 2 * y), 6) : 0.0;
              return SolidPoint{.rho = 2785, .u = {20 * v, 0, 0}};
            },
            5);
        run(line, end / c);
        return line;
      };
      SolidLine const a = make(100), b = make(200), d = make(400);
      double const coarse = mean_gap(a.field(Field::velocity_x), coarsened(b, 0)),
                   fine = mean_gap(b.field(Field::velocity_x), coarsened(d, 0));
      INFO("inner radius " << inner << ", end " << end << ": " << coarse << ", " << fine);
      // of differences between neighbouring grids, which feel the next term more than errors do
      CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.15));
    }
  }
}

TEST_CASE("between fixed walls the line and the grid solve the same problem", "[solid][line]") {
  AnySolid const m = aluminium(false);
  double const c = longitudinal_speed(m), t_end = 0.8 / c;
  // amplitude 1 m/s: the material moves by 1e-4 of a wavelength
  auto const state = [](double x) {
    return SolidPoint{.rho = 2785, .u = {std::sin(2 * M_PI * x), 0.7 * std::sin(M_PI * x), 0}};
  };
  auto const gap = [&](int n, std::size_t component) {
    SolidLineSetup s{.material = m};
    for (int f = 0; f <= n; ++f) s.faces.push_back(static_cast<double>(f) / n);
    s.left.kind = s.right.kind = Kind::fixed, s.options.monotonicity = Switch::off;
    SolidLine line(s);
    line.set_state(state);
    run(line, t_end);
    SolidGridSetup g{.material = m, .cells = {n, 1, 1}};
    g.sides[0].kind = g.sides[1].kind = Kind::fixed, g.options.monotonicity = Switch::off;
    SolidGrid grid(g);
    grid.set_state([&](Vec3 const& x) { return state(x[0]); });
    while (grid.time() < t_end) REQUIRE(grid.step(t_end).status == StepStatus::ok);
    // the grid's velocity where the line's cells are: linear between its centres
    std::vector<double> const u = grid.field(component == 0 ? Field::velocity_x : Field::velocity_y);
    double sum = 0;
    for (int i = 1; i + 1 < n; ++i) {
      std::size_t const k = static_cast<std::size_t>(i);
      double const shift = 0.5 * (line.faces()[k] + line.faces()[k + 1]) * n - 0.5 - i;
      sum += std::fabs(line.primitive(k).u[component] - u[k] - shift * 0.5 * (u[k + 1] - u[k - 1]));
    }
    return sum / n;
  };
  for (std::size_t component : {0u, 1u}) {
    double const coarse = gap(60, component), fine = gap(120, component);
    INFO("component " << component << ": " << coarse << ", " << fine);
    // both are of second order; their gap is at most the sum of their errors
    CHECK(fine < 1e-3);
    CHECK(std::log2(coarse / fine) > 1.85);
  }
}
