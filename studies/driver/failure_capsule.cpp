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

}  // namespace g27
