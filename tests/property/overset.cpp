// Properties of the overset grids around bodies.
#include <cmath>
#include <random>

#include "fsi/ale/model_problem.hpp"
#include "fsi/overset/donors.hpp"
#include "fsi/overset/overset_solver.hpp"
#include "fsi/surface/shapes.hpp"
#include "studies/driver/lookup.hpp"
#include "tests/catch.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

WindowBox box_of(int n, double h) {
  return {.lower = {-0.5 * n * h, -0.5 * n * h, -0.5 * n * h},
          .h = h,
          .grid = {n, n, n},
          .first = {0, 0, 0},
          .size = {n, n, n}};
}

CaseResult drift(double body, double speed, double gap, int steps, int cells = 26) {
  CaseOptions o;
  o.cells = cells, o.threads = 2;
  o.values = {{"body", body}, {"speed", speed}, {"gap", gap}, {"steps", static_cast<double>(steps)}};
  return find_by_name(all_cases(), "freestream-bodies", "test").run(o);
}

}  // namespace

TEST_CASE("points are of the medium exactly where they lie within the polyhedron") {
  // A sphere's triangles lie within it, and beyond the sphere that their planes touch.
  double const radius = 1, h = 0.17;
  TriangleSurface const s = make_sphere(radius, h);
  double inner = radius;
  for (std::size_t t = 0; t < s.size(); ++t) inner = std::min(inner, dot(s.centre(t), s.normal(t)));
  TriangleSurface const* const one = &s;
  CellKinds in(box_of(20, h), true), out(box_of(20, h), false);
  in.classify(std::span(&one, 1)), out.classify(std::span(&one, 1));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  int judged = 0;
  for (int n = 0; n < 20000; ++n) {
    Vec3 const x{place(random), place(random), place(random)};
    CHECK(in.in_medium(x) != out.in_medium(x));
    double const r = length(x);
    if (r > inner && r < radius) continue;
    ++judged;
    CHECK(in.in_medium(x) == (r <= inner));
  }
  CHECK(judged > 10000);
  // lines through vertices cross one of the triangles around them
  for (Vec3 const& v : s.vertices) {
    if (std::fabs(v[0]) > 0.3) CHECK(in.in_medium({0.5 * v[0], v[1], v[2]}));
  }
}

TEST_CASE("a cell is deep only if all of its neighbours are whole cells of the medium") {
  TriangleSurface const s = make_box({0.97, 0.97, 0.97}, 0.11);
  TriangleSurface const* const one = &s;
  CellKinds in(box_of(20, 0.1), true);
  in.classify(std::span(&one, 1));
  std::size_t deep = 0, valid = 0;
  for (std::size_t i = 0; i < in.count(); ++i) {
    deep += in.kind(i) == CellKind::deep ? 1u : 0u, valid += in.valid(i) ? 1u : 0u;
  }
  // ten cells a side, of which the surface cuts the outer ones
  CHECK(valid == 8 * 8 * 8);
  CHECK(deep == 6 * 6 * 6);
}

TEST_CASE("at a contact of uniform states a model problem gives the exact Riemann solution, in any frame") {
  // acoustic: the solid's answer is linear and the gas's jump 1e-7, whose second order is below the tolerance
  IdealGas const gas{1.4};
  AnySolid const steel{};
  double const p0 = 1e9, rho = 100, K = 175e9, c = std::sqrt(1.4 * p0 / rho), du = 1e-5 * c;
  for (double frame : {0.0, 400.0}) {
    for (Predictor predictor : {Predictor::godunov, Predictor::linear}) {
      ModelProblems problems(gas, steel, 1e-3, 1e-3, {.predictor = predictor});
      ModelStencil s{};
      double const rho_s = 7800 * (1 + p0 / K),
                   e = steel.eos.index() == 0 ? std::get<BulkModulus>(steel.eos).energy(rho_s, p0) : 0;
      for (auto& plane : s.gas) {
        for (auto& row : plane) {
          for (GasFields& q : row) q = {rho, frame, 0, 0, p0};
        }
      }
      for (auto* cells : {&s.solid, &s.solid_smooth}) {
        for (auto& plane : *cells) {
          for (auto& row : plane) {
            for (SolidFields& q : row) q = {rho_s, frame + du, 0, 0, p0, e};
          }
        }
      }
      s.velocity = {frame, 0, 0};
      ModelResult r;
      problems.solve(std::span(&s, 1), 1e-9, std::span(&r, 1));
      double const Z = std::sqrt(rho_s * (K * rho_s / 7800 + 4.0 / 3.0 * steel.mu)), Zg = rho * c;
      // u* = (Z u_s + Zg u_g)/(Z + Zg), p* = p0 + Z Zg/(Z + Zg) du
      CHECK(r.velocity[0] - frame == Approx(du * Z / (Z + Zg)).epsilon(1e-4));
      CHECK(r.pressure - p0 == Approx(Z * Zg / (Z + Zg) * du).epsilon(1e-4));
      CHECK_FALSE(r.failed);
      CHECK_FALSE(r.first_order);
    }
  }
}

