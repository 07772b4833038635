/// From a line to a grid: totals to round-off, the gas outside untouched, the profile to second order.
#include "scheme/step/map_line_to_grid.hpp"

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"

using namespace g27;

namespace {

constexpr double gamma_gas = 1.3, outer_rho = 1.2, outer_p = 0.7, reach = 0.6;

double bump(double r) { return r < reach ? std::pow(std::cos(0.5 * std::numbers::pi * r / reach), 4) : 0.0; }

/// A smooth wave of radius `reach` in gas at rest.
GasState<> wave(double r) { return {outer_rho + 2 * bump(r), 3 * (r / reach) * bump(r), outer_p + 5 * bump(r)}; }
/// A hot ball with a jump: what a shock is to the mapping.
GasState<> ball(double r) { return r < 0.31 ? GasState<>{3, 4 * r, 40} : GasState<>{outer_rho, 0, outer_p}; }

GasLine line_of(int cells, Symmetry symmetry, GasState<> (*state)(double)) {
  GasLineSetup setup{.eos = IdealGas{gamma_gas}, .symmetry = symmetry, .left = {.kind = GasBoundary::Kind::wall}};
  for (int i = 0; i <= cells; ++i) setup.faces.push_back(2.0 * i / cells);
  GasLine line(setup);
  line.set_state(state);
  return line;
}

struct Layout {
  char const* name;
  GridBox box;
  Vec3 centre;
};

std::vector<Layout> const layouts{
    {"octant", {.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cells = {20, 20, 20}}, {0, 0, 0}},
    {"octant seen from the far corner", {.lower = {-1, -1, -1}, .upper = {0, 0, 0}, .cells = {20, 16, 12}}, {0, 0, 0}},
    {"half on a side", {.lower = {-1, -0.9, 0}, .upper = {0.8, 0.7, 1}, .cells = {18, 16, 10}}, {0.03, -0.02, 0}},
    {"inside", {.lower = {-1, -1, -1}, .upper = {1, 1, 1}, .cells = {15, 16, 17}}, {0.1, 0.02, -0.2}},
    {"plane, quarter", {.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cells = {24, 20, 1}}, {0, 0, 0}},
    {"plane, inside", {.lower = {-1, -1, 0}, .upper = {1, 1, 1}, .cells = {30, 31, 1}}, {0.1, -0.1, 0}},
};

Symmetry symmetry_of(Layout const& l) { return l.box.cells[2] > 1 ? Symmetry::spherical : Symmetry::cylindrical; }

template <class F>
void every_cell(GridBox const& box, F const& visit) {
  for (int k = 0; k < box.cells[2]; ++k)
    for (int j = 0; j < box.cells[1]; ++j)
      for (int i = 0; i < box.cells[0]; ++i) visit(Int3{i, j, k});
}

double cell_volume(GridBox const& b) {
  double v = 1;
  for (std::size_t d = 0; d < 3; ++d) v *= b.cells[d] > 1 ? (b.upper[d] - b.lower[d]) / b.cells[d] : 1.0;
  return v;
}

/// L1 error of the density against the state at finer points of each cell.
double density_error(int cells, GasState<> (*state)(double)) {
  GridBox const box{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cells = {cells, cells, cells}};
  LineToGrid const map(line_of(6 * cells, Symmetry::spherical, state), {0, 0, 0}, box);
  double const h = 1.0 / cells;
  double error = 0;
  constexpr int fine = 8;
  every_cell(box, [&](Int3 const& c) {
    double mean = 0;
    for (int n = 0; n < fine * fine * fine; ++n) {
      double const x = h * (c[0] + (n % fine + 0.5) / fine), y = h * (c[1] + (n / fine % fine + 0.5) / fine),
                   z = h * (c[2] + (n / fine / fine + 0.5) / fine);
      mean += state(std::sqrt(x * x + y * y + z * z)).rho / (fine * fine * fine);
    }
    error += h * h * h * std::fabs(map(c).mass - mean);
  });
  return error;
}

}  // namespace

