/// Programmed burn: what it releases, and that neither tiles nor skipping change it.
#include <algorithm>
#include <cmath>

#include "scheme/step/gas_grid.hpp"
#include "scheme/step/lighting_times.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

Jwl const products{};  // TNT-RDX
constexpr double q = 2.1e7, D = 7587, p0 = 1e5;

GasDensities explosive() { return {products.rho0, {0, 0, 0}, products.rho0 * products.energy(products.rho0, p0)}; }

}  // namespace

TEST_CASE("a closed vessel gains the energy of its explosive, no more and no less", "[burn]") {
  constexpr int n = 40;
  constexpr double length = 0.04;
  for (Symmetry symmetry : {Symmetry::planar, Symmetry::spherical}) {
    GasLineSetup setup{.eos = products, .symmetry = symmetry};
    for (int i = 0; i <= n; ++i) setup.faces.push_back(length * i / n);
    setup.left.kind = setup.right.kind = GasBoundary::Kind::wall;
    setup.burn = {.energy = q, .speed = D, .lighting = [](Vec3 const& x) { return x[0] / D; }};
    GasLine line(setup);
    std::vector<GasConserved<>> start(n, {explosive().mass, 0, explosive().energy});
    line.set_averages(start);
    double mass = 0, before = 0, after = 0;
    for (std::size_t i = 0; i < n; ++i) {
      mass += line.measure(i) * line.average(i).mass, before += line.measure(i) * line.average(i).energy;
    }
    while (line.time() < 1.3 * length / D) REQUIRE(line.step(1.3 * length / D).status == StepStatus::ok);
    for (std::size_t i = 0; i < n; ++i) after += line.measure(i) * line.average(i).energy;
    // sums of forty cells over about a hundred steps
    CHECK(after - before == Approx(q * mass).epsilon(1e-13));
    CHECK(line.ledger().energy.from_source == Approx(q * mass).epsilon(1e-13));
    CHECK(line.counters().floored == 0);
  }
}

TEST_CASE("tiles, threads and skipping do not change a burn", "[burn]") {
  auto const run = [](Int3 tile, int threads, bool skip) {
    GasGridSetup setup{.eos = products, .lower = {0, 0, 0}, .upper = {0.05, 0.05, 0.05}, .cells = {20, 20, 20}};
    for (std::size_t a = 0; a < 3; ++a) setup.sides[2 * a].kind = GridBoundary::Kind::wall;
    setup.burn = {.energy = q, .speed = D, .lighting = [](Vec3 const& x) {
                    double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
                    return r < 0.03 ? r / D : ProgrammedBurn::no_explosive;
                  }};
    setup.options.tile = tile, setup.options.threads = threads, setup.options.skip = skip;
    setup.options.cells_per_thread = 1;
    GasGrid grid(setup);
    double const air = products.energy(1.2, p0);
    grid.set_averages([&](Vec3 const& x, Vec3 const&) -> GasDensities {
      double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      return r < 0.03 ? explosive() : GasDensities{1.2, {0, 0, 0}, 1.2 * air};
    });
    double const end = 5e-6;  // the front has left the charge, and products expand
    while (grid.time() < end) REQUIRE(grid.step(end).status == StepStatus::ok);
    CHECK(std::fabs(grid.ledger().energy.residual()) < 1e-14);
    return grid.field(GasGrid::Field::pressure);
  };
  auto const whole = run({20, 20, 20}, 1, false);
  CHECK(run({5, 5, 5}, 2, true) == whole);
  CHECK(run({8, 4, 20}, 1, true) == whole);
}

TEST_CASE("around a block a charge burns to its end, whatever tiles, threads and skipping are", "[burn]") {
  // explosive fills a closed vessel, beside a block
  LightingSetup lighting{.upper = {0.05, 0.05, 0.05},
                         .cells = {20, 20, 20},
                         .last = {20, 20, 20},
                         .explosive = [](Vec3 const&) { return true; },
                         .obstacles = {[](Vec3 const& x) {
                           return std::max({0.0125 - x[0], x[0] - 0.025, x[1] - 0.0375, x[2] - 0.0375});
                         }},
                         .ignition = {{{0.005, 0.005, 0.005}}},
                         .speed = D};
  LightingTimes const times(lighting);
  double const last = *std::max_element(times.all().begin(), times.all().end());
  double const straight = std::hypot(0.04, 0.04, 0.04) / D;
  CHECK(last > straight);
  double const end = last + 0.0025 / D;  // the front has crossed its cell
  auto const run = [&](Int3 tile, int threads, bool skip) {
    GasGridSetup setup{.eos = products, .lower = {0, 0, 0}, .upper = {0.05, 0.05, 0.05}, .cells = {20, 20, 20}};
    for (GridBoundary& side : setup.sides) side.kind = GridBoundary::Kind::wall;
    setup.blocks = {{{5, 0, 0}, {10, 15, 15}}};
    setup.burn = {.energy = q, .speed = D, .lighting = [&](Vec3 const& x) { return times(x); }};
    setup.options.tile = tile, setup.options.threads = threads, setup.options.skip = skip;
    setup.options.cells_per_thread = 1;
    GasGrid grid(setup);
    grid.set_averages([&](Vec3 const&, Vec3 const&) { return explosive(); });
    while (grid.time() < end) REQUIRE(grid.step(end).status == StepStatus::ok);
    GridLedger const ledger = grid.ledger();
    CHECK(std::fabs(ledger.energy.residual()) < 1e-14);
    // sums over some hundred steps
    CHECK(ledger.energy.from_source == Approx(q * ledger.mass.initial).epsilon(1e-12));
    return grid.field(GasGrid::Field::pressure);
  };
  auto const whole = run({20, 20, 20}, 1, false);
  CHECK(run({5, 5, 5}, 2, true) == whole);
  CHECK(run({8, 4, 20}, 1, true) == whole);
}
