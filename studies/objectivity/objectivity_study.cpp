/// Rotation of stressed bodies: error after a quarter turn, invariants of the stress, energies.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "scheme/step/solid_grid.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {
namespace {

constexpr std::array predictors{Predictor::godunov, Predictor::linear, Predictor::parabolic};
constexpr std::array names{"godunov", "linear", "parabolic"};
constexpr std::array grids{12, 24, 48, 96};

CaseResult turn(int cells, Predictor predictor, std::map<std::string, double> values = {}) {
  CaseOptions o;
  o.cells = cells, o.predictor = predictor, o.values = std::move(values);
  return find_by_name(all_cases(), "solid-rotation-2d", "objectivity").run(o);
}

/// A block thrown against the rest of a closed box of steel, in two dimensions: it yields, and all energy stays.
void plastic_box(StudyReport& report) {
  Table table{.name = "ledger",
              .title = "closed box with plastic flow: energy unaccounted for, and plastic work by steps and by strain",
              .columns = {{"scheme", "1"},
                          {"steps", "1"},
                          {"energy_residual", "1"},
                          {"plastic_work", "J"},
                          {"by_strain", "J"},
                          {"largest_strain", "1"}},
              .rows = {},
              .facts = {}};
  SolidMedium const m = solid_medium("steel", true);
  double residual = 0, gap = 0;
  for (std::size_t s = 0; s < predictors.size(); ++s) {
    SolidGridSetup setup{.material = m.scheme, .upper = {0.1, 0.1, 1}, .cells = {64, 64, 1}};
    for (SolidBoundary& side : setup.sides) side.kind = SolidBoundary::Kind::symmetry;
    setup.options.predictor = predictors[s];
    SolidGrid grid(setup);
    grid.set_state(
        [&](Vec3 const& x) {
          bool const block = x[0] > 0.02 && x[0] < 0.06 && x[1] > 0.03 && x[1] < 0.05;
          return solid_state(m, m.rho0, {block ? 200.0 : 0.0, block ? 100.0 : 0.0, 0}, 0);
        },
        2);
    while (grid.counters().steps < 200) {
      if (grid.step(1e30).status != StepStatus::ok) throw std::runtime_error("objectivity: a step failed");
    }
    SolidLedger const ledger = grid.ledger();
    double const cell = grid.widths()[0] * grid.widths()[1], Y = m.scheme.Y0, H = m.scheme.H;
    double by_strain = 0, largest = 0;
    for (double ep : grid.field(SolidGrid::Field::plastic_strain)) {
      by_strain += cell * (Y * ep + 0.5 * H * ep * ep), largest = std::max(largest, ep);
    }
    table.rows.push_back({std::string(names[s]), static_cast<long>(grid.counters().steps), ledger.energy.residual(),
                          ledger.plastic_work, by_strain, largest});
    residual = std::max(residual, std::fabs(ledger.energy.residual()));
    gap = std::max(gap, std::fabs(by_strain / ledger.plastic_work - 1));
  }
  report.tables.push_back(table);
  report.findings.push_back({"energy of a closed box that yields: closed to 1e-13 in 200 steps",
                             fmt::format("{:.2g} at most", residual), residual <= 1e-13});
  // a volume changes by some parts in a thousand, and mixing averages the strain
  report.findings.push_back({"the plastic work of the ledger is that of the plastic strain, to 1 %",
                             fmt::format("{:.2g} apart at most", gap), gap <= 0.01});
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "turn",
              .title = "quarter turn of a stressed body: largest stress error and change of S:S, relative",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"steps", "1"},
                          {"stress_error", "1"},
                          {"invariant_drift", "1"},
                          {"kinetic_energy_error", "1"},
                          {"order", "1"}},
              .rows = {},
              .facts = {}};
  StudyReport report;
  double done = 0;
  for (std::size_t s = 0; s < predictors.size(); ++s) {
    double before = 0, least = 1e300, finest = 0;
    for (int cells : grids) {
      if (context.progress) context.progress(done++ / 13, fmt::format("{} {}", names[s], cells));
      CaseResult const r = turn(cells, predictors[s]);
      double const error = r.facts.at("stress_error"), order = before > 0 ? std::log2(before / error) : 0;
      table.rows.push_back({std::string(names[s]), long{cells}, static_cast<long>(r.counters.steps), error,
                            r.facts.at("invariant_drift"), r.facts.at("kinetic_energy_error"), order});
      if (before > 0) least = std::min(least, order);
      before = error, finest = error;
    }
    if (predictors[s] == Predictor::godunov) continue;
    report.findings.push_back(
        {fmt::format("{}: the stress follows the body, order of its largest error at least 1.9", names[s]),
         fmt::format("{:.2f} at least; {:.2g} on {} cells", least, finest, grids.back()), least >= 1.9});
  }
  // the update alone: in a uniform stress turned by small angles nothing is interpolated
  if (context.progress) context.progress(done / 13, "small angles");
  Table alone{.name = "small-angles",
              .title = "change of S:S in a body turned slowly: what the rotation update alone does",
              .columns = {{"mach", "1"}, {"turns", "1"}, {"steps", "1"}, {"invariant_drift", "1"}},
              .rows = {},
              .facts = {}};
  double worst = 0;
  for (double mach : {1e-3, 1e-4}) {
    double const turns = 0.025 * mach / 1e-3;
    CaseResult const r = turn(12, Predictor::linear, {{"mach", mach}, {"turns", turns}});
    alone.rows.push_back({mach, turns, static_cast<long>(r.counters.steps), r.facts.at("invariant_drift")});
    worst = std::max(worst, r.facts.at("invariant_drift"));
  }
  report.findings.push_back({"the rotation update alone keeps the invariants of the stress to 1e-10",
                             fmt::format("{:.2g} at most", worst), worst <= 1e-10});
  report.tables = {table, alone};
  plastic_box(report);
  return report;
}

}  // namespace

Study objectivity_study() {
  return {"objectivity", "stresses turn with the body: second order, and their invariants stay", run};
}

}  // namespace g27
