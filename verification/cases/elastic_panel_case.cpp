/// A steel panel that stands clamped in a shock tube (Giordano et al., Shock Waves 14 (2005) 103).
#include <algorithm>
#include <cmath>
#include <memory>

#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/standing_plate.hpp"
#include "verification/exact/struck_plate.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"height", 0.05, "m", "of the panel", 0.01, 0.06},
    {"thickness", 1e-3, "m", "of the panel", 5e-4, 0.01},
    {"as_thick", 8e-3, "m", "thickness of the plate that stands for it, of the same mass and bending stiffness", 5e-4,
     0.01},
    {"mach", 1.21, "1", "of the shock", 1.01, 3},
    {"upstream", 0.3, "m", "gas before the panel: waves that it sends back come to that side", 0.03, 2},
    {"end", 1.7e-3, "s", "time", 1e-7, 1e-2}};

// the tube above the step that the panel stands on, and the way from the panel's front to the end wall
constexpr double channel = 0.065, to_end_wall = 0.25;
constexpr double panel_young = 220e9, poisson = 0.33, panel_density = 7600;
constexpr double ambient = 1.01e5, ambient_density = 1.2;
constexpr double shock_from = -0.02;   ///< where the shock starts: x before the panel [m]
constexpr double gauge_before = 0.01;  ///< distance of the gauge in the upper wall from the panel [m]

struct History {
  std::vector<double> time, tip, gauge;
};

}  // namespace

Case elastic_panel_case() {
  Case out = overset_case("elastic-panel",
                          "steel panel of 1 mm clamped in a shock tube, as a thicker plate: deflection of its tip",
                          "Giordano et al., Shock Waves 14 (2005) 103: measured, no exact solution", 8, parameters);
  out.run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(8);
    double const thickness = value("as_thick"), height = value("height");
    // waves cross a plate of k times the thickness as slowly as it takes for k^2 times the time step in cells
    double const k = thickness / value("thickness"), young = panel_young / (k * k * k), density = panel_density / k;
    // one cell of gas between the planes of symmetry, four of the panel; a whole number of them up the tube
    int const up = std::max(4, static_cast<int>(std::lround(channel * n / (4 * thickness))));
    double const h_gas = channel / up, h = h_gas / 4;
    StandingPlate const plate{.thickness = thickness, .height = height, .width = h_gas, .cell = h};
    int const before = static_cast<int>(std::lround(value("upstream") / h_gas));
    int const behind = static_cast<int>(std::lround(to_end_wall / h_gas));
    StruckPlate::Gas const air{1.4, ambient_density, ambient};
    StruckPlate::Front const shocked = StruckPlate::behind_shock(air, value("mach"));
    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{1.4};
    gas.cells = {before + behind, up, 1};
    gas.lower = {-before * h_gas, 0, 0}, gas.upper = {behind * h_gas, channel, h_gas};
    GasPoint const driven{shocked.rho, {shocked.u, 0, 0}, shocked.p};
    for (GridBoundary& side : gas.sides) side.kind = GridBoundary::Kind::wall;
    gas.sides[0] = {.kind = GridBoundary::Kind::inflow, .state = [=](Vec3 const&, double) { return driven; }};
    problem.gas = [=](Vec3 const& x) {
      return x[0] < shock_from ? driven : GasPoint{ambient_density, {0, 0, 0}, ambient};
    };
    problem.t_end = value("end");
    problem.setup.remeshing.on = false;
    problem.setup.solid_options.cfl =
        options.predictor == Predictor::parabolic ? largest_parabolic_body_cfl : largest_body_cfl;
    double const room = 0.3 * height;
    problem.setup.bodies.push_back(body_of(plate, elastic_material(density, young, poisson), ambient, room));
    Int3 const gauge{before - static_cast<int>(std::lround(gauge_before / h_gas)), up - 1, 0};
    auto const history = std::make_shared<History>();
    problem.after_step = [=](OversetSolver const& solver) {
      History& past = *history;
      if (!past.time.empty() && solver.time() < past.time.back() + 1e-6 &&
          solver.time() < value_of(parameters, options, "end"))
        return true;
      past.time.push_back(solver.time());
      past.tip.push_back(tip_displacement(solver.bodies()[0]->surface, plate));
      past.gauge.push_back(solver.gas().primitive(gauge).p);
      return std::isfinite(past.tip.back()) && std::fabs(past.tip.back()) < room;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      History const& past = *history;
      auto const peak = std::max_element(past.tip.begin(), past.tip.end());
      r.facts["peak"] = *peak, r.facts["peak_time"] = past.time[static_cast<std::size_t>(peak - past.tip.begin())];
      r.facts["gauge_largest"] = *std::max_element(past.gauge.begin(), past.gauge.end());
      r.facts["cells_across"] = thickness / plate.cell, r.facts["steps"] = static_cast<double>(solver.counters().steps);
      r.profile["time"] = past.time, r.profile["tip"] = past.tip, r.profile["gauge"] = past.gauge;
    };
    return run_problem("elastic-panel", 8, std::move(problem), options);
  };
  return out;
}

}  // namespace g27
