#include "studies/driver/history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace g27 {
namespace {

double centre(GasLine const& line, std::size_t cell) { return (line.faces()[cell] + line.faces()[cell + 1]) / 2; }

}  // namespace

double line_sample(GasLine const& line, std::span<double const> field, double x) {
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
  if (!due(line.time(), plan.history_every, last)) {
    return;
  }
  double const highest = *std::max_element(line.pressure().begin(), line.pressure().end());
  std::vector<double> row{
      line.time(),         dt, shock_position(line, plan.threshold), highest, left, totals.left_impulse, right,
      totals.right_impulse};
  for (Probe const& probe : plan.probes) {
    row.push_back(line_sample(line, line.density(), probe.position[0]));
    row.push_back(line_sample(line, line.velocity(), probe.position[0]));
    row.push_back(line_sample(line, line.pressure(), probe.position[0]));
  }
  append(row);
}

bool History::due(double time, double every, bool last) {
  bool const first = columns_[0].values.empty();
  if (!first && !last && time < totals.next) {
    return false;
  }
  if (every > 0) {
    while (totals.next <= time) {
      totals.next = first && totals.next == 0 ? time + every : totals.next + every;
    }
  }
  return true;
}

void History::append(std::vector<double> const& row) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    columns_[i].values.push_back(row[i]);
  }
}

bool History::has(std::string const& name) const {
  return std::any_of(columns_.begin(), columns_.end(), [&](HistoryColumn const& c) { return c.name == name; });
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
