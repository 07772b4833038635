#pragma once
/// Tables of observed orders, and what is claimed of them.
#include <fmt/format.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "studies/driver/study.hpp"
#include "studies/orders/order_row.hpp"

namespace g27 {

/// A line a variable: orders in L1, L2 and Linf with their 95 % intervals.
Table order_table(std::vector<RowResult> const& results);
/// A line a variable and grid: the errors that the orders are fitted to.
Table error_table(std::vector<RowResult> const& results);

using Chosen = std::function<bool(OrderRow const&, VariableOrder const&)>;

/// Least and largest L1 order of the chosen lines, and where; a failure fails whatever is claimed of them.
struct Spread {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  std::string at_least, at_largest, failure;
  int fitted = 0, exact = 0;

  [[nodiscard]] bool within(double low, double high) const {
    return fitted > 0 && failure.empty() && least >= low && largest <= high;
  }
  [[nodiscard]] std::string text() const {
    std::string out =
        fitted == 0 ? std::string("none fitted")
                    : fmt::format("{:.3f} ({}) to {:.3f} ({}), {} fits", least, at_least, largest, at_largest, fitted);
    if (exact > 0) out += fmt::format(", {} exact", exact);
    if (!failure.empty()) out += "; failed: " + failure;
    return out;
  }
};

Spread spread(std::vector<RowResult> const& results, Chosen const& chosen);

/// A finding: every chosen order lies between `low` and `high`.
Finding order_claim(std::vector<RowResult> const& results, std::string const& text, double low, double high,
                    Chosen const& chosen);

/// Runs the rows in turn.
std::vector<RowResult> measure_orders(std::vector<OrderRow> const& rows, StudyContext const& context);

}  // namespace g27
