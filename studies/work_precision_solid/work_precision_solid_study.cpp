/// CPU time to a given error of solids: Godunov's scheme and the modified ones.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/timed_case.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

enum Scheme { godunov, linear, parabolic };
constexpr std::array all_schemes{godunov, linear, parabolic};
constexpr std::array names{"godunov", "linear", "parabolic"};
constexpr std::array predictors{Predictor::godunov, Predictor::linear, Predictor::parabolic};

struct Problem {
  std::string name;
  bool smooth;
  std::vector<int> cells;  ///< the linear scheme's error on the last but one is the one compared at
  std::vector<int> more;   ///< for Godunov alone
};

std::vector<Problem> problems() {
  return {{"solid-p-1d", true, {20, 40, 80, 160, 320}, {640, 1280}},
          {"solid-s-1d", true, {20, 40, 80, 160, 320}, {640, 1280}},
          {"solid-coupled-1d", true, {20, 40, 80, 160, 320}, {640, 1280}},
          {"solid-uniaxial-1d", true, {80, 160, 320, 640}, {1280, 2560}},
          {"solid-coupled-2d", true, {32, 48, 64, 96, 128}, {192, 256}},
          {"solid-coupled-3d", true, {20, 30, 40, 50}, {60}},
          {"flying-plate", false, {125, 250, 500, 1000, 2000}, {4000, 8000}},
          {"piston-ep", false, {100, 200, 400, 800}, {1600, 3200}}};
}

CurvePoint timed(Case const& problem, Scheme s, int cells) {
  CaseOptions o;
  o.cells = cells, o.predictor = predictors[s];
  return timed_case(problem, o, "velocity");
}

StudyReport run(StudyContext const& context) {
  Table curves{
      .name = "curves",
      .title = "error of the velocity and CPU time by grid",
      .columns =
          {{"problem", "1"}, {"scheme", "1"}, {"cells", "1"}, {"velocity_l1", "m/s"}, {"cpu", "s"}, {"spread", "1"}},
      .rows = {},
      .facts = {}};
  Table ratios{.name = "ratios",
               .title = "CPU time at equal error: the linear scheme's on the last grid but one",
               .columns = {{"problem", "1"},
                           {"error", "m/s"},
                           {"godunov_over_linear", "1"},
                           {"godunov_over_parabolic", "1"},
                           {"linear_over_parabolic", "1"},
                           {"godunov", "1"}},
               .rows = {},
               .facts = {}};
  struct Demand {
    std::string claim;
    double least;
    std::string text{};
    bool holds = true;
    void add(std::string const& row, double value) {
      text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", row, value);
      holds = holds && value >= least;
    }
  };
  Demand smooth{"Godunov's time over the better modified scheme's at equal error, smooth waves: >= 100", 100};
  Demand shocked{"the same, plate and piston: >= 10", 10};
  std::vector<Problem> const list = problems();
  for (std::size_t i = 0; i < list.size(); ++i) {
    Problem const& p = list[i];
    Case const problem = find_by_name(all_cases(), p.name, "work-precision-solid");
    std::array<std::vector<CurvePoint>, 3> curve;
    for (Scheme s : all_schemes) {
      if (context.progress)
        context.progress((static_cast<double>(i) + static_cast<double>(s) / 3) / static_cast<double>(list.size()),
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
    double const error = curve[linear][curve[linear].size() - 2].error;
    std::array<TimeAtError, 3> time;
    for (Scheme s : all_schemes) time[s] = time_at(curve[s], error);
    double const best = std::min(time[linear].seconds, time[parabolic].seconds);
    bool const beyond = time[godunov].kind == TimeAtError::Kind::extrapolated;
    ratios.rows.push_back(
        {p.name, error, time[godunov].seconds / time[linear].seconds, time[godunov].seconds / time[parabolic].seconds,
         time[linear].seconds / time[parabolic].seconds, std::string(beyond ? "extrapolated" : "reached")});
    (p.smooth ? smooth : shocked).add(p.name + (beyond ? "*" : ""), time[godunov].seconds / best);
  }
  std::vector<Finding> findings;
  for (Demand const* d : {&smooth, &shocked}) findings.push_back({d->claim, d->text, d->holds});
  return {{curves, ratios}, findings};
}

}  // namespace

Study work_precision_solid_study() {
  return {"work-precision-solid",
          "the modified schemes reach an error of solids in a small share of Godunov's time; *: extrapolated", run};
}

}  // namespace g27
