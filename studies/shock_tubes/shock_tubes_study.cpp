/// Shock tubes and other problems with discontinuities, every scheme against the exact solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/shock_tubes/recorded_errors.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

constexpr double overshoot_target = 0.01;   ///< of the jump
constexpr double variation_margin = 0.001;  ///< of the variation

struct Scheme {
  std::string name;
  Predictor predictor;
  Switch monotonicity;
  bool linear_star;  ///< the acoustic star state where the jump is weak
  bool bounded;      ///< a switch or limiter that is meant to bound the solution
};

std::vector<Scheme> schemes() {
  return {{"godunov", Predictor::godunov, Switch::graded, true, true},
          {"linear", Predictor::linear, Switch::graded, true, true},
          {"linear-solver", Predictor::linear, Switch::graded, false, true},
          {"binary", Predictor::linear, Switch::binary, false, true},
          {"literal", Predictor::linear, Switch::literal, false, false},
          {"parabolic", Predictor::parabolic, Switch::graded, true, true},
          {"muscl", Predictor::muscl, Switch::graded, true, false},
          {"muscl-solver", Predictor::muscl, Switch::graded, false, false}};
}

struct Problem {
  std::string name;
  int cells = 200;
};

std::vector<Problem> problems() {
  return {{"sod"},
          {"toro1"},
          {"toro2"},
          {"toro3"},
          {"toro4"},
          {"toro5"},
          {"lax"},
          {"leblanc"},
          {"contact"},
          {"slow-shock"},
          {"tube-1e10"},
          {"vacuum"},
          {"water-tube"},
          {"jwl-tube"},
          {"impact"},
          {"breakout"},
          {"shu-osher"},
          {"shu-osher", 400},
          {"woodward-colella", 400}};
}

std::string label(Problem const& p) {
  return p.name == "shu-osher" || p.cells != 200 ? fmt::format("{}-{}", p.name, p.cells) : p.name;
}

double worst_of(std::map<std::string, double> const& by_variable) {
  double worst = -std::numeric_limits<double>::infinity();
  for (auto const& [variable, value] : by_variable) worst = value <= worst ? worst : value;  // keeps a NaN
  return worst;
}

/// One scheme's runs of one problem; empty where the scheme failed.
using Row = std::map<std::string, std::optional<CaseResult>>;

Row run_problem_with_all(Problem const& problem) {
  Case const tube = find_by_name(all_cases(), problem.name, "shock-tubes");
  Row row;
  for (Scheme const& s : schemes()) {
    try {
      CaseOptions options;
      options.cells = problem.cells, options.cfl = 0.8;
      options.predictor = s.predictor, options.monotonicity = s.monotonicity, options.linear_star = s.linear_star;
      row[s.name] = tube.run(options);
    } catch (std::runtime_error const&) {
      row[s.name] = std::nullopt;
    }
  }
  return row;
}

double density_error(CaseResult const& r) { return r.errors.at("density").l1; }

std::vector<Value> table_row(Problem const& problem, Scheme const& s, Row const& row) {
  auto const& r = row.at(s.name);
  if (!r) {
    std::vector<Value> failed{label(problem), s.name};
    failed.insert(failed.end(), 14, Value{std::numeric_limits<double>::quiet_NaN()});
    return failed;
  }
  GasCounters const& c = r->counters;
  double const faces = static_cast<double>(c.faces), godunov = density_error(*row.at("godunov"));
  return {label(problem),
          s.name,
          density_error(*r),
          density_error(*r) / godunov,
          r->overshoot.at("density"),
          r->overshoot.at("velocity"),
          r->overshoot.at("pressure"),
          r->tv_excess.at("density"),
          r->tv_excess.at("velocity"),
          r->tv_excess.at("pressure"),
          static_cast<double>(c.switched) / faces,
          static_cast<double>(c.repaired),
          static_cast<double>(c.floored),
          static_cast<double>(c.retried),
          *std::min_element(r->rho.begin(), r->rho.end()),
          *std::min_element(r->p.begin(), r->p.end())};
}

/// Profiles for the figures, one group a problem: x, the reference, and each scheme's fields and switch map.
void write_profiles(Hdf5Writer& out, Problem const& problem, Row const& row) {
  std::string const group = "/" + label(problem) + "/";
  bool reference = false;
  for (auto const& [scheme, r] : row) {
    if (!r) continue;
    if (!reference) {
      out.write(group + "x", r->x, "m");
      out.write(group + "reference/density", r->rho_ref, "kg/m^3");
      out.write(group + "reference/velocity", r->u_ref, "m/s");
      out.write(group + "reference/pressure", r->p_ref, "Pa");
      out.attribute("/" + label(problem), "time", r->time);
      reference = true;
    }
    out.write(group + scheme + "/density", r->rho, "kg/m^3");
    out.write(group + scheme + "/velocity", r->u, "m/s");
    out.write(group + scheme + "/pressure", r->p, "Pa");
    std::vector<double> share = r->switched;
    for (double& s : share) s /= static_cast<double>(r->counters.steps);
    out.write(group + scheme + "/switched", share, "1");
  }
}

