/// Free bending of an elastic plate that is clamped at one end, in its first mode.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/standing_plate.hpp"
#include "verification/exact/clamped_beam.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"slenderness", 10, "1", "height over thickness", 4, 100},
    {"periods", 1, "1", "end, in periods of the thin beam", 0.01, 20},
    {"amplitude", 0.02, "1", "of the tip, over the thickness", 1e-6, 1},
    {"body_cfl", largest_body_cfl, "1", "of the plate's waves", 0.1, largest_body_cfl}};

// units: thickness, density and Young's modulus of the plate
constexpr double poisson = 0.33;

struct History {
  std::vector<double> time, tip;
};

/// Times where the tip comes through its place at rest, and how far it goes between them.
struct Swings {
  std::vector<double> crossing, farthest;
};

Swings swings_of(History const& h) {
  Swings out;
  double farthest = 0;
  for (std::size_t i = 1; i < h.time.size(); ++i) {
    double const a = h.tip[i - 1], b = h.tip[i];
    farthest = std::max(farthest, std::fabs(b));
    if (a * b > 0 || a == 0) continue;
    out.crossing.push_back(h.time[i - 1] + a / (a - b) * (h.time[i] - h.time[i - 1]));
    out.farthest.push_back(farthest), farthest = 0;
  }
  return out;
}

}  // namespace

Case clamped_beam_case() {
  Case out = overset_case(
      "clamped-beam", "plate clamped at one end swings in its first mode: frequency and damping",
      "verification/exact/clamped_beam.hpp: 1.8751^2 sqrt(E I/((1 - nu^2) rho A L^4)), and with shear", 4, parameters);
  out.run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(4);
    double const h = 1.0 / n, L = value("slenderness");
    ClampedBeam const beam{.thickness = 1, .length = L, .density = 1, .young = 1, .poisson = poisson};
    double const frequency = beam.thin(), period = 2 * std::numbers::pi / frequency;
    double const speed = value("amplitude") * frequency;
    // gas so thin that its pressure and its inertia are nothing to the plate; its one cell spans the walls
    double const rho_gas = 1e-7, p = 1e-9, h_gas = 4 * h, room = 2;
    StandingPlate const plate{.thickness = 1, .height = L, .width = h_gas, .cell = h};
    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{1.4};
    int const beside = static_cast<int>(std::ceil((room + 1) / h_gas)) + 4;
    int const above = static_cast<int>(std::ceil((L + room) / h_gas)) + 4;
    gas.cells = {2 * beside, above, 1};
    gas.lower = {0.5 - beside * h_gas, 0, 0}, gas.upper = {0.5 + beside * h_gas, above * h_gas, h_gas};
    for (std::size_t side : {2u, 4u, 5u}) gas.sides[side].kind = GridBoundary::Kind::wall;
    problem.gas = [=](Vec3 const&) { return GasPoint{rho_gas, {0, 0, 0}, p}; };
    problem.t_end = value("periods") * period;
    problem.setup.remeshing.on = false;
    problem.setup.solid_options.cfl = options.predictor == Predictor::parabolic
                                          ? std::min(value("body_cfl"), largest_parabolic_body_cfl)
                                          : value("body_cfl");
    BodySetup body = body_of(plate, elastic_material(1, 1, poisson), p, room);
    body.initial = [=, rest = body.initial](Vec3 const& x) {
      ClampedBeam::Mode const mode = beam.mode(x[1]);
      SolidPoint state = rest(x);
      state.u = {speed * mode.value, -speed * (x[0] - 0.5) * mode.slope, 0};
      return state;
    };
    problem.setup.bodies.push_back(std::move(body));
    auto const history = std::make_shared<History>();
    problem.after_step = [=](OversetSolver const& solver) {
      history->time.push_back(solver.time());
      history->tip.push_back(tip_displacement(solver.bodies()[0]->surface, plate));
      return std::isfinite(history->tip.back()) && std::fabs(history->tip.back()) < room;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      Swings const s = swings_of(*history);
      // half a period lies between two crossings; the start is one
      if (!s.crossing.empty()) {
        double const half = s.crossing.back() / static_cast<double>(s.crossing.size());
        r.facts["frequency_error"] = std::numbers::pi / half / beam.thick() - 1;
        r.facts["frequency_over_thin"] = std::numbers::pi / half / frequency - 1;
        r.facts["first_swing"] = s.farthest.front() / value_of(parameters, options, "amplitude");
      }
      if (s.farthest.size() > 1) {
        double const swings = static_cast<double>(s.farthest.size() - 1);
        r.facts["left_per_period"] = std::pow(s.farthest.back() / s.farthest.front(), 2 / swings);
      }
      r.facts["period"] = period, r.facts["steps"] = static_cast<double>(solver.counters().steps);
      r.profile["time"] = history->time, r.profile["tip"] = history->tip;
    };
    return run_problem("clamped-beam", 4, std::move(problem), options);
  };
  return out;
}

}  // namespace g27
