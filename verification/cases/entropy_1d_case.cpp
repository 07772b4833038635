#include <cmath>
#include <numbers>

#include "verification/cases/line_problem.hpp"
#include "verification/cases/media.hpp"

namespace g27 {

Case entropy_1d_case() {
  return {.name = "entropy-1d",
          .title = "density wave of 20 % (JWL 5 %, Mie-Grueneisen 1 %) carried at 0.3 of the sound speed",
          .source = "exact: advection at constant u and p, for every equation of state",
          .default_cells = 160,
          .eos = media(),
          .run = [](CaseOptions const& options) {
            Medium const m = medium(options.eos.value_or("ideal"));
            double const u = 0.3 * m.sound, k = 2.0 * std::numbers::pi;
            LineProblem line{.eos = m.eos, .t_end = 1.0 / m.sound};
            make_periodic(line);
            auto const at = [=](double t) {
              return mean_of(m.eos, Symmetry::planar, [=](double x) -> GasState<> {
                return {m.base.rho * (1.0 + m.density_swing * std::sin(k * (x - u * t))), u, m.base.p};
              });
            };
            line.initial = at(0.0), line.reference = at(line.t_end);
            return run_problem("entropy-1d", 160, line, options);
          }};
}

}  // namespace g27
