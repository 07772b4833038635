#pragma once
/// Cases that are Riemann problems: two states, where they meet, when to look.
#include <string>

#include "verification/cases/line_problem.hpp"
#include "verification/cases/media.hpp"

namespace g27 {

struct RiemannProblem {
  std::string name, title, source;
  GasState<> left, right;
  double x_jump = 0.5, t_end = 0.2, x0 = 0, x1 = 1;
  AnyEos eos = IdealGas{1.4};
  ExactEos exact = IdealLaw{1.4};
};

/// A case of it, with the exact solution of verification/exact as the reference and gas flowing out at both ends.
Case riemann_case(RiemannProblem const& problem);

}  // namespace g27