TEST_CASE("a mapped line keeps mass, momentum and energy to round-off", "[map]") {
  for (Layout const& l : layouts) {
    for (auto* state : {wave, ball}) {
      INFO(l.name);
      GasLine const line = line_of(240, symmetry_of(l), state);
      LineToGrid const map(line, l.centre, l.box);
      double mass = 0, energy = 0, scale = 0;
      Vec3 momentum{};
      every_cell(l.box, [&](Int3 const& c) {
        GasDensities const q = map(c);
        double const v = cell_volume(l.box);
        mass += v * q.mass, energy += v * q.energy;
        for (std::size_t d = 0; d < 3; ++d) momentum[d] += v * q.momentum[d], scale += v * std::fabs(q.momentum[d]);
      });
      // 1e-12: round-off of this sum over 8000 cells. Independent of the map: shells of the line within the open angle,
      // the rest of the box outside
      double const angle = open_angle(l.box, l.centre);
      double shells_mass = 0, shells_energy = 0, shells_volume = 0, box_volume = cell_volume(l.box);
      for (int const n : l.box.cells) box_volume *= n;
      for (std::size_t i = 0; line.faces()[i] < map.radius() * (1 - 1e-12); ++i) {
        shells_mass += angle * line.measure(i) * line.average(i).mass;
        shells_energy += angle * line.measure(i) * line.average(i).energy;
        shells_volume += angle * line.measure(i);
      }
      GasConserved<> const outer = line.average(line.cells() - 1);
      CHECK(mass == Approx(shells_mass + (box_volume - shells_volume) * outer.mass).epsilon(1e-12));
      CHECK(energy == Approx(shells_energy + (box_volume - shells_volume) * outer.energy).epsilon(1e-12));
      for (std::size_t d = 0; d < 3; ++d) CHECK(std::fabs(momentum[d] - map.total().momentum[d]) < 1e-12 * scale);
      CHECK(map.missing() < (state == wave ? 2e-3 : 2e-2));
    }
  }
}

TEST_CASE("the momentum of an octant points along its diagonal", "[map]") {
  Layout const& l = layouts[0];
  GasLine const line = line_of(240, Symmetry::spherical, wave);
  LineToGrid const map(line, l.centre, l.box);
  double radial = 0;
  for (std::size_t i = 0; i < line.cells(); ++i) radial += line.measure(i) * line.average(i).momentum;
  // int cos over an octant = pi/4
  for (double const p : map.total().momentum) CHECK(p == Approx(0.25 * std::numbers::pi * radial).epsilon(1e-9));
}

TEST_CASE("gas that the wave has not reached keeps its bits", "[map]") {
  Layout const& l = layouts[0];
  GasLine const line = line_of(240, Symmetry::spherical, wave);
  LineToGrid const map(line, l.centre, l.box);
  GasConserved<> const outer = line.average(line.cells() - 1);
  int untouched = 0;
  every_cell(l.box, [&](Int3 const& c) {
    double const r = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / 20.0;  // nearest corner
    if (r < reach + 1e-3) return;
    GasDensities const q = map(c);
    untouched += q.mass == outer.mass && q.energy == outer.energy && q.momentum == Vec3{0, 0, 0};
  });
  CHECK(untouched > 6000);  // of 8000: an octant of a ball of radius 0.6 fills 11 per cent of the box
}

TEST_CASE("a smooth wave is mapped to second order, a jump to first", "[map]") {
  double const coarse = density_error(10, wave), fine = density_error(20, wave);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.3));
  CHECK(fine < 2e-4);  // of a mean density of 1.3
  double const jump_coarse = density_error(10, ball), jump_fine = density_error(20, ball);
  CHECK(jump_fine < jump_coarse);
  CHECK(jump_fine < 2e-3);
}

TEST_CASE("a line that does not fit the grid is refused", "[map]") {
  GridBox const small{.lower = {-0.5, -1, -1}, .upper = {1, 1, 1}, .cells = {15, 20, 20}};
  CHECK_THROWS_AS(LineToGrid(line_of(240, Symmetry::spherical, wave), {0, 0, 0}, small), std::invalid_argument);
  CHECK_THROWS_AS(LineToGrid(line_of(240, Symmetry::cylindrical, wave), {0, 0, 0}, layouts[0].box),
                  std::invalid_argument);
}

TEST_CASE("dense products beside air stay states of their gas", "[map]") {
  Jwl const products{708.6056e9, 13.16457e9, 4.94, 1.35, 0.28, 1650};
  GasLineSetup setup{.eos = products, .symmetry = Symmetry::spherical, .left = {.kind = GasBoundary::Kind::wall}};
  for (int i = 0; i <= 180; ++i) setup.faces.push_back(0.18 * i / 180);
  GasLine line(setup);
  // like a detonation's front at breakout: dense, fast, and cool inside, air outside
  line.set_state([](double r) -> GasState<> {
    double const s = r / 0.05;
    return s < 1 ? GasState<>{1200 + 1100 * std::pow(s, 12), 1900 * s * s, 6e9 + 17.7e9 * std::pow(s, 12)}
                 : GasState<>{1.2, 0, 1e5};
  });
  GridBox const box{.lower = {0, 0, 0}, .upper = {0.15, 0.15, 0.15}, .cells = {50, 50, 50}};
  for (int step = 0; step < 10; ++step) {
    LineToGrid const map(line, {0, 0, 0}, box);
    int lost = 0;
    every_cell(box, [&](Int3 const& c) {
      GasDensities const q = map(c);
      Vec3 const& m = q.momentum;
      double const e = (q.energy - 0.5 * (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) / q.mass) / q.mass;
      lost += !(products.pressure_margin(q.mass, products.pressure(q.mass, e)) > 0);
    });
    INFO("step " << step);
    CHECK(lost == 0);
    REQUIRE(line.step(1).status == StepStatus::ok);
  }
}
