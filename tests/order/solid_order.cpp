/// Orders of the solid scheme on plane waves, aligned and oblique, and on finite amplitudes.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/solid_waves.hpp"

using namespace g27;
using namespace g27_test;

namespace {

AnySolid steel() { return {.eos = BulkModulus{7800, 175e9}, .mu = 80.77e9}; }
AnySolid aluminium() { return {.eos = MieGruneisen{2785, 5328, 1.338, 2.0}, .mu = 27.6e9}; }

SolidPoint stressed(double rho, double scale) {
  return {.rho = rho,
          .u = {150, -80, 60},
          .p = 0,
          .S = {6 * scale, -4 * scale, -2 * scale, 5 * scale, -4 * scale, 3 * scale}};
}

/// L1 errors of all variables after a period over the amplitude of each (of the velocity's modulus for the velocities).
std::array<double, 11> errors(PlaneWave const& w, Int3 const& cells, Vec3 const& waves, SolidSchemeOptions const& o) {
  SolidGridSetup s = periodic_box(w.solid, cells);
  s.options = o;
  double const length = 1.0 / std::sqrt(waves[0] * waves[0] + waves[1] * waves[1] + waves[2] * waves[2]);
  double const amplitude = 1e-6, period = length / w.speed;
  auto const at = [&](double t) {
    return [&, t](Vec3 const& x) {
      double const phase = w.n(0) * x[0] + w.n(1) * x[1] + w.n(2) * x[2] - w.total_speed() * t;
      return w.state(amplitude * std::sin(2 * M_PI * phase / length));
    };
  };
  SolidGrid g(s), exact(s);
  g.set_state(at(0)), exact.set_state(at(period));
  run(g, period);
  std::array<double, 11> e{};
  double const most_S = w.S.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < 11; ++k) {
    double const scale = k == 0 ? w.mean.rho / w.speed : k < 4 ? 1.0 : k == 4 ? w.mean.rho * w.speed : most_S;
    e[k] = distance(g.field(variables[k]), exact.field(variables[k])) / (amplitude * scale);
  }
  return e;
}

struct Case {
  PlaneWave wave;
  Vec3 waves;
  std::array<int, 3> cells;
  double low, high;  ///< admitted orders of every variable that the wave moves
  SolidSchemeOptions options;
};

void check(Case const& c) {
  std::array<double, 11> previous{};
  std::ostringstream table;
  table.precision(3);
  for (std::size_t m = 0; m < c.cells.size(); ++m) {
    Int3 n{1, 1, 1};
    for (std::size_t a = 0; a < 3; ++a) {
      if (c.waves[a] != 0) n[a] = c.cells[m];
    }
    auto const e = errors(c.wave, n, c.waves, c.options);
    table << c.cells[m] << ":";
    for (std::size_t k = 0; k < 11; ++k)
      table << " " << e[k] << "(" << (m > 0 ? std::log2(previous[k] / e[k]) : 0.0) << ")";
    table << "\n";
    INFO(table.str());
    if (m + 1 == c.cells.size()) {
      double const most = *std::max_element(e.begin(), e.end());
      for (std::size_t k = 0; k < 11; ++k) {
        // a variable that the wave hardly moves has the errors of the others' products
        if (e[k] < 0.05 * most) continue;
        double const order = std::log2(previous[k] / e[k]);
        INFO("variable " << k);
        CHECK(order > c.low);
        CHECK(order < c.high);
      }
    }
    previous = e;
  }
  if (std::getenv("G27_SHOW") != nullptr) std::cout << table.str();
}

SolidSchemeOptions with(Predictor p, Switch s) { return {.predictor = p, .monotonicity = s}; }

}  // namespace

TEST_CASE("plane waves along an axis: orders of the predictors", "[order]") {
  for (int family : {0, 1}) {
    PlaneWave const plain(steel(), {.rho = 7800, .u = {150, 40, -30}}, Vector::UnitX(), family);
    PlaneWave const coupled(steel(), stressed(7800, 1e9), Vector::UnitX(), family);
    for (PlaneWave const& w : {plain, coupled}) {
      Vec3 const k{1, 0, 0};
      check({w, k, {50, 100, 200}, 0.85, 1.1, with(Predictor::godunov, Switch::off)});
      check({w, k, {50, 100, 200}, 1.9, 2.1, with(Predictor::linear, Switch::off)});
      check({w, k, {50, 100, 200}, 1.8, 2.2, with(Predictor::linear, Switch::graded)});
      check({w, k, {50, 100, 200}, 1.8, 2.2, with(Predictor::linear, Switch::binary)});
      check({w, k, {25, 50, 100}, 2.8, 3.2, with(Predictor::parabolic, Switch::graded)});
    }
  }
}

TEST_CASE("plane waves in a Mie-Grueneisen solid", "[order]") {
  AnySolid const al = aluminium();
  PlaneWave const w(al, stressed(2900, 0.5e9), Vector::UnitY(), 0);
  check({w, {0, 1, 0}, {50, 100, 200}, 1.9, 2.1, with(Predictor::linear, Switch::off)});
  check({w, {0, 1, 0}, {25, 50, 100}, 2.8, 3.2, with(Predictor::parabolic, Switch::graded)});
}

TEST_CASE("oblique plane waves in two and three dimensions", "[order]") {
  for (int family : {0, 2}) {
    PlaneWave const flat(steel(), stressed(7800, 1e9), Vector(2, 1, 0), family);
    // from where the linear predictor's own errors rule: two cells fewer than a wave needs would show less
    check({flat, {2, 1, 0}, {32, 64, 128}, 0.75, 1.1, with(Predictor::godunov, Switch::off)});
    check({flat, {2, 1, 0}, {32, 64, 128}, 1.9, 2.1, with(Predictor::linear, Switch::off)});
    check({flat, {2, 1, 0}, {32, 64, 128}, 1.8, 2.2, with(Predictor::linear, Switch::graded)});
    check({flat, {2, 1, 0}, {32, 64, 128}, 1.9, 3.1, with(Predictor::parabolic, Switch::graded)});
    PlaneWave const space(steel(), stressed(7800, 1e9), Vector(1, 1, 1), family);
    check({space, {1, 1, 1}, {12, 24, 48}, 1.85, 2.15, with(Predictor::linear, Switch::off)});
    check({space, {1, 1, 1}, {12, 24, 48}, 1.8, 3.1, with(Predictor::parabolic, Switch::graded)});
  }
}
