#include "verification/cases/line_problem.hpp"
#include "verification/cases/grid_run.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "riemann/eos/factory.hpp"
#include "scheme/step/gauss.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/measure/norms.hpp"

namespace g27 {

namespace {

constexpr double pi = std::numbers::pi;

bool is_random(std::string const& kind) { return kind == "random" || kind == "moving-random"; }

/// Widths of the mesh family, up to a factor.
double relative_width(std::string const& kind, int cell, int cells, std::mt19937_64& generator) {
  if (kind == "graded") return 1.0 + 0.5 * std::sin(2.0 * pi * (cell + 0.5) / cells);
  if (kind == "alternating") return 1.0 + cell % 2;
  if (is_random(kind)) return 1.0 + std::uniform_real_distribution<double>(-0.4, 0.4)(generator);
  if (kind == "uniform" || kind == "moving") return 1.0;
  throw std::invalid_argument("mesh '" + kind + "': one of uniform graded alternating random moving moving-random");
}

GasState<> primitive_of(AnyEos const& eos, GasConserved<> const& q) {
  if (!(q.mass > 0)) return {0.0, 0.0, 0.0};  // a vacuum has no velocity: compared as at rest
  double const u = q.momentum / q.mass;
  double const e = q.energy / q.mass - 0.5 * u * u;
  return {q.mass, u, std::visit([&](auto const& law) { return law.pressure(q.mass, e); }, eos)};
}

void compare(GasLine const& line, LineProblem const& problem, CaseResult& r) {
  std::vector<double> measure(line.cells());
  for (std::size_t i = 0; i < line.cells(); ++i) {
    measure[i] = line.measure(i);
    GasState<> const s = primitive_of(problem.eos, problem.reference(line.faces()[i], line.faces()[i + 1]));
    r.rho_ref.push_back(s.rho), r.u_ref.push_back(s.u), r.p_ref.push_back(s.p);
  }
  auto const hold = [&](char const* variable, std::span<double const> value, std::span<double const> reference) {
    r.errors[variable] = norms(value, reference, measure);
    r.overshoot[variable] = overshoot(value, reference);
    r.tv_excess[variable] = tv_excess(value, reference);
  };
  hold("density", r.rho, r.rho_ref);
  hold("velocity", r.u, r.u_ref);
  hold("pressure", r.p, r.p_ref);
}

}  // namespace

std::vector<double> mesh_faces(std::string const& kind, double x0, double x1, int cells) {
  std::mt19937_64 generator(7);
  std::vector<double> faces(static_cast<std::size_t>(cells) + 1);
  double sum = 0;
  for (int i = 0; i < cells; ++i) {
    faces[static_cast<std::size_t>(i)] = sum;
    sum += relative_width(kind, i, cells, generator);
  }
  faces.back() = sum;
  for (double& x : faces) x = x0 + (x1 - x0) * (x / sum);
  faces.back() = x1;
  return faces;
}

MeshMotion mesh_motion(std::string const& kind, double x0, double x1, int cells, double t_end) {
  using Kind = MeshMotion::Kind;
  double const length = x1 - x0, rate = 2.0 * pi * 1.3 / t_end;
  if (kind == "moving") {
    return {.kind = Kind::prescribed, .position = [=](double x, double t) {
              return x + 0.05 * length * std::sin(2.0 * pi * (x - x0) / length) * std::sin(rate * t);
            }};
  }
  if (kind == "moving-random") {
    // every face on its own: phases from its position, which is random. Neighbours approach by 0.4 of the mean width
    // at most, and the thinnest cell is 0.6 of it: by a fifth of a cell, not a tenth, they would cross
    double const amplitude = 0.1 * length / cells;
    return {.kind = Kind::prescribed, .position = [=](double x, double t) {
              if (x <= x0 || x >= x1) return x;
              double const phase = 1e4 * (x - x0) / length;
              return x + amplitude * (std::sin(rate * t + phase) - std::sin(phase));
            }};
  }
  return {};
}

CellMean mean_of(AnyEos const& eos, Symmetry symmetry, std::function<GasState<>(double x)> state, int points) {
  return [=, state = std::move(state)](double a, double b) {
    return cell_average(symmetry, a, b, points, [&](double x) -> GasConserved<> {
      GasState<> const s = state(x);
      double const e = std::visit([&](auto const& law) { return law.energy(s.rho, s.p); }, eos);
      return {s.rho, s.rho * s.u, s.rho * e + 0.5 * s.rho * s.u * s.u};
    });
  };
}

void make_periodic(LineProblem& problem) { problem.left.kind = problem.right.kind = GasBoundary::Kind::periodic; }

CaseResult run_problem(std::string const& name, int cells, LineProblem problem, CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  std::string const mesh = options.mesh.value_or("uniform");

  GasLineSetup setup{
      .eos = problem.eos,
      .faces = mesh_faces(mesh, problem.x0, problem.x1, n),
      .symmetry = problem.symmetry,
      .left = problem.left,
      .right = problem.right,
      .motion = options.mesh ? mesh_motion(mesh, problem.x0, problem.x1, n, problem.t_end) : problem.motion,
      .source = problem.source,
      .burn = problem.burn,
      .options = {}};
  GasSchemeOptions& o = setup.options;
  o.predictor = options.predictor.value_or(Predictor::linear);
  o.monotonicity = options.monotonicity.value_or(problem.monotonicity);
  o.cfl = options.cfl.value_or(problem.cfl);
  o.feet = options.feet.value_or(FootPoints::conservative);
  o.single_foot = options.single_foot.value_or(false);
  o.riemann = options.riemann.value_or(RiemannSolver::fast);
  o.linear_star = options.linear_star.value_or(true);
  o.threads = options.threads.value_or(1);

  GasLine line(std::move(setup));
  std::vector<GasConserved<>> averages;
  for (std::size_t i = 0; i < line.cells(); ++i)
    averages.push_back(problem.initial(line.faces()[i], line.faces()[i + 1]));
  line.set_averages(averages);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  while (line.time() < problem.t_end) {
    StepReport const step = line.step(problem.t_end);
    if (step.status != StepStatus::ok) {
      throw std::runtime_error(name + ": the step at t = " + std::to_string(line.time()) + " failed in cell " +
                               std::to_string(step.cell));
    }
    if (options.progress) options.progress(line.time() / problem.t_end);
  }
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.cells = n, r.grid = {n, 1, 1}, r.time = line.time();
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = mesh, r.eos = eos_name(problem.eos);
  static_cast<GasCounters&>(r.counters) = line.counters(), r.ledger = line.ledger();
  for (std::size_t i = 0; i < line.cells(); ++i) r.x.push_back(0.5 * (line.faces()[i] + line.faces()[i + 1]));
  r.rho.assign(line.density().begin(), line.density().end());
  r.u.assign(line.velocity().begin(), line.velocity().end());
  r.p.assign(line.pressure().begin(), line.pressure().end());
  r.switched.assign(line.switch_map().begin(), line.switch_map().end());
  if (problem.reference) compare(line, problem, r);
  return r;
}

}  // namespace g27
