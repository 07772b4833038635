// Bodies that symmetry planes cut, on overset grids.
#include <cmath>

#include "fsi/overset/gas_integrals.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "studies/driver/lookup.hpp"
#include "tests/catch.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

constexpr double size = 1.5, edge = 0.47, p0 = 1e9;  // the cube's sides lie within cells: no ties
constexpr int cells = 24;                            // of a width that is a power of 2: the same cells in every part

/// A steel cube about the origin, in a blast that comes from all sides and has the planes' symmetry; the first
/// `planes` of x = 0, y = 0, z = 0 are walls.
OversetSolver cube_in_blast(int planes) {
  SolidMedium const steel = solid_medium("steel", true);
  double const h = size / cells;
  OversetSetup s{.gas = symmetric_cube(IdealGas{1.4}, size, cells, planes)};
  s.closure = true;
  s.remeshing.on = false;
  // what is exact at walls alone, or decides by a threshold, would not be the same to round-off
  s.gas.options.cure = s.gas.options.linear_star = false;
  TriangleSurface part = clip_at_origin(make_box({edge, edge, edge}, 0.83 * h), 3, 1e-9);
  for (std::size_t a = 3; a-- > static_cast<std::size_t>(planes);) part = unfolded(part, a, 0);
  s.bodies.push_back({.surface = part,
                      .material = steel.scheme,
                      .cell = h,
                      .lower = {-0.375, -0.375, -0.375},
                      .upper = {0.375, 0.375, 0.375},
                      .initial = [=](Vec3 const&) {
                        return solid_state(steel, steel.rho0 * (1 + p0 / 175e9), {0, 0, 0}, p0);
                      }});
  return {std::move(s), [](Vec3 const& x) {
            double const r = std::sqrt(x[0] * x[0] + 1.3 * x[1] * x[1] + 0.8 * x[2] * x[2]);
            double const push = std::exp(-std::pow((r - 0.6) / 0.15, 2));
            return GasPoint{100 * (1 + 4 * push), {0, 0, 0}, p0 * (1 + 9 * push)};
          }};
}

constexpr double thickness = 0.21, wide = 0.375, high = 0.25;

/// A plate across x between walls at both sides of y and z, struck by a plane pulse with ripples along y; or its double
/// about y = 0.
OversetSolver plate_between_walls(bool twice) {
  SolidMedium const steel = solid_medium("steel", true);
  double const h = size / cells;
  GasGridSetup gas{.eos = IdealGas{1.4},
                   .lower = {-0.5, twice ? -wide : 0, 0},
                   .upper = {0.5, wide, high},
                   .cells = {16, twice ? 12 : 6, 4}};
  for (std::size_t side : {2u, 3u, 4u, 5u}) gas.sides[side].kind = GridBoundary::Kind::wall;
  OversetSetup s{.gas = gas, .bodies = {}};
  s.remeshing.on = false;
  s.gas.options.cure = s.gas.options.linear_star = false;
  TriangleSurface part = clip_at_origin(make_box({thickness, 2, 2}, 0.83 * h), 0, 0);
  for (std::size_t a : {1u, 2u}) {
    part = clip_surface(part, a, 0, true, 0.3 * h);
    part = clip_surface(part, a, gas.upper[a], false, 0.3 * h);
  }
  s.bodies.push_back({.surface = twice ? unfolded(part, 1, 0) : part,
                      .material = steel.scheme,
                      .cell = h,
                      .lower = {-0.1875, -1, -1},
                      .upper = {0.1875, 1, 1},
                      .initial = [=](Vec3 const&) {
                        return solid_state(steel, steel.rho0 * (1 + p0 / 175e9), {0, 0, 0}, p0);
                      }});
  return {std::move(s), [](Vec3 const& x) {
            double const ripple = 0.2 * std::cos(3.14159265358979 * x[1] / wide);
            double const push = (1 + ripple) * std::exp(-std::pow((x[0] + 0.3) / 0.1, 2));
            return GasPoint{100 * (1 + 4 * push), {0, 0, 0}, p0 * (1 + 9 * push)};
          }};
}

/// Largest difference of what both hold, relative to the blast's pressure, 500 m/s and a cell.
struct Difference {
  double gas = 0, solid = 0, contact = 0, vertex = 0, yielded = 0;
};

