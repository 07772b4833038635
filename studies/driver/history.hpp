#pragma once
/// What a run records as it goes: named columns over time.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "studies/driver/scene.hpp"

namespace g27 {

/// What a history holds where there is nothing to tell.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct HistoryColumn {
  std::string name;  ///< "time", "shock_position", "right_pressure", "probe/near/pressure", ...
  std::string unit;
  std::vector<double> values;
};

class History {
 public:
  /// Columns of a run: time, dt, shock_position, max_pressure, left_ and right_ pressure and impulse, probes.
  explicit History(OutputPlan const& plan);
  explicit History(std::vector<HistoryColumn> columns) : columns_(std::move(columns)) {}

  /// Records the state after a step of `dt` (0 at the start). Impulses add up over every step; a row is kept every
  /// `history_every` seconds, always the first and, through `last`, the last.
  void record(GasLine const& line, OutputPlan const& plan, double dt, bool last);

  /// The row at `time` is one to keep; counts it as kept.
  bool due(double time, double every, bool last);
  void append(std::vector<double> const& row);

  [[nodiscard]] bool has(std::string const& name) const;
  [[nodiscard]] std::vector<HistoryColumn> const& columns() const noexcept { return columns_; }
  [[nodiscard]] std::vector<HistoryColumn>& columns() noexcept { return columns_; }
  [[nodiscard]] std::vector<double> const& operator[](std::string const& name) const;
  /// Column at `time`, linear between rows; NaN outside.
  [[nodiscard]] double at(std::string const& name, double time) const;

  /// Running totals that a restart needs beside the rows.
  struct Totals {
    double left_impulse = 0, right_impulse = 0, next = 0;
  };
  Totals totals;

 private:
  std::vector<HistoryColumn> columns_;
};

/// Linear interpolation of a cell field at x; the end cells' values beyond their centres.
double line_sample(GasLine const& line, std::span<double const> field, double x);

/// Outermost position where the pressure falls through `threshold` [Pa], linear between cell centres; NaN when none.
double shock_position(GasLine const& line, double threshold);

}  // namespace g27
