#include "verification/cases/overset_problem.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "fsi/surface/clip.hpp"
#include "riemann/eos/factory.hpp"
#include "verification/cases/grid_run.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/measure/memory.hpp"

namespace g27 {

GasGridSetup gas_cube(AnyEos const& eos, double size, int cells) {
  return {.eos = eos, .lower = {0, 0, 0}, .upper = {size, size, size}, .cells = {cells, cells, cells}};
}

GasGridSetup symmetric_cube(AnyEos const& eos, double size, int cells, int planes) {
  GasGridSetup s{.eos = eos};
  for (std::size_t a = 0; a < 3; ++a) {
    bool const cut = static_cast<int>(a) < planes;
    s.lower[a] = cut ? 0 : -0.5 * size, s.upper[a] = 0.5 * size, s.cells[a] = cut ? cells / 2 : cells;
    if (cut) s.sides[2 * a].kind = GridBoundary::Kind::wall;
  }
  return s;
}

TriangleSurface clip_at_origin(TriangleSurface s, int planes, double snap) {
  for (int a = 0; a < planes; ++a) s = clip_surface(std::move(s), static_cast<std::size_t>(a), 0, true, snap);
  return s;
}

TriangleSurface placed(TriangleSurface surface, Vec3 const& axis, double angle, Vec3 const& centre) {
  Vec3 const k = (1 / length(axis)) * axis;
  // Rodrigues' formula
  for (Vec3& x : surface.vertices) {
    x = std::cos(angle) * x + std::sin(angle) * cross(k, x) + ((1 - std::cos(angle)) * dot(k, x)) * k + centre;
  }
  return surface;
}

CaseParameter literal_parameter() {
  return {"literal",
          0,
          "1",
          "reading of the paper: 0 as used; 1 cores interpolated in each step; 2 velocities within the donors' range; "
          "vertices 3 along normals alone, 4 without gradient; 5 no cells of the fourth kind as donors; 6 no traction "
          "beyond sides",
          0,
          6,
          true};
}

Literal literal_reading(double number) {
  Literal l;
  bool* const readings[]{nullptr,         &l.reinterpolated_cores, &l.clipped_velocities, &l.normal_motion,
                         &l.level_motion, &l.deep_donors,          &l.continued_stress};
  if (bool* const one = readings[std::lround(number)]) *one = true;
  return l;
}

Case overset_case(std::string const& name, std::string const& title, std::string const& source, int cells,
                  std::vector<CaseParameter> const& parameters) {
  return {.name = name,
          .title = title,
          .source = source,
          .dimensions = 3,
          .default_cells = cells,
          .has_reference = false,
          .bodies = true,
          .meshes = {"overset"},
          .parameters = parameters};
}

namespace {

void apply(CaseOptions const& options, OversetSetup& s) {
  Predictor const predictor = options.predictor.value_or(Predictor::linear);
  Switch const monotonicity = options.monotonicity.value_or(Switch::graded);
  if (predictor == Predictor::muscl) throw std::invalid_argument("bodies know the predictors of order 1, 2 and 3");
  s.gas.options.predictor = s.solid_options.predictor = s.local.predictor = predictor;
  s.gas.options.monotonicity = s.solid_options.monotonicity = s.local.monotonicity = monotonicity;
  s.gas.options.threads = s.solid_options.threads = options.threads.value_or(1);
  s.cfl = options.cfl.value_or(0);
  if (options.cfl) s.gas.options.cfl = s.solid_options.cfl = *options.cfl;
  s.gas.options.riemann = s.local.riemann = options.riemann.value_or(RiemannSolver::fast);
  s.gas.options.transverse = s.solid_options.transverse = options.transverse.value_or(Transverse::own_cell);
  s.gas.options.cure = options.cure.value_or(true), s.gas.options.skip = options.skip.value_or(true);
  s.gas.options.tile = options.tile.value_or(Int3{0, 0, 0});
}

void add_facts(OversetSolver const& solver, CaseResult& r) {
  OversetCounters const& c = solver.counters();
  double triangles = 0;
  for (auto const& b : solver.bodies()) triangles += static_cast<double>(b->triangles.size());
  r.facts["triangles"] = triangles;
  r.facts["problems_first_order"] = static_cast<double>(c.first_order);
  r.facts["problems_skipped"] = static_cast<double>(c.skipped);
  r.facts["problems_failed"] = static_cast<double>(c.failed);
  r.facts["cores_renewed"] = static_cast<double>(c.renewed);
  LocalRemeshCounts const& m = c.remeshing;
  r.facts["remeshing_splits"] = static_cast<double>(m.splits);
  r.facts["remeshing_collapses"] = static_cast<double>(m.collapses);
  r.facts["remeshing_flips"] = static_cast<double>(m.flips), r.facts["remeshing_moves"] = static_cast<double>(m.moves);
  r.facts["remeshing_refused"] = static_cast<double>(m.refused), r.facts["remeshing_volume"] = m.volume;
  r.facts["untangled"] = static_cast<double>(c.untangled), r.facts["tangled"] = static_cast<double>(c.tangled);
  double const problems = std::max(1.0, static_cast<double>(c.problems));
  r.facts["us_per_triangle_step"] = 1e6 * c.seconds_local / problems;
  double const all = c.seconds_local + c.seconds_gas + c.seconds_solid + c.seconds_geometry + c.seconds_fill;
  r.facts["share_gas"] = all > 0 ? c.seconds_gas / all : 0;
}

}  // namespace

CaseResult run_problem(std::string const& name, int cells, OversetProblem problem, CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (problem.steps <= 0) require_end(problem.t_end);
  require_memory(count_of(problem.setup.gas.cells), gas_cell_bytes);
  apply(options, problem.setup);
  OversetSolver solver(problem.setup, problem.gas);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  auto const done = [&] {
    return problem.steps > 0 ? static_cast<double>(solver.counters().steps) / static_cast<double>(problem.steps)
                             : solver.time() / problem.t_end;
  };
  while (done() < 1) {
    GridStepReport const step = solver.step(problem.steps > 0 ? 1e300 : problem.t_end);
    if (step.status != StepStatus::ok) {
      throw std::runtime_error(name + ": the step at t = " + std::to_string(solver.time()) + " failed in cell (" +
                               std::to_string(step.cell[0]) + ", " + std::to_string(step.cell[1]) + ", " +
                               std::to_string(step.cell[2]) + ")");
    }
    if (options.progress) options.progress(done());
    if (problem.after_step && !problem.after_step(solver)) break;
  }
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.dimensions = 3, r.cells = n, r.grid = solver.gas().cells(), r.time = solver.time();
  GridSchemeOptions const& o = solver.gas().setup().options;
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = "overset", r.eos = eos_name(problem.setup.gas.eos);
  r.counters = solver.gas().counters();
  add_facts(solver, r);
  if (problem.measure) problem.measure(solver, r);
  return r;
}

}  // namespace g27
