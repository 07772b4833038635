#pragma once
/// Error against CPU time of one scheme on one problem, and the time that a given error costs.
#include <span>

namespace g27 {

struct CurvePoint {
  int cells = 0;
  double error = 0;
  double seconds = 0;  ///< least of all repetitions
  double spread = 0;   ///< |ln| of the ratio of the best of the odd and the best of the even repetitions
};

struct TimeAtError {
  enum class Kind {
    interpolated,
    extrapolated,  ///< finer than the finest grid: along the line fitted to the last four
    coarsest       ///< the coarsest grid is already better: its time, an upper bound
  };
  Kind kind = Kind::interpolated;
  double seconds = 0;
  double uncertainty =
      0;  ///< of ln(seconds): repeatability, and twice the line's standard deviation where extrapolated
};

/// Time at which the curve, of increasing cells, first reaches `error`: piecewise linear in the logarithms.
/// Errors and times must be positive and at least two.
TimeAtError time_at(std::span<CurvePoint const> curve, double error);

}  // namespace g27