TEST_CASE("where gas needs Godunov's scheme the solid keeps its own step") {
  // gas that leaves the solid for vacuum, and along it ever faster: the contact's pressure is 0 all the same
  IdealGas const gas{1.4};
  AnySolid const steel{};
  double const rho_s = 7800, p = 1e9;
  ModelProblems problems(gas, steel, 1e-3, 1e-3, {});
  auto const solve = [&](double along) {
    ModelStencil s{};
    for (int k = 0; k < 3; ++k) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          auto const at = [&](auto& cells) -> auto& {
            return cells[static_cast<std::size_t>(k)][static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
          };
          at(s.gas) = {1, 2e4, along * (a - 1), along * (b - 1), 1e5};
          SolidFields q{rho_s, 10.0 * (k + a), 3.0 * b, 0, p};
          q[solid_field_of::e] = std::visit([&](auto const& eos) { return eos.energy(rho_s, p); }, steel.eos);
          at(s.solid) = at(s.solid_smooth) = q;
        }
      }
    }
    ModelResult r;
    problems.solve(std::span(&s, 1), 2e-8, std::span(&r, 1));
    return r;
  };
  ModelResult const sound = solve(0);
  REQUIRE(sound.pressure == 0);
  REQUIRE_FALSE(sound.first_order);
  int redone = 0;
  for (double along = 1e3; along < 1e5; along *= 1.05) {
    ModelResult const r = solve(along);
    if (!r.first_order || r.failed) continue;
    ++redone;
    CHECK(r.solid == sound.solid);
    CHECK(r.velocity == sound.velocity);
  }
  CHECK(redone > 0);
}

TEST_CASE("a shock that a plate at 45 degrees reflects is as strong as it should be once it has left the cores") {
  CaseOptions o;
  o.cells = 5, o.threads = 2;
  o.values = {{"angle", 0.7853981633974483}, {"width", 3}, {"crossings", 5}};
  CaseResult const r = find_by_name(all_cases(), "struck-plate", "test").run(o);
  auto const fact = [&](char const* name) { return r.facts.at(name); };
  // primitive variables interpolated: 16, 5 and 9 %
  CHECK(std::fabs(fact("contact_pressure") / fact("exact_pressure") - 1) < 0.08);
  CHECK(std::fabs(fact("push_error")) < 0.03);
  CHECK(std::fabs(fact("gas_momentum_rest_over_impulse")) < 0.02);
}

TEST_CASE("a uniform stream carries bodies along and stays uniform") {
  // round-off alone: 40 steps of sums of about 20 terms
  for (double body : {0.0, 1.0, 2.0, 3.0}) {
    CaseResult const r = drift(body, 500, 0.5, 40);
    CHECK(r.facts.at("cells_travelled") > 0.5);
    CHECK(r.facts.at("deviation_gas") < 1e-12);
    CHECK(r.facts.at("deviation_solid") < 1e-12);
    CHECK(r.facts.at("deviation_surface") < 1e-12);
    CHECK(r.facts.at("problems_first_order") == 0);
  }
}

TEST_CASE("what cores fill lies near the surfaces, wherever these lie along the grid") {
  // Cells that neither a grid nor a core steps keep what they had: none may be left out. Faces on and beside the faces
  // of cells: there the second cell is as near as 1.5 cells.
  double const h = 0.1;
  for (double shift : {0.0, 1e-9, -1e-9, 0.05, -0.05, 0.3}) {
    TriangleSurface s = make_box({0.6, 0.6, 0.6}, h);
    for (Vec3& x : s.vertices) x = x + Vec3{shift * h, shift * h, shift * h};
    TriangleSurface const* const one = &s;
    for (bool inside : {false, true}) {
      CellKinds kinds(box_of(20, h), inside);
      kinds.classify(std::span(&one, 1));
      std::vector<char> near(kinds.count(), 0);
      kinds.for_each_near(0, [&](std::size_t i) { near[i] = 1; });
      int filled = 0, left_out = 0;
      for (std::size_t i = 0; i < kinds.count(); ++i) {
        if (kinds.kind(i) != CellKind::shallow) continue;
        ++filled, left_out += near[i] == 0 ? 1 : 0;
      }
      CAPTURE(shift, inside);
      CHECK(filled > 50);
      CHECK(left_out == 0);
    }
  }
}

