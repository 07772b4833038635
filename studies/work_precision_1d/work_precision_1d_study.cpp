/// CPU time to a given error: Godunov's scheme, the modified ones and MUSCL, smooth waves and shock tubes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>

#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/curve.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

constexpr double enough_cpu = 0.02;   ///< stepping time a grid and scheme is repeated for [s]
constexpr double most_clock = 0.05;   ///< clock time after which the repetitions of a grid and scheme end [s]
constexpr int least_repetitions = 6;  ///< whatever the grid costs

enum Scheme { godunov, linear, parabolic, muscl };
constexpr std::array schemes{godunov, linear, parabolic, muscl};
constexpr std::array scheme_names{"godunov", "linear", "parabolic", "muscl"};
constexpr std::array predictors{Predictor::godunov, Predictor::linear, Predictor::parabolic, Predictor::muscl};

enum class Kind { smooth, structured, steps };
constexpr std::array kind_names{"smooth", "structured", "steps"};

struct Problem {
  std::string name, eos;
  Kind kind;  ///< structured: shocks with rarefactions or waves between them; steps: all error sits in jumps
};

std::vector<Problem> problems() {
  std::vector<Problem> list;
  for (char const* wave : {"acoustic-1d", "entropy-1d", "simple-wave-1d"}) {
    for (char const* eos : {"ideal", "jwl", "stiffened"}) list.push_back({wave, eos, Kind::smooth});
  }
  for (char const* tube : {"sod", "toro1", "lax", "leblanc", "tube-1e10", "shu-osher", "woodward-colella"}) {
    list.push_back({tube, "ideal", Kind::structured});
  }
  list.push_back({"water-tube", "stiffened", Kind::structured});
  list.push_back({"jwl-tube", "jwl", Kind::structured});
  for (char const* tube : {"toro5", "contact", "slow-shock"}) list.push_back({tube, "ideal", Kind::steps});
  return list;
}

/// Grids of a problem; the reference error is MUSCL's on `reference` cells.
struct Grids {
  std::vector<int> all;
  int finest, finest_godunov, reference;
};
Grids grids(Kind kind) {
  if (kind == Kind::smooth) return {{10, 20, 40, 80, 160, 320, 640, 1280, 2560}, 640, 2560, 320};
  return {{50, 100, 200, 400, 800, 1600, 3200}, 800, 3200, 400};
}

double clock_seconds() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Timing {
  std::array<double, 2> best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double total = 0, error = 0;
  int repetitions = 0;
};

/// One grid by all schemes in turn, again and again, so that what else the machine does falls on all of them alike.
std::array<Timing, 4> time_grid(Case const& run, std::string const& eos, int cells, bool godunov_only) {
  std::array<Timing, 4> timings;
  double const start = clock_seconds();
  for (int round = 0;; ++round) {
    bool enough = round >= least_repetitions;
    for (Scheme s : schemes) {
      if (godunov_only && s != godunov) continue;
      CaseOptions options;
      options.cells = cells, options.eos = eos, options.predictor = predictors[s];
      options.riemann = RiemannSolver::fast, options.linear_star = true, options.cfl = 0.8, options.threads = 1;
      CaseResult const r = run.run(options);
      Timing& t = timings[s];
      double& best = t.best[static_cast<std::size_t>(round % 2)];
      best = std::min(best, r.cpu_s);
      t.total += r.cpu_s, t.error = r.errors.at("density").l1, ++t.repetitions;
      enough = enough && t.total >= enough_cpu;
    }
    double const taken = clock_seconds() - start;
    if (enough || (round >= least_repetitions && taken > most_clock * (godunov_only ? 1 : schemes.size()))) break;
  }
  return timings;
}

using Curves = std::array<std::vector<CurvePoint>, 4>;

Curves measure(Problem const& problem, Table& table) {
  Case const run = find_by_name(all_cases(), problem.name, "work-precision-1d");
  Grids const g = grids(problem.kind);
  Curves curves;
  for (int cells : g.all) {
    auto const timings = time_grid(run, problem.eos, cells, cells > g.finest);
    for (Scheme s : schemes) {
      Timing const& t = timings[s];
      if (t.repetitions == 0) continue;
      CurvePoint const point{cells, t.error, std::min(t.best[0], t.best[1]),
                             std::fabs(std::log(t.best[0] / t.best[1]))};
      curves[s].push_back(point);
      table.rows.push_back({problem.name, problem.eos, std::string{kind_names[static_cast<std::size_t>(problem.kind)]},
                            std::string{scheme_names[s]}, static_cast<long>(cells), point.error, point.seconds,
                            point.spread, static_cast<long>(t.repetitions)});
    }
  }
  return curves;
}

/// Time of one scheme over that of another at the same error, with the uncertainty of its logarithm.
struct Ratio {
  double value, uncertainty;
};
Ratio over(TimeAtError const& a, TimeAtError const& b) {
  return {a.seconds / b.seconds, a.uncertainty + b.uncertainty};
}
std::string text(Ratio const& r) {
  return fmt::format("{:.3g} (+-{:.0f} %)", r.value, 100 * std::expm1(r.uncertainty));
}

