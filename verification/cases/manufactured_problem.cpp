#include "verification/cases/manufactured_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "verification/cases/media.hpp"
#include "verification/mms/manufactured_1d.hpp"

namespace g27 {

namespace {

/// Travelling waves of 10 % in all three variables (density in Mie-Grueneisen 2 %: with 10 % it would lie below the
/// cold curve), at speeds that are no characteristic of the gas.
template <class Law>
LineProblem manufactured(Medium const& m, Law const& law, Symmetry symmetry) {
  double const k = 2.0 * std::numbers::pi, c = m.sound, rho0 = m.base.rho, K = rho0 * c * c, p0 = m.base.p;
  double const swing = std::min(0.1, 2.0 * m.density_swing);
  auto const rho = [=](auto x, auto t) {
    using std::sin;
    return rho0 * (1.0 + swing * sin(k * (x - 0.6 * c * t)));
  };
  auto const u = [=](auto x, auto t) {
    using std::cos;
    return c * (0.3 + 0.1 * cos(k * (x + 0.4 * c * t)));
  };
  auto const p = [=](auto x, auto t) {
    using std::sin;
    return p0 + 0.1 * K * (1.1 + sin(k * (x - 0.2 * c * t) + 1.0));
  };
  LineProblem line{.eos = m.eos, .t_end = 0.5 / c, .symmetry = symmetry};
  Manufactured1d const fields(rho, u, p, law, symmetry);
  line.source = fields.gas_source();
  line.initial = [=](double a, double b) { return fields.average(a, b, 0.0); };
  line.reference = [=, t = line.t_end](double a, double b) { return fields.average(a, b, t); };
  if (symmetry == Symmetry::planar) {
    make_periodic(line);
  } else {
    line.x0 = 1.0, line.x1 = 2.0;
    line.left = {.kind = GasBoundary::Kind::inflow, .state = [=](double x, double t) { return fields.state(x, t); }};
    line.right = line.left;
  }
  return line;
}

}  // namespace

Case manufactured_case(std::string const& name, std::string const& title, Symmetry symmetry) {
  return {.name = name,
          .title = title,
          .source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4",
          .default_cells = 160,
          .eos = media(),
          .run = [=](CaseOptions const& options) {
            Medium const m = medium(options.eos.value_or("ideal"));
            LineProblem const line =
                std::visit([&](auto const& law) { return manufactured(m, law, symmetry); }, m.exact);
            return run_problem(name, 160, line, options);
          }};
}

}  // namespace g27