namespace {

/// A turned cube of steel of 6 cells an edge amid `cells` cells of a stream of gas of the same pressure and velocity.
OversetSetup cube_in_stream(Vec3 const& u, double p, int cells = 16) {
  SolidMedium const steel = solid_medium("steel");
  double const h = 1.0 / cells, edge = 6 * h;
  OversetSetup s{.gas = gas_cube(IdealGas{1.4}, 1, cells), .bodies = {}};
  BodySetup b{.surface = placed(make_box({edge, edge, edge}, h), {0.3, 0.5, 1}, 0.6, {0.503, 0.507, 0.493}),
              .material = steel.scheme,
              .cell = h,
              .initial = [=](Vec3 const&) { return solid_state(steel, steel.rho0 * (1 + p / 175e9), u, p); }};
  auto const box = bounding_box(b.surface);
  b.lower = box.lower - Vec3{h, h, h}, b.upper = box.upper + Vec3{h, h, h};
  s.bodies.push_back(std::move(b));
  return s;
}

}  // namespace

TEST_CASE("a surface that is mended on its way stays in a uniform stream") {
  double const p = 1e9;
  Vec3 const u{500, 300, -200};
  for (bool const finer : {true, false}) {
    OversetSetup setup = cube_in_stream(u, p);
    // about half of the edges are beyond
    setup.remeshing = {.on = true, .shortest = finer ? 0.4 : 0.85, .longest = finer ? 0.9 : 2};
    OversetSolver solver(setup, [=](Vec3 const&) { return GasPoint{780, u, p}; });
    double const volume = mass_properties(solver.bodies()[0]->surface).volume;
    for (int k = 0; k < 10; ++k) REQUIRE(solver.step(1e300).status == StepStatus::ok);
    Body const& b = *solver.bodies()[0];
    LocalRemeshCounts const& counts = solver.counters().remeshing;
    CHECK((finer ? counts.splits : counts.collapses) > 50);
    CHECK(counts.refused == 0);
    CHECK(mass_properties(b.surface).volume == Approx(volume).epsilon(1e-12));
    // as without: round-off of 10 steps
    for (TriangleState const& t : b.triangles) {
      CHECK(std::fabs(t.pressure / p - 1) < 1e-12);
      CHECK(length(t.velocity - u) < 1e-12 * 1300);
      for (SolidFields const& q : t.solid) CHECK(length(velocity_of(q) - u) < 1e-12 * 5000);
      for (GasFields const& q : t.gas) CHECK(std::fabs(q[gas_field::p] / p - 1) < 1e-12);
    }
  }
}

TEST_CASE("new triangles continue what is linear along the sides") {
  OversetSetup const setup = cube_in_stream({0, 0, 0}, 1e9);
  Body body(setup.bodies[0], GasGrid(setup.gas), setup.solid_options);
  auto const linear = [](Vec3 const& x) { return Vec3{3 + x[0] - 2 * x[1], 0.5 * x[2] - x[0], x[0] + x[1] + x[2]}; };
  for (TriangleState& t : body.triangles) t.velocity = linear(t.centre);
  std::size_t const before = body.triangles.size();
  LocalRemeshCounts const counts = remesh(body, {.on = true, .shortest = 0.4, .longest = 0.9});
  CHECK(counts.splits > 50);
  REQUIRE(body.triangles.size() > before + 100);
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    CHECK(length(body.triangles[t].centre - body.surface.centre(t)) < 1e-15);
    CHECK(length(body.triangles[t].velocity - linear(body.triangles[t].centre)) < 1e-12);
  }
}

