#pragma once
/// Scalars drawn from a run's history: what [[expect]] may judge.
#include <optional>
#include <string>
#include <vector>

#include "studies/driver/history.hpp"
#include "studies/driver/scene.hpp"
#include "studies/driver/units.hpp"

namespace g27 {

struct HistoryQuantity {
  std::string name, what;
  Dimension dimension;
  /// keys of [[expect]] it takes, among: time after window probe axis body; `threshold`: [output] must set it; `face`:
  /// the probe is on a body
  std::string needs;
  bool on_line, on_grid;  ///< what records it
  /// Value in SI; empty when the run does not reach it (no arrival, ended before).
  std::optional<double> (*evaluate)(History const&, OutputPlan const&, Expectation const&);

  /// Only scenes with bodies have it.
  [[nodiscard]] bool of_bodies() const {
    return needs.find("body") != std::string::npos || needs.find("face") != std::string::npos;
  }
};

std::vector<HistoryQuantity> const& all_quantities();

}  // namespace g27
