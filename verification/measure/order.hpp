#pragma once
/// Observed order of accuracy: least squares of ln(error) = ln(constant) + order ln(h) over a family of grids.
#include <cmath>
#include <span>
#include <vector>

namespace g27 {

struct OrderFit {
  double order = 0;
  double half_width = 0;  ///< of the 95 % confidence interval of the order (Student's t, grids - 2 degrees of freedom)
  double constant = 0;    ///< error = constant h^order
  std::vector<double> between;  ///< order between successive grids, [grids - 1]

  /// Two-sided: an order above the expected one is a defect as well.
  [[nodiscard]] bool is(double expected, double margin) const { return std::fabs(order - expected) <= margin; }
};

/// h: cell sizes, any order of grids; error: positive. Throws std::invalid_argument for fewer than four grids, equal
/// cell sizes, or errors that are not positive and finite.
OrderFit fit_order(std::span<double const> h, std::span<double const> error);

}  // namespace g27