TEST_CASE("bodies that nothing has reached are left alone, and nothing changes by that") {
  // a pressure that follows from the densities bit by bit, of the solid and of the gas: then a step at rest leaves
  // every bit as it is
  SolidMedium const steel = solid_medium("steel");
  AnyEos const law = IdealGas{1.4};
  double rho = steel.rho0 * 1.0001, p = 0;
  for (GasFields q{}; rho < 1.001 * steel.rho0; rho += 1e-3) {
    p = std::visit([&](auto const& eos) { return eos.pressure(rho, 0.0); }, steel.scheme.eos);
    q = {1, 0, 0, 0, p};
    if (fields_of(law, densities_of(law, q)) == q) break;
  }
  struct Result {
    std::vector<double> numbers;
    OversetCounters counters;
  };
  auto const run = [&](bool skip) {
    OversetSetup setup = cube_in_stream({0, 0, 0}, p, 30);
    setup.bodies[0].initial = [=](Vec3 const&) { return SolidPoint{.rho = rho, .u = {0, 0, 0}, .p = p}; };
    setup.skip = skip, setup.closure = false;
    // the high pressure in a corner reaches the cube on the way
    OversetSolver solver(setup, [=](Vec3 const& x) { return GasPoint{1, {0, 0, 0}, length(x) < 0.13 ? 20 * p : p}; });
    for (int k = 0; k < 25; ++k) REQUIRE(solver.step(1e300).status == StepStatus::ok);
    Result r{.numbers = {}, .counters = solver.counters()};
    Body const& b = *solver.bodies()[0];
    for (TriangleState const& t : b.triangles) {
      r.numbers.push_back(t.pressure);
      for (std::size_t k = 0; k < core_layers; ++k) {
        r.numbers.insert(r.numbers.end(), t.gas[k].begin(), t.gas[k].end());
        r.numbers.insert(r.numbers.end(), t.solid[k].begin(), t.solid[k].end());
      }
    }
    for (Vec3 const& x : b.surface.vertices) r.numbers.insert(r.numbers.end(), x.begin(), x.end());
    Int3 const n = solver.gas().cells();
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i) r.numbers.push_back(solver.gas().average({i, j, k}).energy);
      }
    }
    Vec3 const held = solver.momenta()[0].linear;
    r.numbers.insert(r.numbers.end(), held.begin(), held.end());
    return r;
  };
  Result const with = run(true), without = run(false);
  CHECK(with.counters.skipped > 1000);
  CHECK(with.counters.problems > 1000);
  CHECK(without.counters.skipped == 0);
  CHECK(with.counters.steps == without.counters.steps);
  CHECK((with.numbers == without.numbers));  // not printed: 50000 numbers
}

TEST_CASE("the local grids of a rotating tetrahedron have its rotation, at tips and beyond its sides as well") {
  SolidMedium const steel = solid_medium("steel");
  int const n = 24;
  double const h = 1.0 / n, p = 1e5;
  Vec3 const middle{0.503, 0.507, 0.493}, rate{30, 50, 100};
  auto const rotation = [&](Vec3 const& x) { return cross(rate, x - middle); };
  OversetSetup setup{.gas = gas_cube(IdealGas{1.4}, 1, n), .bodies = {}};
  BodySetup body{.surface = placed(make_tetrahedron(0.6, h), {1, 2, -1}, 0.4, middle),
                 .material = steel.scheme,
                 .cell = h,
                 .initial = [=](Vec3 const& x) {
                   return solid_state(steel, steel.rho0 * (1 + p / 175e9), cross(rate, x - middle), p);
                 }};
  auto const box = bounding_box(body.surface);
  body.lower = box.lower - Vec3{h, h, h}, body.upper = box.upper + Vec3{h, h, h};
  setup.bodies.push_back(std::move(body));
  OversetSolver const solver(setup, [&](Vec3 const&) { return GasPoint{1, {0, 0, 0}, p}; });
  Body const& b = *solver.bodies()[0];
  Body::Nearby nearby(b);
  int behind = 0, beside = 0, other = 0;
  for (std::size_t t = 0; t < b.triangles.size(); ++t) {
    Frame const& f = b.triangles[t].frame;
    ModelStencil const s = b.stencil(t, nearby);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (k == 2 && i != 1 && j != 1) continue;  // never read
          double const depth = (static_cast<double>(k) + 0.5) * h;
          Vec3 const x = b.triangles[t].centre - depth * f.n + ((static_cast<double>(i) - 1) * h) * f.a +
                         ((static_cast<double>(j) - 1) * h) * f.b;
          // sums of some twenty terms
          double const error = length(velocity_of(s.solid_smooth[k][i][j]) - f.into(rotation(x)));
          if (!(error <= 1e-12 * length(rate))) ++other;
          if (s.solid_ghost[k][i][j]) i == 1 && j == 1 ? ++behind : ++beside;
        }
      }
    }
  }
  CHECK(behind > 100);
  CHECK(beside > 1000);
  CHECK(other == 0);
}