Difference difference(OversetSolver const& part, OversetSolver const& whole) {
  Difference d;
  Int3 const n = part.gas().cells(), all = whole.gas().cells();
  auto const velocity = [](Vec3 const& a, Vec3 const& b) { return length(a - b) / 500; };
  CellKinds const& kinds = part.bodies()[0]->gas.kinds;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        if (!kinds.in_medium(part.gas().centre({i, j, k}))) continue;
        GasPoint const a = part.gas().primitive({i, j, k});
        GasPoint const b = whole.gas().primitive({i + all[0] - n[0], j + all[1] - n[1], k + all[2] - n[2]});
        d.gas = std::max({d.gas, std::fabs(a.p - b.p) / p0, std::fabs(a.rho - b.rho) / 100, velocity(a.u, b.u)});
      }
    }
  }
  Body const &a = *part.bodies()[0], &b = *whole.bodies()[0];
  for (std::size_t i = 0; i < a.solid.kinds.count(); ++i) {
    if (!a.solid.kinds.valid(i)) continue;
    Int3 const there = b.solid.kinds.cell_of(a.solid.kinds.centre(a.solid.kinds.cell(i)));
    std::size_t const m = static_cast<std::size_t>(b.solid.kinds.index(there));
    REQUIRE(b.solid.kinds.valid(m));
    SolidFields const &p = a.solid.states[i], &q = b.solid.states[m];
    d.solid = std::max({d.solid, std::fabs(p[solid_field_of::p] - q[solid_field_of::p]) / p0,
                        velocity(velocity_of(p), velocity_of(q))});
    for (std::size_t c = 0; c < 6; ++c)
      d.solid = std::max(d.solid, std::fabs(p[solid_field_of::S + c] - q[solid_field_of::S + c]) / p0);
    d.yielded = std::max(d.yielded, p[solid_field_of::ep]);
  }
  // those of the part come first in the whole
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    TriangleState const &p = a.triangles[t], &q = b.triangles[t];
    d.contact = std::max({d.contact, std::fabs(p.pressure - q.pressure) / p0, velocity(p.velocity, q.velocity)});
  }
  for (std::size_t v = 0; v < a.surface.vertices.size(); ++v) {
    d.vertex = std::max(d.vertex, length(a.surface.vertices[v] - b.surface.vertices[v]) * cells / size);
  }
  return d;
}

CaseResult drift(double body, double speed, double planes) {
  CaseOptions o;
  o.cells = 26, o.threads = 2;
  o.values = {{"body", body}, {"speed", speed}, {"planes", planes}, {"steps", 20}};
  return find_by_name(all_cases(), "freestream-bodies", "test").run(o);
}

}  // namespace

TEST_CASE("a half, a quarter and an eighth of a cube are the parts of the whole") {
  // The same operations up to the order of sums, over 16 steps of a strong blast on a body that yields: round-off,
  // which the stresses of the solid have relative to its bulk modulus, 175 times the scale here.
  OversetSolver whole = cube_in_blast(0);
  for (int n = 0; n < 16; ++n) REQUIRE(whole.step(1).status == StepStatus::ok);
  BodyIntegrals const all = integrals(*whole.bodies()[0]);
  for (int planes : {1, 2, 3}) {
    OversetSolver part = cube_in_blast(planes);
    for (int n = 0; n < 16; ++n) REQUIRE(part.step(1).status == StepStatus::ok);
    CHECK(part.time() == Approx(whole.time()).epsilon(1e-11));
    Difference const d = difference(part, whole);
    CAPTURE(planes, d.gas, d.solid, d.contact, d.vertex, d.yielded);
    CHECK(d.yielded > 1e-6);
    CHECK(d.gas < 1e-11);
    CHECK(d.solid < 1e-11);
    CHECK(d.contact < 1e-11);
    CHECK(d.vertex < 1e-11);
    BodyIntegrals const some = integrals(*part.bodies()[0]);
    double const share = std::pow(0.5, planes);
    CHECK(some.volume == Approx(share * all.volume).epsilon(1e-11));
    CHECK(some.mass == Approx(share * all.mass).epsilon(1e-11));
    CHECK(some.energy == Approx(share * all.energy).epsilon(1e-11));
  }
}

TEST_CASE("a plate between two pairs of walls is half of that of twice the width") {
  // as above; the volume is that of the box exactly
  OversetSolver whole = plate_between_walls(true), part = plate_between_walls(false);
  CHECK(enclosed(*part.bodies()[0]).volume == Approx(thickness * wide * high).epsilon(1e-13));
  Vec3 const centre = enclosed(*part.bodies()[0]).centroid;
  CHECK(length(centre - Vec3{0, 0.5 * wide, 0.5 * high}) < 1e-13);
  for (int n = 0; n < 25; ++n) {
    REQUIRE(whole.step(1).status == StepStatus::ok);
    REQUIRE(part.step(1).status == StepStatus::ok);
  }
  Difference const d = difference(part, whole);
  CAPTURE(d.gas, d.solid, d.contact, d.vertex);
  CHECK(d.gas < 1e-11);
  CHECK(d.solid < 1e-11);
  CHECK(d.contact < 1e-11);
  CHECK(d.vertex < 1e-11);
  BodyIntegrals const now = integrals(*part.bodies()[0]);
  Vec3 const impulse = part.momenta()[0].linear;
  CAPTURE(now.momentum[0], impulse[0], now.mass);
  CHECK(now.momentum[0] > 1);
  CHECK(now.mass == Approx(0.5 * integrals(*whole.bodies()[0]).mass).epsilon(1e-11));
}

