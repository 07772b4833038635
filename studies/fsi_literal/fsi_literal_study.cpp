/// Readings of the paper's method of overset grids against what is used in their place, on four cases that show what
/// they cost.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

/// In the order of the cases' parameter `literal`.
constexpr std::array readings{"as used",
                              "cores interpolated anew",
                              "velocities clipped",
                              "vertices along normals",
                              "vertices without gradient",
                              "fourth kind no donors",
                              "no traction at sides"};

/// A fact of a case whose exact value is known.
struct Quantity {
  char const *fact, *what;
  double exact = 0;
};

struct Problem {
  char const *name, *case_name;
  int cells;
  std::map<std::string, double> values;
  std::vector<Quantity> quantities;
};

std::vector<Problem> problems() {
  constexpr double angle = std::numbers::pi / 6;
  return {{"spin",
           "body-spin",
           20,
           {{"turns", 0.1}, {"mach", 0.1}},
           {{"angular_momentum", "angular momentum", 1}, {"volume_change", "volume"}}},
          {"sphere",
           "breathing-sphere",
           40,
           {{"eighths", 1}, {"periods", 2}},
           {{"energy_left", "energy", 1}, {"period_ratio", "period", 1}}},
          {"plate",
           "struck-plate",
           8,
           {{"drive", 100}, {"density", 10}, {"stiffness", 250}, {"crossings", 2.6}, {"angle", angle}, {"width", 9}},
           {{"front_error", "front face"},
            {"back_error", "back face"},
            {"push_error", "push"},
            {"momentum_less_impulse", "momentum over impulse"}}},
          {"blast", "cube-blast", 30, {{"end", 4e-6}}, {{"momentum_less_impulse", "momentum over impulse"}}}};
}

/// What a reading costs: the error that it has, which is larger than that of what is used, from ... to.
struct Cost {
  std::size_t reading;
  char const *problem, *quantity;
  double least, most;
};
constexpr std::array costs{Cost{1, "sphere", "energy", 0.1, 0.35},
                           Cost{3, "spin", "angular momentum", 0.001, 0.01},
                           Cost{3, "blast", "momentum over impulse", 0.025, 0.08},
                           Cost{4, "spin", "angular momentum", 0.01, 0.04},
                           Cost{6, "plate", "momentum over impulse", 0.07, 0.3},
                           Cost{6, "blast", "momentum over impulse", 0.3, 1.2}};
/// Those that change no error by more, beside those of one problem each.
constexpr std::size_t breaking = 6, clipped = 2, deep = 5;
constexpr double most_clipped = 5e-3, most_deep = 2e-2;

struct Outcome {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< none of a run that has broken down
  double done = 0;                                          ///< part of the time
};
/// [problem][quantity][reading]
using Outcomes = std::map<std::string, std::map<std::string, std::array<Outcome, readings.size()>>>;

double ratio(Outcome const& one, Outcome const& used) { return std::fabs(one.error / used.error); }

/// Of one problem, all readings.
void measure(Problem const& problem, std::function<void(double, std::string const&)> const& progress, Outcomes& out,
             Table& table) {
  Case const one = find_by_name(all_cases(), problem.case_name, "fsi-literal");
  double end = 0;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    CaseOptions o;
    o.cells = problem.cells, o.threads = threads_or_all(0), o.values = problem.values;
    o.values["literal"] = static_cast<double>(k);
    double part = 0;
    o.progress = [&](double done) {
      part = done;
      progress((static_cast<double>(k) + done) / readings.size(), fmt::format("{}, {}", problem.name, readings[k]));
    };
    CaseResult r;
    bool broken = false;
    try {
      r = one.run(o);
    } catch (std::runtime_error const&) {
      if (k == 0) throw;
      broken = true;
    }
    if (k == 0) end = r.time;
    for (Quantity const& q : problem.quantities) {
      auto& of_readings = out[problem.name][q.what];
      Outcome& outcome = of_readings[k];
      if (!broken) outcome = {r.facts.at(q.fact) - q.exact, r.time / end};
      if (broken) outcome.done = part;
      table.rows.push_back({std::string(problem.name), std::string(readings[k]), std::string(q.what), outcome.error,
                            ratio(outcome, of_readings[0]), outcome.done, r.cpu_s});
    }
  }
}

/// Largest change of an error by a reading.
double change(Outcomes const& outcomes, std::size_t reading, std::string const& without) {
  double most = 0;
  for (auto const& [problem, quantities] : outcomes) {
    if (problem == without) continue;
    for (auto const& [quantity, of_readings] : quantities) {
      double const one = std::fabs(of_readings[reading].error - of_readings[0].error);
      if (!(one <= most)) most = one;  // NaN as well
    }
  }
  return most;
}

StudyReport run(StudyContext const& context) {
  Table table{
      .name = "readings",
      .title = "Errors of readings of the paper, over those of what is used; the part done of a run that breaks down",
      .columns = {{"case", "1"},
                  {"reading", "1"},
                  {"quantity", "1"},
                  {"error", "1"},
                  {"over_used", "1"},
                  {"done", "1"},
                  {"cpu", "s"}},
      .rows = {},
      .facts = {}};
  std::vector<Problem> const all = problems();
  Outcomes outcomes;
  for (std::size_t n = 0; n < all.size(); ++n) {
    auto const progress = [&](double done, std::string const& what) {
      context.progress((static_cast<double>(n) + done) / static_cast<double>(all.size()), what);
    };
    measure(all[n], progress, outcomes, table);
  }
  std::vector<Finding> findings;
  for (Cost const& c : costs) {
    auto const& of_readings = outcomes.at(c.problem).at(c.quantity);
    double const error = of_readings[c.reading].error, used = of_readings[0].error, size = std::fabs(error);
    findings.push_back({fmt::format("{}: error of {}, {}, from {:g} to {:g}, and larger than that of what is used",
                                    readings[c.reading], c.quantity, c.problem, c.least, c.most),
                        fmt::format("{:.2g} instead of {:.2g}", error, used),
                        size >= c.least && size <= c.most && size > std::fabs(used)});
  }
  double const done = outcomes.at("spin").at("volume")[breaking].done;
  findings.push_back({fmt::format("{}: the spinning cube breaks down", readings[breaking]),
                      fmt::format("at {:.0f} %", 100 * done), done < 0.9});
  auto const harmless = [&](std::size_t reading, std::string const& without, std::string const& where, double most) {
    double const measured = change(outcomes, reading, without);
    findings.push_back({fmt::format("{}: no error changes by more than {:g}{}", readings[reading], most, where),
                        fmt::format("{:.2g}", measured), measured <= most});
  };
  harmless(clipped, "sphere", ", sphere apart", most_clipped);
  harmless(deep, "", "", most_deep);
  return {{table}, std::move(findings)};
}

}  // namespace

Study fsi_literal_study() {
  return {"fsi-literal",
          "readings of the paper on overset grids that are not used cost accuracy on some case, or do no harm", run};
}

}  // namespace g27
