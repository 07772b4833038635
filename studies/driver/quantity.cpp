#include "studies/driver/quantity.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

/// First time at which a pressure passes the threshold, linear between rows.
std::optional<double> arrival(History const& history, std::string const& column, double threshold) {
  if (!history.has(column)) {
    return std::nullopt;
  }
  auto const& t = history["time"];
  auto const& p = history[column];
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (p[i - 1] <= threshold && p[i] > threshold) {
      return t[i - 1] + (t[i] - t[i - 1]) * (threshold - p[i - 1]) / (p[i] - p[i - 1]);
    }
  }
  return std::nullopt;
}

std::optional<double> wall_arrival(History const& history, OutputPlan const& plan, Expectation const&) {
  return arrival(history, "right_pressure", plan.threshold);
}

std::optional<double> column_at(std::string const& name, History const& history, Expectation const& e) {
  return history.has(name) ? finite(history.at(name, *e.time)) : std::nullopt;
}

std::optional<double> wall_impulse(History const& history, OutputPlan const& plan, Expectation const& e) {
  auto const since = wall_arrival(history, plan, e);
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
  return column_at("probe/" + e.probe + "/" + field, history, e);
}

std::optional<double> body_at(char const* field, History const& history, Expectation const& e) {
  return column_at("body/" + e.body + "/" + field + (e.axis.empty() ? "" : "_" + e.axis), history, e);
}

/// Momentum that a body holds and the gas did not give it: what interpolation between its grids made.
std::optional<double> body_momentum_rest(History const& history, OutputPlan const&, Expectation const& e) {
  std::string const column = "body/" + e.body + "/momentum_" + e.axis;
  if (!history.has(column) || history[column].empty()) {
    return std::nullopt;
  }
  return finite(history.at(column, *e.time) - history[column].front() -
                history.at("body/" + e.body + "/impulse_" + e.axis, *e.time));
}

}  // namespace

std::vector<HistoryQuantity> const& all_quantities() {
  static std::vector<HistoryQuantity> const table{
      {"shock_position", "outermost place where the pressure passes output.threshold", dimension::length,
       "time threshold", true, false,
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("shock_position", h, e); }},
      {"max_pressure", "largest cell pressure", dimension::pressure, "time", true, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("max_pressure", h, e); }},
      {"wall_arrival", "time at which the right wall's pressure passes output.threshold", dimension::time, "threshold",
       true, false, wall_arrival},
      {"wall_impulse", "impulse per area on the right wall since arrival", dimension::impulse, "after threshold", true,
       false, wall_impulse},
      {"wall_mean_peak", "largest mean pressure on the right wall over a window", dimension::pressure, "window", true,
       false, wall_mean_peak},
      {"probe_density", "density at a probe", dimension::density, "time probe", true, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("density", h, e); }},
      {"probe_velocity", "velocity at a probe", dimension::velocity, "time probe", true, false,
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("velocity", h, e); }},
      {"probe_pressure", "pressure at a probe", dimension::pressure, "time probe", true, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("pressure", h, e); }},
      {"probe_speed", "magnitude of the velocity at a probe", dimension::velocity, "time probe", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return probe_at("speed", h, e); }},
      {"probe_arrival", "time at which the pressure at a probe passes output.threshold", dimension::time,
       "probe threshold", true, true,
       [](History const& h, OutputPlan const& plan, Expectation const& e) {
         return arrival(h, "probe/" + e.probe + "/pressure", plan.threshold);
       }},
      {"shock_radius", "distance along a ray from output.origin at which the pressure falls through output.threshold",
       dimension::length, "time axis threshold", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("shock/" + e.axis, h, e); }},
      {"total_mass", "mass in the domain", dimension::mass, "time", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("total_mass", h, e); }},
      {"total_energy", "energy in the domain", dimension::energy, "time", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return column_at("total_energy", h, e); }},
      {"body_position", "place of a body's centre of mass", dimension::length, "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("centre", h, e); }},
      {"body_velocity", "velocity of a body's centre of mass", dimension::velocity, "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("velocity", h, e); }},
      {"body_momentum", "momentum of a body", dimension::momentum, "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("momentum", h, e); }},
      {"body_impulse", "momentum that the gas has given a body through its surface", dimension::momentum,
       "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("impulse", h, e); }},
      {"body_momentum_rest", "momentum of a body less that of the start and the impulse", dimension::momentum,
       "time body axis", false, true, body_momentum_rest},
      {"body_angular_momentum", "angular momentum of a body about its centre of mass", dimension::angular_momentum,
       "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("angular_momentum", h, e); }},
      {"body_extent", "extent of a body along an axis", dimension::length, "time body axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("extent", h, e); }},
      {"body_mass", "mass of a body", dimension::mass, "time body", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("mass", h, e); }},
      {"body_volume", "volume of a body", dimension::volume, "time body", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("volume", h, e); }},
      {"body_kinetic_energy", "kinetic energy of a body", dimension::energy, "time body", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("kinetic_energy", h, e); }},
      {"body_energy", "total energy of a body", dimension::energy, "time body", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("energy", h, e); }},
      {"body_plastic_strain", "largest equivalent plastic strain in a body", dimension::number, "time body", false,
       true, [](History const& h, OutputPlan const&, Expectation const& e) { return body_at("plastic_strain", h, e); }},
      {"face_position", "mean place of the triangles that faced one way at the start", dimension::length,
       "time probe face axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) {
         return probe_at(("position_" + e.axis).c_str(), h, e);
       }},
      {"face_velocity", "their mean velocity", dimension::velocity, "time probe face axis", false, true,
       [](History const& h, OutputPlan const&, Expectation const& e) {
         return probe_at(("velocity_" + e.axis).c_str(), h, e);
       }},
  };
  return table;
}

}  // namespace g27
