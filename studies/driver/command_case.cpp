#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/scene.hpp"
#include "studies/driver/table.hpp"
#include "studies/driver/units.hpp"
#include "verification/cases/case.hpp"
#include "verification/exact/numerics.hpp"

namespace g27 {

std::string help_of(CaseArguments const& arguments) {
  if (arguments.name.empty()) return "";
  Case const c = find_by_name(all_cases(), arguments.name, "g27 case");
  std::string text = fmt::format("{}: {}\n", c.name, c.title);
  for (CaseParameter const& p : c.parameters) {
    text += fmt::format("  --set {}={:g}  [{}] {}\n", p.name, p.value, p.unit, p.what);
  }
  return text;
}

namespace {

std::size_t index_in(std::vector<std::string> const& names, std::string const& name, std::string const& option) {
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError("g27 case", option, fmt::format("unknown value '{}'", name), suggestion(name, names));
  }
  return static_cast<std::size_t>(found - names.begin());
}

bool is_on(std::string const& value, std::string const& option) { return index_in({"off", "on"}, value, option) == 1; }

/// key=value of the case's parameters.
std::map<std::string, double> values_of(CaseArguments const& a, Case const& chosen) {
  std::vector<std::string> names;
  for (CaseParameter const& p : chosen.parameters) names.push_back(p.name);
  std::map<std::string, double> values;
  if (names.empty() && !a.set.empty()) {
    throw InputError("g27 case", "--set", fmt::format("'{}' has no parameters", chosen.name), "leave --set out");
  }
  for (std::string const& pair : a.set) {
    auto const equals = pair.find('=');
    if (equals == std::string::npos) {
      throw InputError("g27 case", "--set", fmt::format("'{}' gives no value", pair), "write --set key=value");
    }
    CaseParameter const& parameter = chosen.parameters[index_in(names, pair.substr(0, equals), "--set")];
    std::string const text = pair.substr(equals + 1);
    std::string const unit = parameter.unit == "1" ? "" : parameter.unit;
    auto const number = number_in(text, parameter.unit);
    if (!number || !std::isfinite(*number)) {
      throw InputError("g27 case", "--set " + parameter.name,
                       fmt::format("'{}' is not a number{}", text, unit.empty() ? "" : " of " + unit),
                       unit.empty() ? "give a number" : "give a number, in " + unit + " unless it has a unit");
    }
    double const value = *number;
    if (!(value >= parameter.least && value <= parameter.most)) {
      throw InputError("g27 case", "--set " + parameter.name, fmt::format("{} is out of range", value),
                       fmt::format("choose it from {} to {}", parameter.least, parameter.most));
    }
    if (parameter.whole && value != std::floor(value)) {
      throw InputError("g27 case", "--set " + parameter.name, fmt::format("{} is not a whole number", value),
                       fmt::format("give one: {}", parameter.what));
    }
    values[parameter.name] = value;
  }
  return values;
}

void read_grid_options(CaseArguments const& a, Case const& chosen, CaseOptions& options) {
  auto const only = [&](bool given, char const* option, bool grid) {
    if (given && grid != (chosen.dimensions > 1)) {
      throw InputError("g27 case", option, fmt::format("is of no use in '{}'", chosen.name),
                       grid ? "choose a case in two or three dimensions" : "choose a case in one dimension");
    }
  };
  only(a.transverse.has_value(), "--transverse", true);
  only(a.cure.has_value(), "--cure", true);
  only(a.skip.has_value(), "--skip", true);
  only(!a.tile.empty(), "--tile", true);
  only(a.feet.has_value(), "--feet", false);
  if (chosen.solid && (a.riemann || a.feet || a.cure || a.skip)) {
    throw InputError("g27 case",
                     a.riemann ? "--riemann"
                     : a.feet  ? "--feet"
                     : a.cure  ? "--cure"
                               : "--skip",
                     fmt::format("is of no use in '{}'", chosen.name), "choose a case of gas");
  }
  if (a.transverse) {
    options.transverse = static_cast<Transverse>(index_in(transverse_names(), *a.transverse, "--transverse"));
  }
  if (a.cure) options.cure = is_on(*a.cure, "--cure");
  if (a.skip) options.skip = is_on(*a.skip, "--skip");
  if (!a.tile.empty()) {
    options.tile = Int3{a.tile[0], a.tile[1], a.tile[2]};
    if (*std::min_element(a.tile.begin(), a.tile.end()) < 1) {
      throw InputError("g27 case", "--tile", "has a side without cells", "give three whole numbers above 0");
    }
  }
}

CaseOptions options_of(CaseArguments const& a, Case const& chosen) {
  CaseOptions options;
  read_grid_options(a, chosen, options);
  options.values = values_of(a, chosen);
  options.threads = a.threads;
  options.cells = a.cells;
  options.cfl = a.cfl;
  if (a.cfl && !(*a.cfl > 0 && *a.cfl <= 1)) {
    throw InputError("g27 case", "--cfl", fmt::format("{} is out of range", *a.cfl), "choose it above 0 and up to 1");
  }
  if (a.order) {
    options.predictor = static_cast<Predictor>(*a.order - 1);
  }
  if (a.scheme) {
    options.predictor = static_cast<Predictor>(index_in(predictor_names(), *a.scheme, "--scheme"));
  }
  if (a.monotonicity) {
    std::string const name = *a.monotonicity == "on" ? "graded" : *a.monotonicity;
    options.monotonicity = static_cast<Switch>(index_in(switch_names(), name, "--switch"));
  }
  if (a.feet) {
    options.feet = static_cast<FootPoints>(index_in(feet_names(), *a.feet, "--feet"));
  }
  if (a.riemann) {
    options.riemann = static_cast<RiemannSolver>(index_in(riemann_names(), *a.riemann, "--riemann"));
  }
  if (a.mesh) {
    options.mesh = chosen.meshes[index_in(chosen.meshes, *a.mesh, "--mesh")];
  }
  if (a.eos) {
    options.eos = chosen.eos[index_in(chosen.eos, *a.eos, "--eos")];
  }
  return options;
}

nlohmann::ordered_json json_of(CaseResult const& r, std::map<std::string, double> const& set) {
  using Json = nlohmann::ordered_json;
  GridCounters const& c = r.counters;
  Json errors = Json::object();
  for (auto const& [variable, norms] : r.errors) {
    errors[variable] = {{"l1", norms.l1}, {"l2", norms.l2}, {"linf", norms.linf}};
  }
  double const updates = static_cast<double>(c.cell_updates);
  return {{"case", r.name},
          {"dimensions", r.dimensions},
          {"cells", r.cells},
          {"grid", r.grid},
          {"mesh", r.mesh},
          {"eos", r.eos},
          {"set", set},
          {"order", r.order},
          {"switch", r.monotonicity},
          {"steps", c.steps},
          {"cpu_s", r.cpu_s},
          {"wall_s", r.wall_s},
          {"cell_updates_per_s", r.wall_s > 0 ? updates / r.wall_s : 0.0},
          {"errors", errors},
          {"switch_fraction", c.faces > 0 ? static_cast<double>(c.switched) / static_cast<double>(c.faces) : 0.0},
          {"fallbacks",
           {{"linear_star", c.linear_star},
            {"repaired", c.repaired},
            {"floored", c.floored},
            {"retried", c.retried},
            {"cured", c.cured}}},
          {"cells_skipped", c.cells_skipped},
          {"facts", r.facts},
          {"ledger",
           {{"mass", r.ledger.mass.residual()},
            {"momentum", r.ledger.momentum.residual()},
            {"energy", r.ledger.energy.residual()}}}};
}

void print_text(Case const& chosen, CaseResult const& r, std::map<std::string, double> const& set) {
  std::string const cells =
      r.dimensions == 1 ? fmt::format("{}", r.cells) : fmt::format("{}", fmt::join(r.grid, " x "));
  fmt::print("{}\n{}\n\n{} cells, {} mesh, {}, {} scheme, switch {}\n", chosen.title, chosen.source, cells, r.mesh,
             r.eos, r.scheme, r.monotonicity);
  GridCounters const& c = r.counters;
  fmt::print("{} steps to t = {:.6g} s in {:.3f} s: {:.3g} cell updates a second\n\n", c.steps, r.time, r.wall_s,
             r.wall_s > 0 ? static_cast<double>(c.cell_updates) / r.wall_s : 0.0);
  Table table{.name = "errors",
              .title = r.errors.empty() ? "no reference solution" : "Error of the cell averages",
              .columns = {{"variable", "1"}, {"L1", "1"}, {"L2", "1"}, {"Linf", "1"}},
              .rows = {},
              .facts = {}};
  for (auto const& [variable, norms] : r.errors) {
    table.rows.push_back({variable, norms.l1, norms.l2, norms.linf});
  }
  double const faces = std::max(1.0, static_cast<double>(c.faces));
  table.facts = {{"faces on which the switch acted, %", 100 * static_cast<double>(c.switched) / faces},
                 {"faces redone at first order", static_cast<long>(c.repaired)},
                 {"cells raised to the vacuum floor", static_cast<long>(c.floored)},
                 {"steps redone", static_cast<long>(c.retried)},
                 {"unaccounted mass", r.ledger.mass.residual()},
                 {"unaccounted momentum", r.ledger.momentum.residual()},
                 {"unaccounted energy", r.ledger.energy.residual()}};
  if (r.dimensions > 1) {
    table.facts.emplace_back("faces in shocks along the grid", static_cast<long>(c.cured));
    table.facts.emplace_back("cell updates left out", static_cast<long>(c.cells_skipped));
  }
  for (auto const& [name, value] : set) table.facts.emplace_back("set: " + name, value);
  for (auto const& [name, value] : r.facts) table.facts.emplace_back(name, value);
  fmt::print("{}", to_text(table));
}

/// Options that a case cannot make sense of, or for which it has no exact solution, are the user's mistake.
CaseResult run(Case const& chosen, CaseOptions options) {
  constexpr auto patience = std::chrono::seconds(2);
  Progress progress({1.0});
  auto const began = std::chrono::steady_clock::now();
  options.progress = [&](double done) {
    if (std::chrono::steady_clock::now() - began > patience) progress.update(0, done, chosen.name);
  };
  try {
    return chosen.run(options);
  } catch (std::invalid_argument const& error) {
    throw InputError("g27 case", chosen.name, error.what(), "choose other options");
  } catch (NumericsError const& error) {
    throw InputError("g27 case", chosen.name, error.what(), "choose other options");
  }
}

}  // namespace

int command_case(CaseArguments const& arguments) {
  Case const chosen = find_by_name(all_cases(), arguments.name, "g27 case");
  CaseOptions const options = options_of(arguments, chosen);
  CaseResult const result = run(chosen, options);
  if (arguments.json) {
    fmt::print("{}\n", json_of(result, options.values).dump(2));
  } else {
    print_text(chosen, result, options.values);
  }
  return 0;
}

}  // namespace g27
