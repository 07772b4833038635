/// The carbuncle: noise on a steady plane shock, with and without the cure, and what the cure costs elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

constexpr double noise = 1e-7, allowed = 1e-6;  ///< relative; transverse velocity over the sound speed behind
constexpr int steps = 1000;
constexpr double allowed_growth = 1.01;  ///< of a case's density error with the cure on

struct Scheme {
  char const* name;
  Predictor predictor;
};
constexpr std::array schemes{Scheme{"godunov", Predictor::godunov}, Scheme{"linear", Predictor::linear},
                             Scheme{"parabolic", Predictor::parabolic}};

struct Check {
  char const* name;
  int cells;
};
constexpr std::array checks{Check{"vortex-2d", 64},
                            Check{"entropy-2d", 48},
                            Check{"sod-2d", 200},
                            Check{"sod-angle-45", 96},
                            Check{"sod-angle-irrational", 96},
                            Check{"shu-osher-2d", 200},
                            Check{"sedov-2d", 96},
                            Check{"sedov-3d", 32},
                            Check{"noh-2d", 64},
                            Check{"wedge-2d", 80}};

StudyReport run(StudyContext const& context) {
  Table shocks{
      .name = "shocks",
      .title = "velocity along a steady shock with noise, over the sound speed behind it",
      .columns =
          {{"case", "1"}, {"scheme", "1"}, {"mach", "1"}, {"cured", "1"}, {"uncured", "1"}, {"cured_faces", "1"}},
      .rows = {},
      .facts = {{"noise", noise}, {"steps", long{steps}}}};
  Table errors{
      .name = "errors",
      .title = "L1 error of density with and without the cure",
      .columns =
          {{"case", "1"}, {"scheme", "1"}, {"with", "1"}, {"without", "1"}, {"ratio", "1"}, {"cured_faces", "1"}},
      .rows = {},
      .facts = {}};
  double most = 0, least_uncured = std::numeric_limits<double>::infinity(), worst = 0;
  std::string at_most, at_worst;
  int done = 0, all = 18 + 3 * static_cast<int>(checks.size());
  auto const progress = [&](std::string const& what) {
    if (context.progress) context.progress(static_cast<double>(done++) / all, what);
  };
  for (int dimensions : {2, 3}) {
    std::string const name = dimensions == 2 ? "carbuncle-2d" : "carbuncle-3d";
    Case const problem = find_by_name(all_cases(), name, "carbuncle");
    for (Scheme const& s : schemes) {
      for (double mach : {5.0, 10.0, 20.0}) {
        progress(fmt::format("{} {} Mach {:g}", name, s.name, mach));
        CaseOptions o;
        o.cells = dimensions == 2 ? 48 : 32, o.predictor = s.predictor;
        o.values = {{"mach", mach}, {"noise", noise}, {"steps", steps}};
        o.cure = true;
        CaseResult const with = problem.run(o);
        o.cure = false;
        double uncured = std::numeric_limits<double>::infinity();
        try {
          uncured = problem.run(o).facts.at("transverse_velocity");
        } catch (std::runtime_error const&) {
          // the shock tears the flow apart: as large as can be
        }
        double const cured = with.facts.at("transverse_velocity");
        shocks.rows.push_back(
            {name, std::string(s.name), mach, cured, uncured, static_cast<long>(with.counters.cured)});
        if (cured > most) most = cured, at_most = fmt::format("{} {} Mach {:g}", name, s.name, mach);
        least_uncured = std::min(least_uncured, uncured);
      }
    }
  }
  for (Check const& c : checks) {
    Case const problem = find_by_name(all_cases(), c.name, "carbuncle");
    for (Scheme const& s : schemes) {
      progress(fmt::format("{} {}", c.name, s.name));
      CaseOptions o;
      o.cells = c.cells, o.predictor = s.predictor;
      o.cure = true;
      CaseResult const with = problem.run(o);
      o.cure = false;
      double const a = with.errors.at("density").l1, b = problem.run(o).errors.at("density").l1;
      errors.rows.push_back(
          {std::string(c.name), std::string(s.name), a, b, a / b, static_cast<long>(with.counters.cured)});
      if (!(a / b <= worst)) worst = a / b, at_worst = fmt::format("{} {}", c.name, s.name);
    }
  }
  return {{shocks, errors},
          {{fmt::format("with the cure noise of {:g} stays below {:g} for {} steps, Mach 5 to 20, 2D and 3D", noise,
                        allowed, steps),
            fmt::format("largest {:.2g} ({})", most, at_most), most < allowed},
           {"without the cure it grows to a hundredth of the sound speed or more somewhere: the cases can tell",
            fmt::format("least of all rows {:.2g}", least_uncured),
            std::any_of(shocks.rows.begin(), shocks.rows.end(),
                        [](auto const& r) { return std::get<double>(r[4]) > 1e-2; })},
           {"the cure raises no case's density error by more than 1 %",
            fmt::format("largest ratio {:.4f} ({})", worst, at_worst), worst <= allowed_growth}}};
}

}  // namespace

Study carbuncle_study() {
  return {"carbuncle",
          "a steady shock along the grid keeps its noise small, and the cure that does it costs no accuracy", run};
}

}  // namespace g27
