#include "verification/cases/solid_problem.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "verification/cases/grid_problem.hpp"
#include "verification/cases/grid_run.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/measure/memory.hpp"
#include "verification/measure/norms.hpp"

namespace g27 {

namespace {

using Field = SolidGrid::Field;

Int3 cells_of(SolidProblem const& problem, int cells) {
  if (problem.dimensions == 1) return {cells, 1, 1};
  GridProblem box{.dimensions = problem.dimensions, .lower = problem.lower, .upper = problem.upper};
  return grid_cells(box, cells);
}

SolidGridSetup setup_of(SolidProblem const& problem, int cells, CaseOptions const& options) {
  SolidGridSetup setup{.material = problem.solid,
                       .lower = problem.lower,
                       .upper = problem.upper,
                       .cells = cells_of(problem, cells),
                       .sides = problem.sides,
                       .source = problem.source,
                       .options = {}};
  for (std::size_t d = static_cast<std::size_t>(problem.dimensions); d < 3; ++d) {
    setup.lower[d] = 0, setup.upper[d] = 1;
    setup.sides[2 * d].kind = setup.sides[2 * d + 1].kind = SolidBoundary::Kind::periodic;
  }
  SolidSchemeOptions& o = setup.options;
  o.predictor = options.predictor.value_or(Predictor::linear);
  o.monotonicity = options.monotonicity.value_or(problem.monotonicity);
  o.transverse = options.transverse.value_or(Transverse::own_cell);
  o.cfl = options.cfl.value_or(problem.cfl);
  o.threads = options.threads.value_or(1);
  o.tile = options.tile.value_or(Int3{0, 0, 0});
  return setup;
}

void compare(SolidGrid const& grid, SolidProblem const& problem, SolidMaterial const& material, CaseResult& r) {
  auto const& names = solid_variables();
  std::array<std::vector<double>, 11> value, reference;
  for_each_cell(grid.cells(), [&](Int3 const& cell) {
    Vec3 const x = grid.centre(cell);
    if (problem.compared && !problem.compared(x)) return;
    auto const a = solid_values(grid.primitive(cell));
    auto const b = solid_values(solid_point_of(material, problem.reference(x, grid.widths())));
    for (std::size_t v = 0; v < a.size(); ++v) value[v].push_back(a[v]), reference[v].push_back(b[v]);
  });
  std::vector<double> const measure(value[0].size(), 1.0);
  for (std::size_t v = 0; v < names.size(); ++v) {
    Norms const e = norms(value[v], reference[v], measure);
    r.errors[names[v]] = e;
    r.overshoot[names[v]] = overshoot(value[v], reference[v]);
    if (problem.dimensions == 1) r.profile_ref[names[v]] = reference[v];
  }
  combine_velocity(r);
}

void keep_profile(SolidGrid const& grid, CaseResult& r) {
  auto const& names = solid_variables();
  for (int i = 0; i < grid.cells()[0]; ++i) r.x.push_back(grid.centre({i, 0, 0})[0]);
  for (std::size_t v = 0; v < names.size(); ++v) r.profile[names[v]] = grid.field(static_cast<Field>(v));
  r.profile["plastic_strain"] = grid.field(Field::plastic_strain);
  r.rho = r.profile["density"], r.u = r.profile["velocity_x"], r.p = r.profile["pressure"];
}

GridFields fields_of(SolidGrid const& grid, Vec3 const& lower) {
  auto const single = [&](Field which) {
    std::vector<double> const values = grid.field(which);
    return std::vector<float>(values.begin(), values.end());
  };
  std::vector<float> const none(grid.cell_count(), 0.0f);
  return {.cells = grid.cells(),
          .lower = lower,
          .widths = grid.widths(),
          .density = single(Field::density),
          .velocity_x = single(Field::velocity_x),
          .velocity_y = single(Field::velocity_y),
          .velocity_z = single(Field::velocity_z),
          .pressure = single(Field::pressure),
          .switched = none,
          .cured = none,
          .repaired = none};
}

}  // namespace

std::vector<std::string> const& solid_variables() {
  static std::vector<std::string> const names{"density", "velocity_x", "velocity_y", "velocity_z", "pressure", "sxx",
                                              "syy",     "szz",        "sxy",        "sxz",        "syz"};
  return names;
}

std::array<double, 11> solid_values(SolidPoint const& s) {
  return {s.rho, s.u[0], s.u[1], s.u[2], s.p, s.S[0], s.S[1], s.S[2], s.S[3], s.S[4], s.S[5]};
}

SolidPoint solid_point_of(SolidMaterial const& material, SolidDensities const& q) {
  SolidPoint s{.rho = q.mass, .u = {}, .S = {}, .ep = q.rho_ep / q.mass};
  double kinetic = 0;
  for (std::size_t i = 0; i < 3; ++i) s.u[i] = q.momentum[i] / q.mass, kinetic += 0.5 * s.u[i] * s.u[i];
  for (std::size_t c = 0; c < 6; ++c) s.S[c] = q.rho_S[c] / q.mass;
  s.e = q.energy / q.mass - kinetic;
  s.p = pressure(material.law, s.rho, s.e);
  return s;
}

void make_periodic(SolidProblem& problem) {
  for (SolidBoundary& side : problem.sides) side.kind = SolidBoundary::Kind::periodic;
}

SolidBoundary solid_inflow(std::function<SolidPoint(Vec3 const& x, double t)> state) {
  return {.kind = SolidBoundary::Kind::inflow, .state = std::move(state)};
}

SolidMean solid_mean(int dimensions, std::function<SolidPoint(Vec3 const& x)> state, int points) {
  return [=](Vec3 const& x, Vec3 const& h) {
    return solid_average(state, x, {h[0], dimensions > 1 ? h[1] : 0.0, dimensions > 2 ? h[2] : 0.0}, points);
  };
}

CaseResult run_problem(std::string const& name, int cells, SolidProblem const& problem, SolidMaterial const& material,
                       CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  require_memory(count_of(cells_of(problem, n)), solid_cell_bytes);
  SolidGrid grid(setup_of(problem, n, options));
  grid.set_averages(problem.initial);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  advance(
      name, grid, n, problem.t_end, [&] { return grid.time() < problem.t_end; },
      [&](double dt) {
        if (problem.after_step) problem.after_step(grid, dt);
        if (options.progress) options.progress(grid.time() / problem.t_end);
      });
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.dimensions = problem.dimensions, r.cells = n, r.grid = grid.cells(), r.time = grid.time();
  SolidSchemeOptions const& o = grid.setup().options;
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = options.mesh.value_or("fixed");
  r.eos = std::visit([](auto const& eos) { return std::string(eos.name); }, problem.solid.eos);
  SolidCounters const& c = grid.counters();
  r.counters.steps = c.steps, r.counters.faces = c.faces, r.counters.cell_updates = c.cell_updates;
  r.counters.switched = c.switched, r.counters.retried = c.retried;
  r.ledger = case_ledger(grid.ledger());
  if (problem.dimensions == 1) keep_profile(grid, r);
  if (problem.reference) compare(grid, problem, material, r);
  if (problem.measure) problem.measure(grid, r);
  if (options.fields) r.fields = fields_of(grid, problem.lower);
  return r;
}

}  // namespace g27
