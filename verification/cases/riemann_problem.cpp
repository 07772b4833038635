#include "verification/cases/riemann_problem.hpp"

#include <memory>

#include "verification/exact/gas_riemann.hpp"

namespace g27 {

Case riemann_case(RiemannProblem const& p) {
  return {.name = p.name,
          .title = p.title,
          .source = p.source,
          .default_cells = 200,
          .eos = {eos_name(p.exact)},
          .run = [p](CaseOptions const& options) {
            auto const exact = std::make_shared<GasRiemann>(p.exact, p.left, p.exact, p.right);
            LineProblem line{.eos = p.eos, .x0 = p.x0, .x1 = p.x1, .t_end = p.t_end};
            line.initial = [=](double a, double b) { return exact->average(a - p.x_jump, b - p.x_jump, 0.0); };
            line.reference = [=](double a, double b) { return exact->average(a - p.x_jump, b - p.x_jump, p.t_end); };
            return run_problem(p.name, 200, line, options);
          }};
}

}  // namespace g27
