#include "studies/driver/failure_capsule.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "riemann/eos/factory.hpp"
#include "studies/driver/simulate.hpp"

namespace g27 {

std::string failure_capsule(SceneRun const& run, GasLine const& line, StepReport const& report) {
  using Json = nlohmann::ordered_json;
  GasSchemeOptions const& options = run.setup.options;
  Json capsule{{"run", run.name},
               {"status", step_status_text(report.status)},
               {"cell", report.cell},
               {"time_s", line.time()},
               {"step", line.counters().steps},
               {"stable_dt_s", line.stable_dt()},
               {"eos", {{"type", eos_name(run.setup.eos)}, {"parameters", eos_values(run.setup.eos)}}},
               {"symmetry", symmetry_names()[static_cast<std::size_t>(run.setup.symmetry)]},
               {"scheme", run.scheme},
               {"switch", switch_names()[static_cast<std::size_t>(options.monotonicity)]},
               {"riemann", riemann_names()[static_cast<std::size_t>(options.riemann)]},
               {"feet", feet_names()[static_cast<std::size_t>(options.feet)]},
               {"linear_star", options.linear_star},
               {"cfl", options.cfl}};
  std::size_t const first = report.cell > 4 ? report.cell - 4 : 0, last = std::min(report.cell + 5, line.cells());
  for (std::size_t i = first; i < last; ++i) {
    auto const average = line.average(i);
    double const rho = line.density()[i], p = line.pressure()[i];
    capsule["stencil"].push_back(
        {{"cell", i},
         {"left_face_m", line.faces()[i]},
         {"right_face_m", line.faces()[i + 1]},
         {"density", rho},
         {"velocity", line.velocity()[i]},
         {"pressure", p},
         {"pressure_margin", std::visit([&](auto const& eos) { return eos.pressure_margin(rho, p); }, run.setup.eos)},
         {"mass", average.mass},
         {"momentum", average.momentum},
         {"energy", average.energy}});
  }
  return capsule.dump(2) + "\n";
}

std::string failure_capsule(SceneRun const& run, GasGrid const& grid, GridStepReport const& report) {
  using Json = nlohmann::ordered_json;
  GridSchemeOptions const& options = run.grid->setup.options;
  Json capsule{{"run", run.name},
               {"status", step_status_text(report.status)},
               {"cell", report.cell},
               {"cells", grid.cells()},
               {"widths_m", grid.widths()},
               {"time_s", grid.time()},
               {"step", grid.counters().steps},
               {"stable_dt_s", grid.stable_dt()},
               {"eos", {{"type", eos_name(run.eos())}, {"parameters", eos_values(run.eos())}}},
               {"scheme", run.scheme},
               {"switch", switch_names()[static_cast<std::size_t>(options.monotonicity)]},
               {"riemann", riemann_names()[static_cast<std::size_t>(options.riemann)]},
               {"transverse", transverse_names()[static_cast<std::size_t>(options.transverse)]},
               {"linear_star", options.linear_star},
               {"cure", options.cure},
               {"repair", options.repair},
               {"skip", options.skip},
               {"max_rule", options.max_rule},
               {"cfl", options.cfl}};
  Int3 first{}, last{};
  for (std::size_t d = 0; d < 3; ++d) {
    first[d] = std::max(report.cell[d] - 2, 0), last[d] = std::min(report.cell[d] + 3, grid.cells()[d]);
  }
  for (int k = first[2]; k < last[2]; ++k) {
    for (int j = first[1]; j < last[1]; ++j) {
      for (int i = first[0]; i < last[0]; ++i) {
        Int3 const cell{i, j, k};
        if (grid.solid(cell)) {
          capsule["stencil"].push_back({{"cell", cell}, {"solid", true}});
          continue;
        }
        GasPoint const s = grid.primitive(cell);
        GasDensities const q = grid.average(cell);
        double const margin = std::visit([&](auto const& eos) { return eos.pressure_margin(s.rho, s.p); }, run.eos());
        capsule["stencil"].push_back({{"cell", cell},
                                      {"centre_m", grid.centre(cell)},
                                      {"density", s.rho},
                                      {"velocity", s.u},
                                      {"pressure", s.p},
                                      {"pressure_margin", margin},
                                      {"mass", q.mass},
                                      {"momentum", q.momentum},
                                      {"energy", q.energy}});
      }
    }
  }
  return capsule.dump(2) + "\n";
}

std::string failure_capsule(SceneRun const& run, std::string const& why, double time) {
  using Json = nlohmann::ordered_json;
  return Json{{"run", run.name}, {"status", why}, {"time_s", time}, {"scheme", run.scheme}}.dump(2) + "\n";
}

}  // namespace g27
