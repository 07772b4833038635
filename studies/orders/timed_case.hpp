#pragma once
/// A point of a curve of error against CPU time: one case on one grid, run a few times.
#include <string>

#include "studies/orders/curve.hpp"
#include "verification/cases/case.hpp"

namespace g27 {

/// L1 error of `variable` and the least CPU time of a few runs on one thread; how many depends on what one costs.
CurvePoint timed_case(Case const& problem, CaseOptions options, std::string const& variable);

}  // namespace g27
