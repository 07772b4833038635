/// An elastic plate that a plane shock meets head on, or that a gas drives, at any angle to the grid.
#include <algorithm>
#include <cmath>
#include <memory>

#include "fsi/overset/gas_integrals.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/exact/struck_plate.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"angle", 0, "rad", "of the plate's normal to x, about z; 0: the plate spans the domain between walls", 0, 0.8},
    {"mach", 3, "1", "of the shock", 1.01, 10},
    {"drive", 0, "1", "pressure of the gas in front over that behind, both at rest and of one temperature; 0: a shock",
     0, 1e4},
    {"ahead", 0, "1", "way of the shock to the plate, in thicknesses; 0: it has come to it", 0, 2},
    {"shift", 0, "1", "of the plate along x, in cells", -4, 4},
    {"density", 300, "1", "of the plate over the gas's", 1, 1e5},
    {"stiffness", 5e4, "1", "K + 4 mu/3 of the plate over the gas's pressure", 100, 1e8},
    {"width", 8, "1", "of a plate at an angle, in thicknesses", 2, 40},
    {"solid_cell", 1, "1", "of the plate, over the gas's", 0.25, 4},
    {"crossings", 4, "1", "end: when waves have crossed the plate this often", 0.1, 100},
    literal_parameter()};

// units: the plate's thickness, density and pressure of the gas ahead; of one that drives the plate, in front
constexpr double before = 2.5, behind = 1.5;  ///< room along the normal
constexpr int across = 4;                     ///< cells between walls

struct History {
  std::vector<double> time, front, back, pressure, gas_mass, gas_momentum, gas_energy, momentum, impulse;
  std::vector<double> exact_front, exact_pressure;
};

struct Held {
  double mass = 0, momentum = 0, energy = 0;  ///< momentum along the normal
};

/// Means over the triangles of a face near the middle.
struct Face {
  double area = 0, place = 0, velocity = 0, pressure = 0;
};

Face face(Body const& b, Vec3 const& normal, Vec3 const& middle, double within) {
  Face f;
  for (TriangleState const& t : b.triangles) {
    Vec3 const r = t.centre - middle;
    Vec3 const along = r - dot(r, normal) * normal;
    if (dot(t.at_start, normal) < 0.9 || std::hypot(along[0], along[1]) > within) continue;
    f.area += t.area, f.place += t.area * dot(r, normal), f.velocity += t.area * dot(t.velocity, normal);
    f.pressure += t.area * t.pressure;
  }
  f.place /= f.area, f.velocity /= f.area, f.pressure /= f.area;
  return f;
}

}  // namespace

