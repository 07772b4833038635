/// Bodies in a uniform stream that carries them along: nothing may happen.
#include <algorithm>
#include <cmath>
#include <memory>

#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"body", 0, "1", "0 cube, 1 sphere, 2 tetrahedron, 3 two cubes with a gap", 0, 3, true},
    {"speed", 500, "m/s", "of the stream, along (1, 0.6, -0.4)", 0, 3000},
    {"gap", 1, "1", "between the two cubes, in cells", 0.25, 3},
    {"steps", 100, "1", "time steps", 1, 100000, true},
    {"planes", 0, "1", "of symmetry, across x, y and z, that cut the body: the stream has no velocity across them", 0,
     3, true}};

constexpr double size = 1, edge = 0.25;  ///< of the domain, of the bodies [m]

/// Surfaces about the middle, turned, with edges of a cell.
std::vector<TriangleSurface> surfaces(int body, double h, double gap, Vec3 const& middle) {
  Vec3 const axis{0.3, 0.5, 1};
  double const angle = 0.6, small = 0.5 * edge;
  switch (body) {
    case 1:
      return {placed(make_sphere(0.5 * edge, h), axis, angle, middle)};
    case 2:
      return {placed(make_tetrahedron(1.5 * edge, h), axis, angle, middle)};
    case 3: {
      // side by side along a turned axis
      Vec3 const apart = {0.5 * (small + gap * h), 0, 0};
      TriangleSurface a = make_box({small, small, small}, h), b = a;
      for (Vec3& x : a.vertices) x = x - apart;
      for (Vec3& x : b.vertices) x = x + apart;
      return {placed(a, axis, angle, middle), placed(b, axis, angle, middle)};
    }
    default:
      return {placed(make_box({edge, edge, edge}, h), axis, angle, middle)};
  }
}

/// Largest deviation from the stream so far, each over its own scale: of gas the pressure over the stream's and the
/// velocity over the sound speed; of bodies the stress over K, the velocity over the sound speed; of surfaces the
/// pressure as of gas, the velocity as of bodies.
struct Deviation {
  double gas = 0, solid = 0, surface = 0;
};

}  // namespace

Case freestream_bodies_case() {
  auto const run = [](CaseOptions const& options) {
    SolidMedium const steel = solid_medium("steel");
    double const K = 175e9, p = K / 150, rho = steel.rho0 / 10, c = std::sqrt(1.4 * p / rho);
    int const n = options.cells.value_or(32),
              body = static_cast<int>(std::lround(value_of(parameters, options, "body")));
    double const h = size / n, speed = value_of(parameters, options, "speed");
    Vec3 u = speed * Vec3{1, 0.6, -0.4};
    long const steps = std::lround(value_of(parameters, options, "steps"));
    double const most_dt = options.cfl.value_or(0.8) * h / (3 * steel.sound);
    Vec3 way = (static_cast<double>(steps) * most_dt) * u, middle = Vec3{0.503, 0.507, 0.493} - 0.5 * way;
    OversetProblem problem;
    problem.setup.gas = gas_cube(IdealGas{1.4}, size, n);
    int const planes = static_cast<int>(std::lround(value_of(parameters, options, "planes")));
    if (body == 3 && planes > 0) throw std::invalid_argument("planes: cut one body, not two; take body 0, 1 or 2");
    for (std::size_t a = 0; a < static_cast<std::size_t>(planes); ++a) {
      problem.setup.gas.sides[2 * a].kind = GridBoundary::Kind::wall;
      u[a] = way[a] = middle[a] = 0;
    }
    problem.steps = steps;
    problem.gas = [=](Vec3 const&) { return GasPoint{rho, u, p}; };
    SolidPoint at_rest = solid_state(steel, steel.rho0 * (1 + p / K), u, p);
    for (TriangleSurface& s : surfaces(body, h, value_of(parameters, options, "gap"), middle)) {
      s = clip_at_origin(std::move(s), planes, 0.3 * h);
      BodySetup b{.surface = std::move(s), .material = steel.scheme, .cell = h, .initial = [=](Vec3 const&) {
                    return at_rest;
                  }};
      auto const box = bounding_box(b.surface);
      for (std::size_t a = 0; a < 3; ++a) {
        b.lower[a] = box.lower[a] + std::min(0.0, way[a]) - 0.5 * h;
        b.upper[a] = box.upper[a] + std::max(0.0, way[a]) + 0.5 * h;
        if (static_cast<int>(a) < planes) continue;
        if (b.lower[a] < 2 * h || b.upper[a] > size - 2 * h) {
          throw std::invalid_argument(
              "the bodies would leave the domain: take fewer steps, a lower speed or more cells");
        }
      }
      problem.setup.bodies.push_back(std::move(b));
    }
    auto const most = std::make_shared<Deviation>();
    auto const volumes = std::make_shared<std::vector<double>>();
    problem.after_step = [=](OversetSolver const& solver) {
      if (volumes->empty()) {
        for (auto const& b : solver.bodies()) volumes->push_back(enclosed(*b).volume);
      }
      for (auto const& b : solver.bodies()) {
        for (std::size_t i = 0; i < b->gas.kinds.count(); ++i) {
          if (!b->gas.kinds.valid(i)) continue;
          GasFields const& q = b->gas.states[i];
          most->gas = std::max({most->gas, std::fabs(q[gas_field::p] / p - 1), length(velocity_of(q) - u) / c});
        }
        for (std::size_t i = 0; i < b->solid.kinds.count(); ++i) {
          if (!b->solid.kinds.valid(i)) continue;
          SolidFields const& q = b->solid.states[i];
          most->solid = std::max(
              {most->solid, std::fabs(q[solid_field_of::p] - p) / K, length(velocity_of(q) - u) / steel.sound});
          for (std::size_t k = 0; k < 6; ++k)
            most->solid = std::max(most->solid, std::fabs(q[solid_field_of::S + k]) / K);
        }
        for (TriangleState const& t : b->triangles) {
          most->surface =
              std::max({most->surface, std::fabs(t.pressure / p - 1), length(t.velocity - u) / steel.sound});
        }
      }
      return true;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      r.facts["deviation_gas"] = most->gas, r.facts["deviation_solid"] = most->solid;
      r.facts["deviation_surface"] = most->surface;
      r.facts["cells_travelled"] = length(u) * solver.time() / h;
      double change = 0;
      for (std::size_t b = 0; b < solver.bodies().size(); ++b)
        change = std::max(change, std::fabs(enclosed(*solver.bodies()[b]).volume / volumes->at(b) - 1));
      r.facts["volume_change"] = change;
    };
    return run_problem("freestream-bodies", 32, std::move(problem), options);
  };
  Case out =
      overset_case("freestream-bodies", "steel bodies carried along by a uniform stream: largest deviation from it",
                   "a uniform flow is an exact solution", 32, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