TEST_CASE("gas beside a plate between walls fills what the plate leaves, wherever its window begins") {
  double const h = 1.0 / 16;
  for (int before : {5, 9, 14}) {  // cells of gas before the plate, which does not lie along their faces
    GasGridSetup gas{.eos = IdealGas{1.4}, .lower = {-before * h, 0, 0}, .upper = {12 * h, 4 * h, 4 * h}};
    gas.cells = {before + 12, 4, 4};
    for (std::size_t side : {2u, 3u, 4u, 5u}) gas.sides[side].kind = GridBoundary::Kind::wall;
    TriangleSurface plate = make_box({4 * h, 2, 2}, 0.83 * h);
    for (Vec3& x : plate.vertices) x[0] += 2.3 * h;
    for (std::size_t a : {1u, 2u}) {
      plate = clip_surface(plate, a, 0, true, 0.3 * h), plate = clip_surface(plate, a, 4 * h, false, 0.3 * h);
    }
    OversetSetup s{.gas = gas, .bodies = {}};
    s.bodies.push_back({.surface = plate,
                        .cell = h,
                        .lower = {0, 0, 0},
                        .upper = {5 * h, 4 * h, 4 * h},
                        .initial = {},
                        .rigid = RigidSetup{.density = 2}});
    OversetSolver const solver(s, [](Vec3 const&) { return GasPoint{3, {0, 0, 0}, 1}; });
    GasIntegrals const held = gas_integrals(solver);
    CHECK(held.volume == Approx((before + 8) * 16 * h * h * h).epsilon(1e-12));
    CHECK(held.mass == Approx(3 * held.volume).epsilon(1e-12));
  }
}

TEST_CASE("a uniform stream carries a cut body along its planes and stays uniform") {
  // round-off alone: 20 steps of sums of about 20 terms. Turned bodies: cut at any angle, with irregular triangles
  for (double body : {0.0, 1.0}) {
    for (double planes : {1.0, 2.0, 3.0}) {
      CaseResult const r = drift(body, 500, planes);
      CAPTURE(body, planes);
      CHECK(r.facts.at("cells_travelled") > (planes < 3 ? 0.1 : -1.0));
      CHECK(r.facts.at("deviation_gas") < 1e-12);
      CHECK(r.facts.at("deviation_solid") < 1e-12);
      CHECK(r.facts.at("deviation_surface") < 1e-12);
      CHECK(r.facts.at("volume_change") < 1e-12);
      CHECK(r.facts.at("problems_first_order") == 0);
    }
  }
}

TEST_CASE("an eighth of a sphere breathes as the whole") {
  CaseOptions o;
  o.cells = 20, o.threads = 2, o.values = {{"periods", 2}, {"eighths", 8}};
  Case const breathing = find_by_name(all_cases(), "breathing-sphere", "test");
  CaseResult const whole = breathing.run(o);
  o.values["eighths"] = 1;
  CaseResult const eighth = breathing.run(o);
  CHECK(eighth.facts.at("period_ratio") == Approx(whole.facts.at("period_ratio")).epsilon(1e-6));
  CHECK(eighth.facts.at("energy_left") == Approx(whole.facts.at("energy_left")).epsilon(1e-6));
}

TEST_CASE("an open surface is refused where no wall cuts it, and by both walls across x") {
  auto const with = [](TriangleSurface surface, bool low, bool high) {
    GasGridSetup gas{.eos = IdealGas{1.4}, .lower = {0, 0, 0}, .upper = {1, 1, 1}, .cells = {16, 16, 16}};
    if (low) gas.sides[0].kind = GridBoundary::Kind::wall;
    if (high) gas.sides[1].kind = GridBoundary::Kind::wall;
    SolidMedium const steel = solid_medium("steel");
    BodySetup b{.surface = std::move(surface), .material = steel.scheme, .cell = 1.0 / 16, .initial = {}};
    return Body(std::move(b), GasGrid(gas), {});
  };
  TriangleSurface bar = make_box({2, 0.4, 0.4}, 0.06);
  for (Vec3& x : bar.vertices) x = x + Vec3{0.5, 0.5, 0.5};
  TriangleSurface const half = clip_surface(clip_surface(bar, 0, 0, true, 0), 0, 0.6, false, 0);
  CHECK_THROWS_AS(with(half, true, false), SurfaceError);   // open at x = 0.6
  CHECK_THROWS_AS(with(half, false, false), SurfaceError);  // open at x = 0 as well
  TriangleSurface const across = clip_surface(clip_surface(bar, 0, 0, true, 0), 0, 1, false, 0);
  CHECK_THROWS_AS(with(across, true, true), SurfaceError);
  TriangleSurface const low = clip_surface(bar, 0, 0, true, 0);
  CHECK_THROWS_AS(with(low, false, true), SurfaceError);
}
