#include "studies/driver/quantity.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

/// First time at which the right wall's pressure passes the threshold, linear between rows.
std::optional<double> arrival(History const& history, OutputPlan const& plan) {
  auto const& t = history["time"];
  auto const& p = history["right_pressure"];
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (p[i - 1] <= plan.threshold && p[i] > plan.threshold) {
      return t[i - 1] + (t[i] - t[i - 1]) * (plan.threshold - p[i - 1]) / (p[i] - p[i - 1]);
    }
  }
  return std::nullopt;
}

std::optional<double> column_at(char const* name, History const& history, Expectation const& e) {
  return finite(history.at(name, *e.time));
}

std::optional<double> wall_impulse(History const& history, OutputPlan const& plan, Expectation const& e) {
  auto const since = arrival(history, plan);
  return since ? finite(history.at("right_impulse", *since + *e.after) - history.at("right_impulse", *since))
               : std::nullopt;
}

std::optional<double> wall_mean_peak(History const& history, OutputPlan const&, Expectation const& e) {
  std::optional<double> best;
  for (double const t : history["time"]) {
    double const gain = history.at("right_impulse", t + *e.window) - history.at("right_impulse", t);
    if (std::isfinite(gain)) {
      best = std::max(best.value_or(gain / *e.window), gain / *e.window);
    }
  }
  return best;
}

std::optional<double> probe_at(char const* field, History const& history, Expectation const& e) {
  std::string const name = "probe/" + e.probe + "/" + field;
  for (auto const& column : history.columns()) {
    if (column.name == name) {
      return finite(history.at(name, *e.time));
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<HistoryQuantity> const& all_quantities() {
  static std::vector<HistoryQuantity> const table{
      {"shock_position", "outermost place where the pressure passes output.threshold", dimension::length,
       "time threshold",
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("shock_position", h, e); }},
      {"max_pressure", "largest cell pressure", dimension::pressure, "time",
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("max_pressure", h, e); }},
      {"wall_arrival", "time at which the right wall's pressure passes output.threshold", dimension::time, "threshold",
       [](History const& h, OutputPlan const& plan, Expectation const&) { return arrival(h, plan); }},
      {"wall_impulse", "impulse per area on the right wall since arrival", dimension::impulse, "after threshold",
       wall_impulse},
      {"wall_mean_peak", "largest mean pressure on the right wall over a window", dimension::pressure, "window",
       wall_mean_peak},
      {"probe_density", "density at a probe", dimension::density, "time probe",
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("density", h, e); }},
      {"probe_velocity", "velocity at a probe", dimension::velocity, "time probe",
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("velocity", h, e); }},
      {"probe_pressure", "pressure at a probe", dimension::pressure, "time probe",
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("pressure", h, e); }},
  };
  return table;
}

}  // namespace g27
