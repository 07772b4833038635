/// A rigid slab closes a tube: the gas behind it drives it into the gas ahead.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/exact/rigid_piston.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"density", 1, "1", "of the slab, over 1/1.4 of that of the gas behind it", 0.01, 1e5},
    {"ahead", 0.5, "1", "pressure and density ahead over those behind", 0.05, 0.95},
    {"begin", 0.3, "1", "of the run, over the time at which the wave ahead breaks; 0: at rest", 0, 0.9},
    {"end", 0.9, "1", "of the run", 0.01, 1},
    {"shift", 0.3, "1", "of the slab along the tube, in cells", 0, 1}};

// units: pressure and sound speed behind the slab; its thickness is half a unit
constexpr double thickness = 0.5, gamma = 1.4;
constexpr int across = 4;  ///< cells between walls

}  // namespace

Case rigid_piston_case() {
  auto const run = [](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    int const n = options.cells.value_or(20);
    double const h = 1.0 / n, ahead = value("ahead"), shift = value("shift") * h;
    RigidPiston::Setup setup{.behind = {gamma, gamma, 1},
                             .ahead = {gamma, gamma * ahead, ahead},
                             .mass_per_area = value("density") * thickness};
    double const breaks = RigidPiston(setup).breaking_time(), begin = value("begin") * breaks;
    setup.t_end = value("end") * breaks;
    if (!(setup.t_end > begin)) throw std::invalid_argument("begin is not before the end");
    auto const exact = std::make_shared<RigidPiston const>(setup);
    // the piston's faces come together at x = 0, and stand apart by the slab
    double const t_end = setup.t_end, back = shift - exact->position(begin), way = exact->position(t_end) + back;

    OversetProblem problem;
    GasGridSetup& gas = problem.setup.gas;
    gas.eos = IdealGas{gamma};
    // the waves do not come to the ends
    int const behind = static_cast<int>(std::ceil((t_end + 0.2) * n)), room = behind + static_cast<int>(way * n);
    gas.lower = {-behind * h, -0.5 * across * h, -0.5 * across * h};
    gas.cells = {behind + room + n / 2, across, across};
    for (std::size_t a = 0; a < 3; ++a) gas.upper[a] = gas.lower[a] + gas.cells[a] * h;
    for (std::size_t side = 2; side < 6; ++side) gas.sides[side].kind = GridBoundary::Kind::wall;
    problem.gas = [=](Vec3 const& x) {
      bool const before = x[0] > shift + 0.5 * thickness;
      GasState<> const s = before ? exact->ahead(x[0] - thickness - back, begin) : exact->behind(x[0] - back, begin);
      return GasPoint{s.rho, {s.u, 0, 0}, s.p};
    };
    problem.setup.start = begin;
    problem.t_end = t_end;
    double const span = 3 * across * h;
    TriangleSurface surface =
        placed(make_box({thickness, span, span}, 0.9 * h), {0, 0, 1}, 0, {shift + 0.5 * thickness, 0, 0});
    for (std::size_t a = 1; a < 3; ++a) {
      surface = clip_surface(std::move(surface), a, gas.lower[a], true, 0.3 * h);
      surface = clip_surface(std::move(surface), a, gas.upper[a], false, 0.3 * h);
    }
    problem.setup.bodies.push_back(
        {.surface = std::move(surface),
         .cell = h,
         .lower = {-2 * h, gas.lower[1], gas.lower[2]},
         .upper = {thickness + way + 2 * h, gas.upper[1], gas.upper[2]},
         .initial = {},
         .rigid = RigidSetup{.density = value("density"), .velocity = {exact->velocity(begin), 0, 0}}});

    struct History {
      std::vector<double> time, position, velocity, exact_position, exact_velocity;
    };
    auto const history = std::make_shared<History>();
    problem.after_step = [=](OversetSolver const& solver) {
      RigidBody const& rigid = *solver.bodies()[0]->rigid;
      double const t = solver.time();
      history->time.push_back(t), history->position.push_back(rigid.state.centre[0] - 0.5 * thickness - back);
      history->velocity.push_back(rigid.motion().velocity[0]);
      history->exact_position.push_back(exact->position(t)), history->exact_velocity.push_back(exact->velocity(t));
      return true;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      History const& k = *history;
      auto const norms = [&](std::vector<double> const& got, std::vector<double> const& want) {
        Norms out;
        for (std::size_t i = 0; i < got.size(); ++i) {
          double const dt = k.time[i] - (i > 0 ? k.time[i - 1] : begin), error = std::fabs(got[i] - want[i]);
          double const share = dt / (t_end - begin);
          out.l1 += share * error, out.l2 += share * error * error, out.linf = std::max(out.linf, error);
        }
        out.l2 = std::sqrt(out.l2);
        return out;
      };
      r.errors["position"] = norms(k.position, k.exact_position);
      r.errors["velocity"] = norms(k.velocity, k.exact_velocity);
      double const moved = exact->position(t_end) - exact->position(begin);
      r.facts["way"] = moved, r.facts["way_in_cells"] = moved / h, r.facts["end_velocity"] = exact->velocity(t_end);
      r.facts["position_error"] = k.position.back() - exact->position(t_end);
      r.facts["velocity_error"] = k.velocity.back() - exact->velocity(t_end);
      Body const& body = *solver.bodies()[0];
      r.facts["momentum_less_impulse"] = body.rigid->state.momentum[0] - solver.momenta()[0].linear[0];
      r.facts["turned"] = 2 * std::acos(std::min(1.0, body.rigid->state.rotation[0]));
      r.profile["time"] = k.time, r.profile["position"] = k.position, r.profile["velocity"] = k.velocity;
      r.profile["exact_position"] = k.exact_position, r.profile["exact_velocity"] = k.exact_velocity;
    };
    return run_problem("rigid-piston", 20, std::move(problem), options);
  };
  Case out = overset_case("rigid-piston", "rigid slab that gas drives along a tube: position and velocity",
                          "verification/exact/rigid_piston.hpp: simple waves on both sides", 20, parameters);
  out.run = run;
  return out;
}

}  // namespace g27
