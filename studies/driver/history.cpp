#include "studies/driver/history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace g27 {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double centre(GasLine const& line, std::size_t cell) { return (line.faces()[cell] + line.faces()[cell + 1]) / 2; }

/// Linear interpolation of a cell field at x; the end cells' values beyond their centres.
double sample(GasLine const& line, std::span<double const> field, double x) {
  auto const faces = line.faces();
  auto const face = std::upper_bound(faces.begin() + 1, faces.end() - 1, x);
  auto cell = static_cast<std::size_t>(face - faces.begin()) - 1;
  cell = cell > 0 && x < centre(line, cell) ? cell - 1 : cell;
  if (cell + 1 >= field.size()) {
    return field[field.size() - 1];
  }
  double const a = centre(line, cell), b = centre(line, cell + 1);
  double const f = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return (1 - f) * field[cell] + f * field[cell + 1];
}

}  // namespace

double shock_position(GasLine const& line, double threshold) {
  auto const p = line.pressure();
  if (!(threshold > 0)) {
    return none;
  }
  for (std::size_t i = p.size(); i-- > 0;) {
    if (p[i] > threshold) {
      if (i + 1 == p.size()) {
        return line.faces().back();
      }
      double const f = (p[i] - threshold) / (p[i] - p[i + 1]);
      return (1 - f) * centre(line, i) + f * centre(line, i + 1);
    }
  }
  return none;
}

History::History(OutputPlan const& plan)
    : columns_{{"time", "s", {}},
               {"dt", "s", {}},
               {"shock_position", "m", {}},
               {"max_pressure", "Pa", {}},
               {"left_pressure", "Pa", {}},
               {"left_impulse", "Pa s", {}},
               {"right_pressure", "Pa", {}},
               {"right_impulse", "Pa s", {}}} {
  for (Probe const& probe : plan.probes) {
    columns_.push_back({"probe/" + probe.name + "/density", "kg/m3", {}});
    columns_.push_back({"probe/" + probe.name + "/velocity", "m/s", {}});
    columns_.push_back({"probe/" + probe.name + "/pressure", "Pa", {}});
  }
}

void History::record(GasLine const& line, OutputPlan const& plan, double dt, bool last) {
  bool const first = columns_[0].values.empty();
  // Before the first step there is no face state: the end cells stand for it.
  double const left = first ? line.pressure().front() : line.left_face().p;
  double const right = first ? line.pressure().back() : line.right_face().p;
  totals.left_impulse += left * dt;
  totals.right_impulse += right * dt;
  if (!first && !last && line.time() < totals.next) {
    return;
  }
  if (plan.history_every > 0) {
    while (totals.next <= line.time()) {
      totals.next = first && totals.next == 0 ? line.time() + plan.history_every : totals.next + plan.history_every;
    }
  }
  double const highest = *std::max_element(line.pressure().begin(), line.pressure().end());
  std::vector<double> row{
      line.time(),         dt, shock_position(line, plan.threshold), highest, left, totals.left_impulse, right,
      totals.right_impulse};
  for (Probe const& probe : plan.probes) {
    row.push_back(sample(line, line.density(), probe.position));
    row.push_back(sample(line, line.velocity(), probe.position));
    row.push_back(sample(line, line.pressure(), probe.position));
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    columns_[i].values.push_back(row[i]);
  }
}

std::vector<double> const& History::operator[](std::string const& name) const {
  for (auto const& column : columns_) {
    if (column.name == name) {
      return column.values;
    }
  }
  throw std::logic_error("no history column " + name);
}

double History::at(std::string const& name, double time) const {
  auto const& t = columns_[0].values;
  auto const& v = (*this)[name];
  if (t.empty() || time < t.front() || time > t.back()) {
    return none;
  }
  auto const next = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  if (t[next] == time) {
    return v[next];
  }
  double const f = (time - t[next - 1]) / (t[next] - t[next - 1]);
  return (1 - f) * v[next - 1] + f * v[next];
}

}  // namespace g27
