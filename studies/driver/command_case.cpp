#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/scene.hpp"
#include "studies/driver/table.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

std::size_t index_in(std::vector<std::string> const& names, std::string const& name, std::string const& option) {
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError("g27 case", option, fmt::format("unknown value '{}'", name), suggestion(name, names));
  }
  return static_cast<std::size_t>(found - names.begin());
}

CaseOptions options_of(CaseArguments const& a, Case const& chosen) {
  CaseOptions options;
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
    std::vector<std::string> const meshes{"uniform", "graded", "alternating", "random", "moving", "moving-random"};
    options.mesh = meshes[index_in(meshes, *a.mesh, "--mesh")];
  }
  if (a.eos) {
    options.eos = chosen.eos[index_in(chosen.eos, *a.eos, "--eos")];
  }
  return options;
}

nlohmann::ordered_json json_of(CaseResult const& r) {
  using Json = nlohmann::ordered_json;
  GasCounters const& c = r.counters;
  Json errors = Json::object();
  for (auto const& [variable, norms] : r.errors) {
    errors[variable] = {{"l1", norms.l1}, {"l2", norms.l2}, {"linf", norms.linf}};
  }
  double const updates = static_cast<double>(c.cell_updates);
  return {{"case", r.name},
          {"cells", r.cells},
          {"order", r.order},
          {"switch", r.monotonicity},
          {"steps", c.steps},
          {"cpu_s", r.cpu_s},
          {"wall_s", r.wall_s},
          {"cell_updates_per_s", r.wall_s > 0 ? updates / r.wall_s : 0.0},
          {"errors", errors},
          {"switch_fraction", c.faces > 0 ? static_cast<double>(c.switched) / static_cast<double>(c.faces) : 0.0},
          {"fallbacks",
           {{"linear_star", c.linear_star}, {"repaired", c.repaired}, {"floored", c.floored}, {"retried", c.retried}}},
          {"ledger",
           {{"mass", r.ledger.mass.residual()},
            {"momentum", r.ledger.momentum.residual()},
            {"energy", r.ledger.energy.residual()}}}};
}

void print_text(Case const& chosen, CaseResult const& r) {
  fmt::print("{}\n{}\n\n{} cells, {} mesh, {}, {} scheme, switch {}\n", chosen.title, chosen.source, r.cells, r.mesh,
             r.eos, r.scheme, r.monotonicity);
  GasCounters const& c = r.counters;
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
  fmt::print("{}", to_text(table));
}

}  // namespace

int command_case(CaseArguments const& arguments) {
  Case const chosen = find_by_name(all_cases(), arguments.name, "g27 case");
  CaseResult const result = chosen.run(options_of(arguments, chosen));
  if (arguments.json) {
    fmt::print("{}\n", json_of(result).dump(2));
  } else {
    print_text(chosen, result);
  }
  return 0;
}

}  // namespace g27