TEST_CASE("a stream leaves the tips of a tetrahedron alone") {
  // Round-off that grew at tips would show: untied they bring it to 5e-9 after 300 steps. Stable, it is a few
  // hundred units in the last place: 1e-12.
  CaseResult const r = drift(2, 500, 1, 300, 32);
  CHECK(r.facts.at("deviation_gas") <= 1e-12);
  CHECK(r.facts.at("deviation_solid") <= 1e-12);
  CHECK(r.facts.at("deviation_surface") <= 1e-12);
}

TEST_CASE("a cube that spins keeps its angular momentum") {
  // .5 % in a quarter turn are asked for, .12 % in this part of one. Cores that did not follow their normals lost .2 %.
  CaseOptions o;
  o.threads = 2, o.values = {{"turns", 0.06}};
  CaseResult const r = find_by_name(all_cases(), "body-spin", "test").run(o);
  CAPTURE(r.facts.at("angular_momentum"), r.facts.at("turns_done"));
  CHECK(r.facts.at("turns_done") == Approx(0.06));
  CHECK(std::fabs(r.facts.at("angular_momentum") - 1) < 1.2e-3);
}

TEST_CASE("a yielding cube in a blast has the momentum of its impulse") {
  // Within 4 %, with 11 cells an edge, from 7 us on, when the waves have crossed it five times: 3.1 %. Without a switch
  // in the cores, or with that of the grids, it gains more than a tenth.
  CaseOptions o;
  o.threads = 2, o.cells = 33, o.values = {{"end", 8e-6}};
  CaseResult const r = find_by_name(all_cases(), "cube-blast", "test").run(o);
  CAPTURE(r.facts.at("momentum_less_impulse"), r.facts.at("velocity"));
  CHECK(r.facts.at("velocity") > 50);
  CHECK(std::fabs(r.facts.at("momentum_less_impulse")) < 0.04);
  CHECK(std::fabs(r.facts.at("mass_change")) < 3e-3);
}

TEST_CASE("an elastic sphere keeps the energy with which it breathes") {
  // 8 cells a radius, two periods; by linear fits .69 of the energy would be left
  CaseOptions o;
  o.cells = 40, o.threads = 2, o.values = {{"periods", 2}, {"eighths", 1}};
  CaseResult const r = find_by_name(all_cases(), "breathing-sphere", "test").run(o);
  CAPTURE(r.facts.at("energy_left"), r.facts.at("period_ratio"));
  CHECK(r.facts.at("energy_left") > 0.92);
  CHECK(r.facts.at("energy_left") < 1.005);
  CHECK(std::fabs(r.facts.at("period_ratio") - 1) < 0.01);
}

TEST_CASE("what stays at a wall that gas leaves does not set the time step") {
  // A turned cube in a blast: its lee side lies in near-vacuum from 5 us on. The steps follow from the steel's waves at
  // 1.4, 224 of them; left alone, two cores of gas of a thousandth of the density beside them take 417.
  CaseOptions o;
  o.threads = 2, o.cells = 24, o.values = {{"angle", 0.7}, {"end", 8.5e-6}};
  CaseResult const r = find_by_name(all_cases(), "cube-blast", "test").run(o);
  CAPTURE(r.counters.steps, r.facts.at("cores_renewed"));
  CHECK(r.counters.steps < 260);
  CHECK(r.facts.at("cores_renewed") > 0);
  CHECK(r.facts.at("cores_renewed") < 0.001 * r.facts.at("triangles") * static_cast<double>(r.counters.steps));
}

TEST_CASE("a stream leaves the gas in a gap alone") {
  // Cores of gas within the other body would grow by 2 % a step, to 3e-13 after 300 steps. Tied, round-off stays at a
  // hundred units in the last place, 3e-14; the tolerance lies between.
  CaseResult const r = drift(3, 500, 0.5, 300, 32);
  CHECK(r.facts.at("deviation_gas") <= 1e-13);
  CHECK(r.facts.at("deviation_surface") <= 1e-13);
}

TEST_CASE("results do not depend on the number of threads") {
  CaseOptions o;
  o.cells = 16, o.values = {{"periods", 1}, {"amplitude", 0.01}};
  Case const breathing = find_by_name(all_cases(), "breathing-sphere", "test");
  o.threads = 1;
  CaseResult const one = breathing.run(o);
  o.threads = 2;
  CaseResult const two = breathing.run(o);
  CHECK(one.facts.at("energy_left") == two.facts.at("energy_left"));
}
