#include "verification/cases/bonded_problem.hpp"

#include <chrono>
#include <stdexcept>

#include "verification/cases/grid_run.hpp"
#include "verification/cases/line_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_line_problem.hpp"
#include "verification/cases/solid_problem.hpp"
#include "verification/measure/norms.hpp"

namespace g27 {

namespace {

SolidLineSetup setup_of(BondedProblem::Side const& side, bool left, int cells, CaseOptions const& options) {
  SolidBoundary const contact{.kind = SolidBoundary::Kind::contact};
  return {.material = side.medium.scheme,
          .faces = mesh_faces("uniform", left ? -side.length : 0, left ? 0 : side.length, cells),
          .left = left ? side.outer : contact,
          .right = left ? contact : side.outer,
          .options = solid_line_options(options)};
}

/// What was measured on the bonded face, step by step.
struct History {
  std::vector<double> dt, value[6], exact[6];
};

void hold(std::string const& variable, std::vector<double> const& value, std::vector<double> const& reference,
          std::vector<double> const& measure, CaseResult& r) {
  r.errors[variable] = norms(value, reference, measure);
  r.overshoot[variable] = overshoot(value, reference);
  r.tv_excess[variable] = tv_excess(value, reference);
}

/// One side; adds its cells to the profiles and to `measures`.
void compare(SolidLine const& line, BondedProblem::Side const& side, std::string const& prefix,
             std::vector<double>& measures, CaseResult& r) {
  std::vector<double> measure(line.cells());
  auto const& names = solid_variables();
  std::vector<std::vector<double>> value(names.size()), reference(names.size());
  for (std::size_t i = 0; i < line.cells(); ++i) {
    double const a = line.faces()[i], b = line.faces()[i + 1];
    measure[i] = line.measure(i);
    auto const ours = solid_values(line.primitive(i));
    auto const exact = solid_values(solid_point_of(side.medium.exact, side.reference(a, b)));
    r.x.push_back(0.5 * (a + b));
    for (std::size_t v = 0; v < names.size(); ++v) value[v].push_back(ours[v]), reference[v].push_back(exact[v]);
  }
  for (std::size_t v = 0; v < names.size(); ++v) {
    hold(prefix + names[v], value[v], reference[v], measure, r);
    std::vector<double>&profile = r.profile[names[v]], &exact = r.profile_ref[names[v]];
    profile.insert(profile.end(), value[v].begin(), value[v].end());
    exact.insert(exact.end(), reference[v].begin(), reference[v].end());
  }
  measures.insert(measures.end(), measure.begin(), measure.end());
}

LedgerEntry sum(LedgerEntry const& a, LedgerEntry const& b) {
  return {.initial = a.initial + b.initial,
          .current = a.current + b.current,
          .through_boundary = a.through_boundary + b.through_boundary,
          .from_source = a.from_source + b.from_source,
          .from_floor = a.from_floor + b.from_floor,
          .scale = a.scale + b.scale};
}

/// Of both sides together: what one loses to the other cancels.
SolidLedger sum(SolidLedger const& a, SolidLedger const& b) {
  SolidLedger s{.mass = sum(a.mass, b.mass),
                .energy = sum(a.energy, b.energy),
                .momentum = {},
                .plastic_work = a.plastic_work + b.plastic_work};
  for (std::size_t k = 0; k < 3; ++k) s.momentum[k] = sum(a.momentum[k], b.momentum[k]);
  return s;
}

}  // namespace

std::vector<std::string> bonded_pairs() {
  return {"steel-aluminium", "aluminium-steel", "steel-steel", "aluminium-aluminium"};
}

std::pair<SolidMedium, SolidMedium> bonded_media(std::string const& pair, bool plastic) {
  std::size_t const dash = pair.find('-');
  if (dash == std::string::npos) throw std::invalid_argument("'" + pair + "' names no two solids, as steel-aluminium");
  return {solid_medium(pair.substr(0, dash), plastic), solid_medium(pair.substr(dash + 1), plastic)};
}

CaseResult run_problem(std::string const& name, int cells, BondedProblem const& problem, CaseOptions const& options) {
  int const n = options.cells.value_or(cells);
  if (n < 4) throw std::invalid_argument("a case needs at least 4 cells");
  require_end(problem.t_end);
  SolidSolidLine line(setup_of(problem.left, true, n, options), setup_of(problem.right, false, n, options));
  line.left().set_averages(problem.left.initial);
  line.right().set_averages(problem.right.initial);

  auto const wall_start = std::chrono::steady_clock::now();
  double const cpu_start = cpu_seconds();
  History history;
  while (line.time() < problem.t_end) {
    double const before = line.time();
    StepReport const step = line.step(problem.t_end);
    if (step.status != StepStatus::ok) {
      throw std::runtime_error(name + ": the step at t = " + std::to_string(line.time()) + " failed in cell " +
                               std::to_string(step.cell) + " of both solids");
    }
    SolidPoint const exact = problem.contact(0.5 * (before + line.time()));
    history.dt.push_back(step.dt);
    for (std::size_t k = 0; k < 3; ++k) {
      history.value[k].push_back(line.contact().u[k]), history.exact[k].push_back(exact.u[k]);
      history.value[3 + k].push_back(line.contact().s[k]), history.exact[3 + k].push_back(exact.stress(0, k));
    }
    if (options.progress) options.progress(line.time() / problem.t_end);
  }
  CaseResult r;
  r.cpu_s = cpu_seconds() - cpu_start;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  r.name = name, r.cells = n, r.grid = {n, 1, 1}, r.time = line.time();
  SolidSchemeOptions const& o = line.left().setup().options;
  r.order = order_of(o.predictor), r.scheme = name_of(o.predictor), r.monotonicity = name_of(o.monotonicity);
  r.mesh = "lagrangian";
  for (SolidLine const* side : {&line.left(), &line.right()}) {
    SolidCounters const& c = side->counters();
    r.counters.steps = c.steps;
    r.counters.faces += c.faces, r.counters.cell_updates += c.cell_updates, r.counters.switched += c.switched;
  }
  r.counters.retried = line.retried();
  r.ledger = case_ledger(sum(line.left().ledger(), line.right().ledger()));
  std::vector<double> measures;
  compare(line.left(), problem.left, "left_", measures, r);
  compare(line.right(), problem.right, "right_", measures, r);
  for (std::string const& v : solid_variables()) hold(v, r.profile[v], r.profile_ref[v], measures, r);
  combine_velocity(r);
  r.rho = r.profile["density"], r.u = r.profile["velocity_x"], r.p = r.profile["pressure"];
  r.rho_ref = r.profile_ref["density"], r.u_ref = r.profile_ref["velocity_x"], r.p_ref = r.profile_ref["pressure"];
  char const* const names[6]{"contact_velocity_x", "contact_velocity_y", "contact_velocity_z",
                             "contact_traction_x", "contact_traction_y", "contact_traction_z"};
  for (std::size_t k = 0; k < 6; ++k) r.errors[names[k]] = norms(history.value[k], history.exact[k], history.dt);
  r.facts["contact_velocity"] = line.contact().u[0], r.facts["contact_stress"] = -line.contact().s[0];
  return r;
}

}  // namespace g27
