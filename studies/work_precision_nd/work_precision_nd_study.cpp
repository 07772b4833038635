/// CPU time to a given error in two and three dimensions: Godunov's scheme, the modified ones, and MUSCL-Hancock with
/// van Leer's slopes and HLLC inside the same tiles and kernels.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/timed_case.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

enum Scheme { godunov, linear, parabolic, muscl };
constexpr std::array names{"godunov", "linear", "parabolic", "muscl-hllc"};
constexpr std::array predictors{Predictor::godunov, Predictor::linear, Predictor::parabolic, Predictor::muscl};

struct Problem {
  std::string name;
  bool smooth;
  std::vector<int> cells;  ///< MUSCL's error on the last but one is the one compared at
  std::vector<int> more;   ///< for Godunov alone
};

std::vector<Problem> problems() {
  return {{"acoustic-2d", true, {8, 16, 32, 64, 128}, {256, 512}},
          {"entropy-2d", true, {16, 32, 64, 128}, {256, 512}},
          {"vortex-2d", true, {32, 64, 128, 192}, {256, 384}},
          {"acoustic-3d", true, {8, 16, 32, 64}, {96, 128}},
          {"sod-2d", false, {50, 100, 200, 400}, {800}},
          {"sod-angle-45", false, {32, 64, 128, 256}, {384}},
          {"sod-angle-irrational", false, {32, 64, 128, 256}, {384}},
          {"shu-osher-angle-45", false, {64, 128, 256, 384}, {512}},
          {"sedov-2d", false, {32, 64, 128, 192}, {256}},
          {"sedov-3d", false, {16, 24, 32, 48}, {64}}};
}

CurvePoint timed(Case const& problem, Scheme s, int cells) {
  CaseOptions o;
  o.cells = cells, o.predictor = predictors[s];
  o.riemann = s == muscl ? RiemannSolver::hllc : RiemannSolver::fast;
  return timed_case(problem, o, "density");
}

StudyReport run(StudyContext const& context) {
  Table curves{
      .name = "curves",
      .title = "density error and CPU time by grid",
      .columns =
          {{"problem", "1"}, {"scheme", "1"}, {"cells", "1"}, {"density_l1", "kg/m^3"}, {"cpu", "s"}, {"spread", "1"}},
      .rows = {},
      .facts = {}};
  Table ratios{.name = "ratios",
               .title = "CPU time at equal error: MUSCL-HLLC's on the last grid but one",
               .columns = {{"problem", "1"},
                           {"error", "kg/m^3"},
                           {"godunov_over_linear", "1"},
                           {"godunov_over_parabolic", "1"},
                           {"muscl_over_linear", "1"},
                           {"muscl_over_parabolic", "1"},
                           {"godunov", "1"}},
               .rows = {},
               .facts = {}};
  struct Demand {
    std::string claim;
    double least;
    std::string text{};
    bool holds = true;
    void add(std::string const& row, double value) {
      text += fmt::format("{} {:.3g}; ", row, value);
      holds = holds && value >= least;
    }
  };
  Demand smooth{"Godunov's time over the better modified scheme's at equal error, smooth: >= 500", 500};
  Demand shocked{"the same, shocks with structure: >= 30", 30};
  Demand all{"MUSCL-HLLC's time over the better modified scheme's: >= 1 on every row", 1};
  Demand gain{"the same, smooth: >= 4", 4};
  std::vector<Problem> const list = problems();
  for (std::size_t i = 0; i < list.size(); ++i) {
    Problem const& p = list[i];
    Case const problem = find_by_name(all_cases(), p.name, "work-precision-nd");
    std::array<std::vector<CurvePoint>, 4> curve;
    for (Scheme s : {godunov, linear, parabolic, muscl}) {
      if (context.progress)
        context.progress((static_cast<double>(i) + 0.25 * static_cast<double>(s)) / static_cast<double>(list.size()),
                         fmt::format("{} {}", p.name, names[s]));
      std::vector<int> grids = p.cells;
      if (s == godunov) grids.insert(grids.end(), p.more.begin(), p.more.end());
      for (int cells : grids) {
        CurvePoint const point = timed(problem, s, cells);
        curve[s].push_back(point);
        curves.rows.push_back(
            {p.name, std::string(names[s]), static_cast<long>(cells), point.error, point.seconds, point.spread});
      }
    }
    double const error = curve[muscl][curve[muscl].size() - 2].error;
    std::array<TimeAtError, 4> time;
    for (Scheme s : {godunov, linear, parabolic, muscl}) time[s] = time_at(curve[s], error);
    double const best = std::min(time[linear].seconds, time[parabolic].seconds);
    bool const beyond = time[godunov].kind == TimeAtError::Kind::extrapolated;
    ratios.rows.push_back({p.name, error, time[godunov].seconds / time[linear].seconds,
                           time[godunov].seconds / time[parabolic].seconds, time[muscl].seconds / time[linear].seconds,
                           time[muscl].seconds / time[parabolic].seconds,
                           std::string(beyond ? "extrapolated" : "reached")});
    (p.smooth ? smooth : shocked).add(p.name + (beyond ? "*" : ""), time[godunov].seconds / best);
    all.add(p.name, time[muscl].seconds / best);
    if (p.smooth) gain.add(p.name, time[muscl].seconds / best);
  }
  std::vector<Finding> findings;
  for (Demand const* d : {&smooth, &shocked, &all, &gain}) findings.push_back({d->claim, d->text, d->holds});
  return {{curves, ratios}, findings};
}

}  // namespace

Study work_precision_nd_study() {
  return {"work-precision-nd",
          "in two and three dimensions, too, the modified schemes reach an error in a small share of the time", run};
}

}  // namespace g27