/// A demand on the time ratio of every row of a kind.
struct Demand {
  std::string claim;
  double least;
  std::string rows{}, failing{};
  int count = 0, failures = 0;
  void add(std::string const& row, Ratio const& r) {
    std::string const entry = fmt::format("{} {}", row, text(r));
    rows += (count++ > 0 ? ", " : "") + entry;
    if (r.value > least) return;
    failing += (failures++ > 0 ? ", " : "") + entry;
  }
  [[nodiscard]] Finding finding() const {
    return {claim,
            failures == 0 ? rows : fmt::format("{} of {} rows fail: {}; all: {}", failures, count, failing, rows),
            count > 0 && failures == 0};
  }
};

Table curve_table() {
  return {.name = "curves",
          .title = "density error and CPU time by grid",
          .columns = {{"problem", "1"},
                      {"eos", "1"},
                      {"kind", "1"},
                      {"scheme", "1"},
                      {"cells", "1"},
                      {"density_l1", "kg/m^3"},
                      {"cpu", "s"},
                      {"spread", "1"},
                      {"repetitions", "1"}},
          .rows = {},
          .facts = {{"cfl", 0.8}}};
}

Table ratio_table() {
  return {
      .name = "ratios",
      .title = "time at equal error: MUSCL's on 320 (smooth) or 400 cells; extrapolated: beyond Godunov's finest grid",
      .columns = {{"problem", "1"},
                  {"eos", "1"},
                  {"error", "kg/m^3"},
                  {"godunov_over_linear", "1"},
                  {"godunov_over_parabolic", "1"},
                  {"muscl_over_linear", "1"},
                  {"muscl_over_parabolic", "1"},
                  {"godunov_uncertainty", "1"},
                  {"muscl_uncertainty", "1"},
                  {"godunov", "1"}},
      .rows = {},
      .facts = {}};
}

StudyReport run(StudyContext const& context) {
  Table curves = curve_table(), ratios = ratio_table();
  Demand smooth_best{"Godunov's time over the better modified scheme's at equal error, smooth: >= 100", 100};
  Demand smooth_linear{"the same over the linear scheme's, smooth: >= 100", 100};
  Demand tube_best{"Godunov's time over the better modified scheme's, tubes with smooth structure: >= 10", 10};
  Demand tube_linear{"the same over the linear scheme's, tubes with smooth structure: >= 10", 10};
  Demand muscl_all{"MUSCL van Leer's time over the parabolic scheme's: > 1 but on slow-shock and leblanc", 1};
  Demand muscl_smooth{"MUSCL van Leer's time over the parabolic scheme's, smooth: > 5", 5};
  std::vector<Problem> const list = problems();
  for (std::size_t i = 0; i < list.size(); ++i) {
    Problem const& problem = list[i];
    std::string const row = fmt::format("{} {}", problem.name, problem.eos);
    context.progress(static_cast<double>(i) / static_cast<double>(list.size()), row);
    Curves const measured = measure(problem, curves);
    double error = 0;
    for (CurvePoint const& p : measured[muscl]) error = p.cells == grids(problem.kind).reference ? p.error : error;
    std::array<TimeAtError, 4> time;
    for (Scheme s : schemes) time[s] = time_at(measured[s], error);
    Ratio const over_linear = over(time[godunov], time[linear]), over_parabolic = over(time[godunov], time[parabolic]);
    Ratio const muscl_linear = over(time[muscl], time[linear]), muscl_parabolic = over(time[muscl], time[parabolic]);
    bool const extrapolated = time[godunov].kind == TimeAtError::Kind::extrapolated;
    ratios.rows.push_back({problem.name, problem.eos, error, over_linear.value, over_parabolic.value,
                           muscl_linear.value, muscl_parabolic.value,
                           std::max(over_linear.uncertainty, over_parabolic.uncertainty), muscl_parabolic.uncertainty,
                           std::string{extrapolated ? "extrapolated" : "reached"}});
    Ratio const& best = over_linear.value > over_parabolic.value ? over_linear : over_parabolic;
    std::string const flagged = row + (extrapolated ? "*" : "");
    if (problem.kind == Kind::smooth) smooth_best.add(flagged, best), smooth_linear.add(flagged, over_linear);
    if (problem.kind == Kind::structured) tube_best.add(flagged, best), tube_linear.add(flagged, over_linear);
    if (problem.name != "slow-shock" && problem.name != "leblanc") muscl_all.add(row, muscl_parabolic);
    if (problem.kind == Kind::smooth) muscl_smooth.add(row, muscl_parabolic);
  }
  std::vector<Finding> findings;
  for (Demand const* d : {&smooth_best, &smooth_linear, &tube_best, &tube_linear, &muscl_all, &muscl_smooth}) {
    findings.push_back(d->finding());
  }
  return {{curves, ratios}, findings};
}

}  // namespace

Study work_precision_1d_study() {
  return {
      "work-precision-1d",
      "to the same error the modified schemes take a small share of Godunov's time, the parabolic one less than MUSCL",
      run};
}

}  // namespace g27
