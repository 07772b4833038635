#pragma once
/// A problem of elastoplastic solids on a line that moves with the material, as data, and how it is run.
#include <functional>
#include <string>

#include "scheme/step/solid_line.hpp"
#include "verification/cases/case.hpp"

namespace g27 {

struct SolidLineProblem {
  AnySolid solid{};
  Symmetry symmetry = Symmetry::planar;
  double x0 = 0, x1 = 1;  ///< ends at the start [m]; equal cells between them
  SolidBoundary left{.kind = SolidBoundary::Kind::free}, right{.kind = SolidBoundary::Kind::free};
  double t_end = 1;                                       ///< [s]
  std::function<SolidPoint(double x)> initial{};          ///< jumps lie on faces
  std::function<bool(SolidLine const& line)> finished{};  ///< ends the run before t_end; empty: nothing does
  /// What is measured at the end, into the result's facts
  std::function<void(SolidLine const& line, CaseResult& result)> measure{};
};

/// What the options of a case say of the scheme on a line.
SolidSchemeOptions solid_line_options(CaseOptions const& options);

/// Runs the problem; throws std::runtime_error when a step fails. The result has a profile, and no errors.
CaseResult run_problem(std::string const& name, int cells, SolidLineProblem const& problem, CaseOptions const& options);

}  // namespace g27