/// Collects the rows on which something is not met, and the worst of it.
struct Tally {
  double worst = -std::numeric_limits<double>::infinity();
  std::string where = "none", failing;
  int rows = 0, failures = 0;
  void add(std::string const& row, double excess, std::string const& figures) {
    ++rows;
    if (!(excess <= worst)) worst = excess, where = fmt::format("{} {}", row, figures);
    if (excess <= 0) return;
    ++failures;
    failing += fmt::format("{}{} {}", failing.empty() ? "" : "; ", row, figures);
  }
  [[nodiscard]] Finding finding(std::string claim) const {
    return {std::move(claim),
            failures == 0 ? fmt::format("{} rows, closest: {}", rows, where)
                          : fmt::format("{} of {} rows fail: {}", failures, rows, failing),
            rows > 0 && failures == 0};
  }
};

StudyReport run(StudyContext const& context) {
  Table table{.name = "tubes",
              .title = "errors, overshoot (over the jump) and excess total variation against the exact solution",
              .columns = {{"problem", "1"},
                          {"scheme", "1"},
                          {"density_l1", "kg/m^3"},
                          {"over_godunov", "1"},
                          {"overshoot_density", "1"},
                          {"overshoot_velocity", "1"},
                          {"overshoot_pressure", "1"},
                          {"tv_density", "1"},
                          {"tv_velocity", "1"},
                          {"tv_pressure", "1"},
                          {"switched", "1"},
                          {"repairs", "1"},
                          {"floors", "1"},
                          {"retries", "1"},
                          {"least_density", "kg/m^3"},
                          {"least_pressure", "Pa"}},
              .rows = {},
              .facts = {{"cfl", 0.8}}};
  Hdf5Writer profiles;
  Tally accuracy, bounded, compared, variation, slow, positive;
  std::size_t done = 0;
  for (Problem const& problem : problems()) {
    std::string const name = label(problem);
    context.progress(static_cast<double>(done++) / static_cast<double>(problems().size()), name);
    Row const row = run_problem_with_all(problem);
    write_profiles(profiles, problem, row);
    for (Scheme const& s : schemes()) {
      auto const& r = row.at(s.name);
      table.rows.push_back(table_row(problem, s, row));
      bool const modified = s.bounded && s.name != "godunov";
      if (s.bounded) {
        bool const sound = r && *std::min_element(r->rho.begin(), r->rho.end()) > 0;
        positive.add(name + " " + s.name, sound ? -1 : 1, sound ? "" : "failed");
      }
      if (!r) continue;
      std::string const scheme = name + " " + s.name;
      if (auto const recorded = recorded_error(name, s.name)) {
        double const error =
            recorded->absolute ? density_error(*r) : density_error(*r) / density_error(*row.at("godunov"));
        accuracy.add(scheme, error - recorded->value - recorded->margin,
                     fmt::format("{:.4g} ({:.4g})", error, recorded->value));
      }
      if (modified) {
        double const overshoot = worst_of(r->overshoot), size = 100 * overshoot;
        double const unswitched =
            std::max(worst_of(row.at("godunov")->overshoot), worst_of(row.at("muscl")->overshoot));
        bounded.add(scheme, overshoot - overshoot_target, fmt::format("{:.2g} %", size));
        compared.add(scheme, overshoot - std::max(overshoot_target, unswitched),
                     fmt::format("{:.2g} % ({:.2g} %)", size, 100 * unswitched));
        // a variation below the reference's is smearing, no merit: it counts as none
        double const tv = r->tv_excess.at("density"), muscl = std::max(row.at("muscl")->tv_excess.at("density"), 0.0);
        (problem.name == "slow-shock" ? slow : variation)
            .add(scheme, tv - muscl - variation_margin, fmt::format("{:.3f} ({:.3f})", tv, muscl));
      }
    }
  }
  profiles.save(context.out / "profiles.h5");
  return {{table},
          {accuracy.finding("density error over Godunov's no worse than that on record (in brackets)"),
           bounded.finding("overshoot in any variable <= 1 % of the jump where a switch acts"),
           compared.finding("overshoot <= 1 % or the larger of Godunov's and MUSCL van Leer's (in brackets)"),
           variation.finding("excess total variation of density no larger than MUSCL van Leer's (in brackets)"),
           slow.finding("the same on the slow shock"),
           positive.finding("every problem is survived without a negative density or pressure")}};
}

}  // namespace

Study shock_tubes_study() {
  return {"shock-tubes",
          "the modified schemes follow the exact solution of every tube more closely than Godunov's, within its bounds",
          run};
}

}  // namespace g27
