#include "verification/cases/fsi_problem.hpp"

#include <chrono>
#include <stdexcept>

#include "riemann/eos/factory.hpp"
#include "scheme/step/solid_state.hpp"
#include "verification/cases/grid_run.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_line_problem.hpp"
#include "verification/cases/solid_problem.hpp"
#include "verification/measure/norms.hpp"

namespace g27 {

namespace {

GasLineSetup gas_setup(FsiProblem const& p, int cells, CaseOptions const& options, std::string const& mesh) {
  GasLineSetup setup{
      .eos = p.eos,
      .faces = mesh_faces("uniform", p.x0, p.contact, cells),
      .left = p.left,
      .right = {.kind = GasBoundary::Kind::contact},
      .motion = {.kind = mesh == "stretched" ? MeshMotion::Kind::stretched : MeshMotion::Kind::lagrangian}};
  GasSchemeOptions& o = setup.options;
  o.predictor = options.predictor.value_or(Predictor::linear);
  o.monotonicity = options.monotonicity.value_or(Switch::graded);
  o.riemann = options.riemann.value_or(RiemannSolver::fast);
  o.linear_star = options.linear_star.value_or(true);
  o.cfl = options.cfl.value_or(o.cfl);
  return setup;
}

SolidLineSetup solid_setup(FsiProblem const& p, int cells, CaseOptions const& options) {
  return {.material = p.solid,
          .faces = mesh_faces("uniform", p.contact, p.x1, cells),
          .left = {.kind = SolidBoundary::Kind::contact},
          .right = p.right,
          .options = solid_line_options(options)};
}

/// What was measured at the contact, step by step.
struct History {
  std::vector<double> dt, position, position_exact, velocity, velocity_exact;
};

void compare(GasSolidLine const& line, FsiProblem const& problem, History const& history, CaseResult& r) {
  GasLine const& gas = line.gas();
  std::vector<double> measure(gas.cells());
  for (std::size_t i = 0; i < gas.cells(); ++i) {
    measure[i] = gas.measure(i);
    GasConserved<> const q = problem.gas_reference(gas.faces()[i], gas.faces()[i + 1]);
    double const u = q.momentum / q.mass, e = q.energy / q.mass - 0.5 * u * u;
    r.rho_ref.push_back(q.mass), r.u_ref.push_back(u);
    r.p_ref.push_back(std::visit([&](auto const& law) { return law.pressure(q.mass, e); }, problem.eos));
  }
  auto const hold = [&](char const* variable, std::span<double const> value, std::span<double const> reference) {
    r.errors[variable] = norms(value, reference, measure);
    r.overshoot[variable] = overshoot(value, reference);
    r.tv_excess[variable] = tv_excess(value, reference);
  };
  hold("gas_density", gas.density(), r.rho_ref);
  hold("gas_velocity", gas.velocity(), r.u_ref);
  hold("gas_pressure", gas.pressure(), r.p_ref);

  SolidLine const& solid = line.solid();
  measure.resize(solid.cells());
  std::vector<double> value[4], reference[4];
  for (std::size_t i = 0; i < solid.cells(); ++i) {
    measure[i] = solid.measure(i);
    SolidPoint const s = solid.primitive(i);
    SolidPoint const e =
        solid_point_of(problem.material, problem.solid_reference(solid.faces()[i], solid.faces()[i + 1]));
    r.rho_ref.push_back(e.rho), r.u_ref.push_back(e.u[0]), r.p_ref.push_back(-e.stress(0, 0));
    double const ours[4]{s.rho, s.u[0], s.p, s.S[0]}, exact[4]{e.rho, e.u[0], e.p, e.S[0]};
    for (int k = 0; k < 4; ++k) value[k].push_back(ours[k]), reference[k].push_back(exact[k]);
  }
  char const* const names[4]{"solid_density", "solid_velocity", "solid_pressure", "solid_sxx"};
  for (int k = 0; k < 4; ++k) hold(names[k], value[k], reference[k]);
  r.errors["interface_position"] = norms(history.position, history.position_exact, history.dt);
  r.errors["interface_velocity"] = norms(history.velocity, history.velocity_exact, history.dt);
}

void keep_profile(GasSolidLine const& line, CaseResult& r) {
  GasLine const& gas = line.gas();
  for (std::size_t i = 0; i < gas.cells(); ++i) {
    r.x.push_back(0.5 * (gas.faces()[i] + gas.faces()[i + 1]));
    r.rho.push_back(gas.density()[i]), r.u.push_back(gas.velocity()[i]), r.p.push_back(gas.pressure()[i]);
  }
  SolidLine const& solid = line.solid();
  for (std::size_t i = 0; i < solid.cells(); ++i) {
    SolidPoint const s = solid.primitive(i);
    r.x.push_back(0.5 * (solid.faces()[i] + solid.faces()[i + 1]));
    r.rho.push_back(s.rho), r.u.push_back(s.u[0]), r.p.push_back(-s.stress(0, 0));
  }
}

/// Of both sides together: what one loses to the other cancels.
LedgerEntry sum(LedgerEntry const& a, LedgerEntry const& b) {
  return {.initial = a.initial + b.initial,
          .current = a.current + b.current,
          .through_boundary = a.through_boundary + b.through_boundary,
          .from_source = a.from_source + b.from_source,
          .from_floor = a.from_floor + b.from_floor,
          .scale = a.scale + b.scale};
}

}  // namespace

std::vector<std::string> fsi_meshes() { return {"lagrangian", "stretched"}; }

CaseResult run_problem(std::string const& name, int cells, FsiProblem const& problem, CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  std::string const mesh = options.mesh.value_or("lagrangian");
  GasSolidLine line(gas_setup(problem, n, options, mesh), solid_setup(problem, n, options));
  std::vector<GasConserved<>> averages;
  std::span<double const> const faces = line.gas().faces();
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) averages.push_back(problem.gas_initial(faces[i], faces[i + 1]));
  line.gas().set_averages(averages);
  line.solid().set_averages(problem.solid_initial);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  History history;
  while (line.time() < problem.t_end) {
    double const before = problem.position(line.time());
    StepReport const step = line.step(problem.t_end);
    if (step.status != StepStatus::ok) {
      throw std::runtime_error(name + ": the step at t = " + std::to_string(line.time()) + " failed in cell " +
                               std::to_string(step.cell) + " of gas and solid");
    }
    double const after = problem.position(line.time());
    history.dt.push_back(step.dt);
    history.position.push_back(line.position()), history.position_exact.push_back(after);
    history.velocity.push_back(line.contact().u), history.velocity_exact.push_back((after - before) / step.dt);
    if (options.progress) options.progress(line.time() / problem.t_end);
  }
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.cells = n, r.grid = {n, 1, 1}, r.time = line.time();
  GasSchemeOptions const& o = line.gas().setup().options;
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = mesh, r.eos = eos_name(problem.eos);
  static_cast<GasCounters&>(r.counters) = line.gas().counters();
  SolidCounters const& c = line.solid().counters();
  r.counters.faces += c.faces, r.counters.cell_updates += c.cell_updates, r.counters.switched += c.switched;
  r.counters.retried = line.counters().retried;
  GasLedger const gas = line.gas().ledger(), solid = case_ledger(line.solid().ledger());
  r.ledger = {.mass = sum(gas.mass, solid.mass),
              .momentum = sum(gas.momentum, solid.momentum),
              .energy = sum(gas.energy, solid.energy)};
  keep_profile(line, r);
  compare(line, problem, history, r);
  double const steps = static_cast<double>(line.counters().steps);
  r.facts["contact_pressure"] = line.contact().p, r.facts["contact_velocity"] = line.contact().u;
  r.facts["contact_iterations"] = static_cast<double>(line.counters().iterations) / steps;
  r.facts["contact_yielding_share"] = static_cast<double>(line.counters().yielding) / steps;
  r.facts["contact_vacuum_share"] = static_cast<double>(line.counters().vacua) / steps;
  return r;
}

}  // namespace g27
