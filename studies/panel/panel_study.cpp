/// A clamped plate swings freely, and as a panel in a shock tube: frequency, damping and the published deflection.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scheme/step/solid_grid.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/standing_plate.hpp"
#include "verification/exact/clamped_beam.hpp"

namespace g27 {
namespace {

constexpr double slenderness = 6, periods = 1.05;

struct Row {
  int cells, order;
};
std::vector<Row> const free_rows{{4, 2}, {6, 2}, {8, 2}, {4, 3}, {6, 3}};
/// Thickness of the plate that stands for the panel [m].
struct PanelRow {
  double as_thick;
  int cells;
};
std::vector<PanelRow> const panel_rows{{8e-3, 8}, {8e-3, 12}};
constexpr int finest = 8;  ///< of the free plates

constexpr double measured = 6.2e-3, measured_within = 0.4e-3;  ///< Giordano et al.
constexpr double most_frequency = 0.02, least_left = 0.9;

/// The same plate on a grid along its sides alone, with free sides: amplitude of the second swing over the first.
double left_on_grid(int n, Predictor predictor, Switch monotonicity) {
  ClampedBeam const beam{.thickness = 1, .length = slenderness, .density = 1, .young = 1, .poisson = 0.33};
  double const speed = 0.02 * beam.thin();
  int const up = static_cast<int>(std::lround(n * slenderness));
  using Kind = SolidBoundary::Kind;
  SolidGridSetup setup{.material = elastic_material(beam.density, beam.young, beam.poisson),
                       .lower = {0, 0, 0},
                       .upper = {1, slenderness, 1},
                       .cells = {n, up, 1}};
  setup.sides[0].kind = setup.sides[1].kind = setup.sides[3].kind = Kind::free, setup.sides[2].kind = Kind::fixed;
  setup.options.predictor = predictor, setup.options.monotonicity = monotonicity;
  SolidGrid grid(setup);
  grid.set_state([&](Vec3 const& x) {
    ClampedBeam::Mode const mode = beam.mode(x[1]);
    return SolidPoint{.rho = 1, .u = {speed * mode.value, -speed * (x[0] - 0.5) * mode.slope, 0}};
  });
  double const end = periods * 2 * std::numbers::pi / beam.thin();
  double tip = 0, farthest[2]{0, 0};
  int swing = 0;
  while (grid.time() < end && swing < 2) {
    double const from = grid.time(), before = tip;
    if (grid.step(end).status != StepStatus::ok) return std::nan("");
    double velocity = 0;
    for (int i = 0; i < n; ++i) velocity += grid.primitive({i, up - 1, 0}).u[0] / n;
    tip += velocity * (grid.time() - from);
    if (before * tip < 0) ++swing;
    if (swing < 2) farthest[swing] = std::max(farthest[swing], std::fabs(tip));
  }
  return farthest[1] / farthest[0];
}

Table on_grid() {
  Table table{
      .name = "grid",
      .title = "The grid's scheme alone: amplitude of the second swing over that of the first",
      .columns = {{"cells", "1"}, {"linear", "1"}, {"parabolic", "1"}, {"linear_off", "1"}, {"parabolic_off", "1"}},
      .rows = {},
      .facts = {}};
  for (int n : {4, 6, 8, 12}) {
    auto const left = [&](Predictor p, Switch s) { return left_on_grid(n, p, s); };
    table.rows.push_back({long{n}, left(Predictor::linear, Switch::graded), left(Predictor::parabolic, Switch::graded),
                          left(Predictor::linear, Switch::off), left(Predictor::parabolic, Switch::off)});
  }
  return table;
}

double fact_or_nan(CaseResult const& r, std::string const& name) {
  auto const at = r.facts.find(name);
  return at == r.facts.end() ? std::nan("") : at->second;
}

StudyReport run(StudyContext const& context) {
  Case const beam = find_by_name(all_cases(), "clamped-beam", "panel");
  Case const panel = find_by_name(all_cases(), "elastic-panel", "panel");
  double const all = static_cast<double>(free_rows.size() + panel_rows.size());
  double done = 0;
  std::vector<Finding> findings;
  Table swings{.name = "swings",
               .title = "A clamped plate of 6 thicknesses that is left to swing in its first mode",
               .columns = {{"cells", "1"},
                           {"order", "1"},
                           {"first_swing", "1"},
                           {"frequency_error", "1"},
                           {"second_over_first", "1"},
                           {"steps", "1"},
                           {"wall", "s"}},
               .rows = {},
               .facts = {}};
  Hdf5Writer histories;
  auto const keep = [&](std::string const& what, CaseResult const& r) {
    for (char const* quantity : {"time", "tip"})
      histories.write(fmt::format("/{}/{}", what, quantity), r.profile.at(quantity), "1");
  };
  for (Row const& row : free_rows) {
    CaseOptions o;
    o.cells = row.cells, o.threads = threads_or_all(0), o.predictor = static_cast<Predictor>(row.order - 1);
    o.values = {{"slenderness", slenderness}, {"periods", periods}};
    std::string const what = fmt::format("plate, {} cells, order {}", row.cells, row.order);
    o.progress = [&](double part) { context.progress((done + part) / all, what); };
    CaseResult const r = beam.run(o);
    double const left = std::sqrt(fact_or_nan(r, "left_per_period")), error = fact_or_nan(r, "frequency_error");
    swings.rows.push_back({long{row.cells}, long{row.order}, fact_or_nan(r, "first_swing"), error, left,
                           static_cast<long>(r.facts.at("steps")), r.wall_s});
    keep(what, r), done += 1;
    if (row.cells != finest) continue;
    findings.push_back({fmt::format("{} cells, order {}: frequency of a beam with shear within {:g}", row.cells,
                                    row.order, most_frequency),
                        fmt::format("{:.2g}", error), std::fabs(error) <= most_frequency});
    findings.push_back(
        {fmt::format("{} cells, order {}: second swing over the first at least {:g}", row.cells, row.order, least_left),
         fmt::format("{:.2g}", left), left >= least_left});
  }
  Table deflections{.name = "deflections",
                    .title = "Panel of 1 mm x 50 mm in a shock of Mach 1.21, as a thicker plate: its tip",
                    .columns = {{"as_thick", "m"},
                                {"cells", "1"},
                                {"peak", "m"},
                                {"peak_time", "s"},
                                {"gauge_largest", "Pa"},
                                {"steps", "1"},
                                {"wall", "s"}},
                    .rows = {},
                    .facts = {}};
  double last = std::nan("");
  for (PanelRow const& row : panel_rows) {
    CaseOptions o;
    o.cells = row.cells, o.threads = threads_or_all(0), o.predictor = Predictor::linear;
    o.values = {{"as_thick", row.as_thick}};
    std::string const what = fmt::format("panel as of {:g} mm, {} cells", 1e3 * row.as_thick, row.cells);
    o.progress = [&](double part) { context.progress((done + part) / all, what); };
    CaseResult const r = panel.run(o);
    last = r.facts.at("peak");
    deflections.rows.push_back({row.as_thick, long{row.cells}, last, r.facts.at("peak_time"),
                                r.facts.at("gauge_largest"), static_cast<long>(r.facts.at("steps")), r.wall_s});
    keep(what, r), done += 1;
  }
  histories.save(context.out / "histories.h5");
  findings.push_back({fmt::format("peak deflection of the panel within {:g} mm of the measured {:g} mm",
                                  1e3 * measured_within, 1e3 * measured),
                      fmt::format("{:.3g} mm", 1e3 * last), std::fabs(last - measured) <= measured_within});
  return {{swings, on_grid(), deflections}, std::move(findings)};
}

}  // namespace

Study panel_study() {
  return {"panel", "a clamped panel bends in a shock tube as it was measured, and swings freely as a beam does", run};
}

}  // namespace g27