Case struck_plate_case() {
  Case out = overset_case("struck-plate",
                          "plane shock meets an elastic plate, or gas drives it: motion, momentum and impulse, ledger",
                          "verification/exact/struck_plate.hpp: method of characteristics", 10, parameters);
  out.run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(10);
    double const h = 1.0 / n, angle = value("angle"), rho = value("density"), M = value("stiffness");
    double const hs = h * value("solid_cell");
    bool const spans = angle == 0;
    // nu = 0.3: K = 13/21 M
    double const K = 13.0 / 21 * M, mu = 0.75 * (M - K), mach = value("mach");
    Vec3 const normal{std::cos(angle), std::sin(angle), 0}, along{-normal[1], normal[0], 0};
    double const drive = value("drive"), p_back = drive > 0 ? 1 / drive : 1;
    bool const driven = drive > 0;
    if (drive == 1) throw std::invalid_argument("drive: gases of one pressure drive nothing; take another ratio, or 0");
    StruckPlate::Gas const at_back{1.4, p_back, p_back};
    StruckPlate::Front const in_front =
        driven ? StruckPlate::Front{1, 0, 1, 0} : StruckPlate::behind_shock(at_back, mach);
    double const arrival = driven ? 0 : value("ahead") / in_front.shock_speed;
    double const followed = value("crossings") * std::sqrt(rho / M), t_end = arrival + followed;
    auto const exact = std::make_shared<StruckPlate>(in_front, at_back, StruckPlate::Plate{1, rho, M}, followed);
    // the middle of the front face
    Vec3 const middle = spans ? Vec3{value("shift") * h, 0, 0} : (value("shift") * h - 0.5) * normal;
    double const from = dot(middle, normal);
    auto const gas_at = [=](Vec3 const& x, double t) {
      // gases at rest meet beside the plate in its middle plane
      double const end = driven ? 0.5 : in_front.shock_speed * (t - arrival);
      return dot(x, normal) - from < end ? GasPoint{in_front.rho, in_front.u * normal, in_front.p}
                                         : GasPoint{at_back.rho, {0, 0, 0}, at_back.p};
    };
    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{1.4};
    double const width = value("width");
    for (std::size_t a = 0; a < 3; ++a) {
      int low = 0, high = 0;
      if (a == 2 || (spans && a == 1)) {
        low = -across / 2, high = across / 2;
        gas.sides[2 * a].kind = gas.sides[2 * a + 1].kind = GridBoundary::Kind::wall;
      } else if (spans) {
        low = -static_cast<int>(std::lround(before * n)), high = static_cast<int>(std::lround((1 + behind) * n));
      } else {
        double const half = 0.5 * width * std::fabs(along[a]) + 0.5 * std::fabs(normal[a]);
        low = -static_cast<int>(std::ceil((half + before * std::fabs(normal[a])) * n)) - 8;
        high = static_cast<int>(std::ceil((half + behind * std::fabs(normal[a])) * n)) + 8;
      }
      gas.lower[a] = low * h, gas.upper[a] = high * h, gas.cells[a] = high - low;
      if (gas.sides[2 * a].kind == GridBoundary::Kind::wall) continue;
      for (std::size_t side = 2 * a; side < 2 * a + 2; ++side) {
        gas.sides[side] = {.kind = GridBoundary::Kind::inflow, .state = gas_at};
      }
    }
    problem.gas = [=](Vec3 const& x) { return gas_at(x, 0); };
    // cells that the shock cuts take their parts
    problem.setup.gas_cells = [=, lower = gas.lower, eos = gas.eos](Int3 const& c) {
      constexpr int parts = 16;
      GasDensities mean{};
      for (int i = 0; i < parts; ++i) {
        for (int j = 0; j < parts; ++j) {
          Vec3 const x{lower[0] + (c[0] + (i + 0.5) / parts) * h, lower[1] + (c[1] + (j + 0.5) / parts) * h, 0};
          GasPoint const s = gas_at(x, 0);
          GasDensities const q = densities_of(eos, GasFields{s.rho, s.u[0], s.u[1], s.u[2], s.p});
          double const w = 1.0 / (parts * parts);
          mean.mass += w * q.mass, mean.momentum = mean.momentum + w * q.momentum, mean.energy += w * q.energy;
        }
      }
      return mean;
    };
    problem.t_end = t_end;
    problem.setup.literal = literal_reading(value_of(parameters, options, "literal"));
    problem.setup.solid_options.cfl = largest_parabolic_body_cfl;
    double const span = 3 * across * h, edge = 0.9 * hs;
    TriangleSurface surface =
        placed(make_box({1, spans ? span : width, span}, edge), {0, 0, 1}, angle, middle + 0.5 * normal);
    for (std::size_t a = spans ? 1 : 2; a < 3; ++a) {
      surface = clip_surface(std::move(surface), a, gas.lower[a], true, 0.3 * hs);
      surface = clip_surface(std::move(surface), a, gas.upper[a], false, 0.3 * hs);
    }
    BodySetup body{.surface = std::move(surface),
                   .material = {.eos = BulkModulus{rho, K}, .mu = mu},
                   .cell = hs,
                   .initial = [=](Vec3 const&) { return SolidPoint{.rho = rho * (1 + p_back / K), .p = p_back}; }};
    auto const box = bounding_box(body.surface);
    body.lower = box.lower - Vec3{2 * h, 2 * h, 0}, body.upper = box.upper + Vec3{2 * h, 2 * h, 0};
    problem.setup.bodies.push_back(std::move(body));

    auto const history = std::make_shared<History>();
    auto const start = std::make_shared<Held>();
    double const within = spans ? 1e300 : 0.5;
    problem.after_step = [=](OversetSolver const& solver) {
      Body const& b = *solver.bodies()[0];
      History& k = *history;
      GasIntegrals const now = gas_integrals(solver);
      GridLedger const ledger = solver.gas().ledger();
      BodyMomentum const& held = solver.momenta()[0];
      // what the gas holds less what came through the sides and the contact
      Vec3 rest = now.momentum + held.linear;
      for (std::size_t a = 0; a < 3; ++a) rest[a] -= ledger.momentum[a].through_boundary;
      Held const unaccounted{now.mass - ledger.mass.through_boundary, dot(rest, normal),
                             now.energy + held.work - ledger.energy.through_boundary};
      if (k.time.empty()) *start = unaccounted;
      k.time.push_back(solver.time() - arrival);
      Face const front = face(b, -1.0 * normal, middle, within), back = face(b, normal, middle, within);
      k.front.push_back(-front.place), k.back.push_back(back.place - 1), k.pressure.push_back(front.pressure);
      k.gas_mass.push_back(unaccounted.mass - start->mass);
      k.gas_momentum.push_back(unaccounted.momentum - start->momentum);
      k.gas_energy.push_back(unaccounted.energy - start->energy);
      k.exact_front.push_back(exact->displacement(0, k.time.back()));
      k.exact_pressure.push_back(exact->pressure(0, k.time.back()));
      k.momentum.push_back(dot(integrals(b).momentum, normal)), k.impulse.push_back(dot(held.linear, normal));
      return true;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      History const& k = *history;
      double const t = k.time.back(), area = spans ? across * h * across * h : width * across * h;
      double const impulse = k.impulse.back();
      double const moved = exact->displacement(0, t);
      // of the pressure at the contact above that of the gas at rest, from the arrival
      double pushed = 0, exact_push = 0;
      for (std::size_t i = 0; i < k.time.size(); ++i) {
        double const dt = k.time[i] - std::max(0.0, i > 0 ? k.time[i - 1] : -arrival);
        if (dt > 0) pushed += dt * (k.pressure[i] - p_back), exact_push += dt * (k.exact_pressure[i] - p_back);
      }
      r.facts["push_error"] = pushed / exact_push - 1;
      r.facts["displacement"] = moved, r.facts["displacement_in_cells"] = moved / h;
      r.facts["front_error"] = k.front.back() / moved - 1;
      r.facts["back_error"] = k.back.back() / exact->displacement(1, t) - 1;
      r.facts["momentum_less_impulse"] = k.momentum.back() / impulse - 1;
      r.facts["contact_pressure"] = k.pressure.back(), r.facts["exact_pressure"] = exact->pressure(0, t);
      r.facts["gas_mass_rest_in_cells"] = k.gas_mass.back() / (in_front.rho * area * h);
      r.facts["gas_momentum_rest_over_impulse"] = k.gas_momentum.back() / impulse;
      r.facts["gas_energy_rest_in_cells"] = k.gas_energy.back() / (in_front.p / 0.4 * area * h);
      // along the normal through the middle
      GasGrid const& g = solver.gas();
      for (int i = 1; i < 2 * n; ++i) {
        double const d = 0.5 * i * h;
        Vec3 const x = middle - d * normal;
        Int3 c{};
        for (std::size_t a = 0; a < 3; ++a)
          c[a] = std::clamp(static_cast<int>(std::floor((x[a] - g.setup().lower[a]) / h)), 0, g.cells()[a] - 1);
        GasPoint const q = g.primitive(c);
        r.x.push_back(dot(g.centre(c) - middle, normal)), r.rho.push_back(q.rho), r.p.push_back(q.p);
        r.u.push_back(dot(q.u, normal));
      }
      r.profile["time"] = k.time, r.profile["front"] = k.front, r.profile["back"] = k.back;
      r.profile["pressure"] = k.pressure, r.profile["gas_mass"] = k.gas_mass;
      r.profile["gas_momentum"] = k.gas_momentum, r.profile["gas_energy"] = k.gas_energy;
      r.profile["exact_front"] = k.exact_front, r.profile["exact_pressure"] = k.exact_pressure;
      r.profile["momentum"] = k.momentum, r.profile["impulse"] = k.impulse;
    };
    return run_problem("struck-plate", 10, std::move(problem), options);
  };
  return out;
}

}  // namespace g27
