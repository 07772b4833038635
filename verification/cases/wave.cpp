#include "verification/cases/wave.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "verification/exact/simple_wave.hpp"

namespace g27 {

Case wave_case(std::string const& name, std::string const& title, double amplitude, double periods) {
  auto const run = [=](CaseOptions const& options) {
    Medium const m = medium(options.eos.value_or("ideal"));
    GasState<> const base{m.base.rho, 0.3 * m.sound, m.base.p};
    double const a = amplitude * m.sound, k = 2.0 * std::numbers::pi;
    auto const wave = std::make_shared<SimpleWave>(
        m.exact, base, [=](double x) { return a * std::sin(k * x); }, a);
    LineProblem line{.eos = m.eos, .t_end = periods / (1.3 * m.sound)};
    make_periodic(line);
    auto const at = [=](double t) {
      return mean_of(m.eos, Symmetry::planar, [=](double x) { return wave->at(x, t); });
    };
    line.initial = at(0.0), line.reference = at(line.t_end);
    return run_problem(name, 160, line, options);
  };
  return {.name = name,
          .title = title,
          .source = "exact simple wave: Courant and Friedrichs (1948), section 40",
          .default_cells = 160,
          .eos = media(),
          .run = run};
}

}  // namespace g27
