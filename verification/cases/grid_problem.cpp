#include "verification/cases/grid_problem.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "riemann/eos/factory.hpp"
#include "verification/cases/grid_run.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/measure/memory.hpp"
#include "verification/measure/norms.hpp"

namespace g27 {

namespace {

using Field = GasGrid::Field;

GasGridSetup setup_of(GridProblem const& problem, int cells, CaseOptions const& options) {
  GasGridSetup setup{.eos = problem.eos,
                     .lower = problem.lower,
                     .upper = problem.upper,
                     .cells = grid_cells(problem, cells),
                     .sides = problem.sides,
                     .patches = problem.patches,
                     .blocks = {},
                     .source = problem.source,
                     .burn = problem.burn,
                     .options = {}};
  for (std::size_t d = static_cast<std::size_t>(problem.dimensions); d < 3; ++d) {
    setup.lower[d] = 0, setup.upper[d] = 1;
    setup.sides[2 * d] = setup.sides[2 * d + 1] = periodic_side;
  }
  for (SolidBox const& box : problem.blocks) {
    SolidBlock block{{0, 0, 0}, setup.cells};
    for (std::size_t d = 0; d < static_cast<std::size_t>(problem.dimensions); ++d) {
      double const per_width = setup.cells[d] / (setup.upper[d] - setup.lower[d]);
      auto const face = [&](double x) {
        return std::clamp(static_cast<int>(std::lround((x - setup.lower[d]) * per_width)), 0, setup.cells[d]);
      };
      block.first[d] = face(box.lower[d]), block.last[d] = face(box.upper[d]);
    }
    setup.blocks.push_back(block);
  }
  GridSchemeOptions& o = setup.options;
  o.predictor = options.predictor.value_or(Predictor::linear);
  o.monotonicity = options.monotonicity.value_or(problem.monotonicity);
  o.riemann = options.riemann.value_or(RiemannSolver::fast);
  o.transverse = options.transverse.value_or(Transverse::own_cell);
  o.linear_star = options.linear_star.value_or(true);
  o.cure = options.cure.value_or(true);
  o.skip = options.skip.value_or(true);
  o.maps = options.fields;
  o.cfl = options.cfl.value_or(problem.cfl);
  o.threads = options.threads.value_or(1);
  o.tile = options.tile.value_or(Int3{0, 0, 0});
  return setup;
}

void compare(GasGrid const& grid, GridProblem const& problem, CaseResult& r) {
  static char const* const names[] = {"density", "velocity_x", "velocity_y", "velocity_z", "pressure"};
  std::array<std::vector<double>, 5> value, reference;
  for_each_cell(grid.cells(), [&](Int3 const& cell) {
    Vec3 const x = grid.centre(cell);
    if (grid.solid(cell) || (problem.compared && !problem.compared(x))) return;
    GasPoint const a = grid.primitive(cell), b = point_of(problem.eos, problem.reference(x, grid.widths()));
    auto const hold = [&](std::size_t k, double held, double against) {
      value[k].push_back(held), reference[k].push_back(against);
    };
    hold(0, a.rho, b.rho), hold(4, a.p, b.p);
    for (std::size_t d = 0; d < 3; ++d) hold(d + 1, a.u[d], b.u[d]);
  });
  std::vector<double> const measure(value[0].size(), 1.0);
  for (std::size_t k = 0; k < 5; ++k) {
    bool const component = k >= 1 && k <= 3;
    if (component && static_cast<int>(k) > problem.dimensions) continue;
    Norms const e = norms(value[k], reference[k], measure);
    r.errors[names[k]] = e;
    if (!component) r.overshoot[names[k]] = overshoot(value[k], reference[k]);
  }
  combine_velocity(r);
}

GridFields fields_of(GasGrid const& grid, Vec3 const& lower) {
  auto const single = [&](Field which) {
    std::vector<double> const values = grid.field(which);
    return std::vector<float>(values.begin(), values.end());
  };
  return {.cells = grid.cells(),
          .lower = lower,
          .widths = grid.widths(),
          .density = single(Field::density),
          .velocity_x = single(Field::velocity_x),
          .velocity_y = single(Field::velocity_y),
          .velocity_z = single(Field::velocity_z),
          .pressure = single(Field::pressure),
          .switched = single(Field::switched),
          .cured = single(Field::cured),
          .repaired = single(Field::repaired)};
}

}  // namespace

GridBoundary inflow_side(std::function<GasPoint(Vec3 const& x, double t)> state) {
  return {.kind = GridBoundary::Kind::inflow, .state = std::move(state)};
}

void make_periodic(GridProblem& problem) { problem.sides.fill(periodic_side); }

std::vector<std::string> grid_meshes(bool with_frame) {
  return with_frame ? std::vector<std::string>{"fixed", "frame"} : std::vector<std::string>{"fixed"};
}

Int3 grid_cells(GridProblem const& problem, int cells) {
  Int3 n{1, 1, 1};
  double longest = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(problem.dimensions); ++d)
    longest = std::max(longest, problem.upper[d] - problem.lower[d]);
  for (std::size_t d = 0; d < static_cast<std::size_t>(problem.dimensions); ++d) {
    double const share = (problem.upper[d] - problem.lower[d]) / longest;
    n[d] = std::max(4, static_cast<int>(std::lround(cells * share)));
  }
  return n;
}

CaseResult run_problem(std::string const& name, int cells, GridProblem problem, CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  require_memory(count_of(grid_cells(problem, n)), gas_cell_bytes);
  GasGrid grid(setup_of(problem, n, options));
  grid.set_averages(problem.initial);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  advance(
      name, grid, n, problem.steps > 0 ? 1e300 : problem.t_end,
      [&] {
        return problem.steps > 0 ? grid.counters().steps < static_cast<std::uint64_t>(problem.steps)
                                 : grid.time() < problem.t_end;
      },
      [&](double) {
        if (!options.progress) return;
        options.progress(problem.steps > 0
                             ? static_cast<double>(grid.counters().steps) / static_cast<double>(problem.steps)
                             : grid.time() / problem.t_end);
      });
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.dimensions = problem.dimensions, r.cells = n, r.grid = grid.cells(), r.time = grid.time();
  GridSchemeOptions const& o = grid.setup().options;
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = options.mesh.value_or("fixed"), r.eos = eos_name(problem.eos);
  r.counters = grid.counters();
  r.ledger = case_ledger(grid.ledger());
  if (problem.reference) compare(grid, problem, r);
  if (problem.measure) problem.measure(grid, r);
  if (options.fields) r.fields = fields_of(grid, problem.lower);
  return r;
}

}  // namespace g27
