/// [output] and [[expect]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/driver/quantity.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

std::string unit_of(Node const& node) {
  auto const* text = std::get_if<std::string>(&node.value);
  if (text == nullptr) {
    return "";
  }
  std::size_t const at = text->find(' ');
  return at == std::string::npos ? "" : text->substr(text->find_first_not_of(' ', at));
}

/// "5 %" is relative to the value; anything else has the value's dimension.
double read_tolerance(Section const& section, Dimension const& dimension, double value) {
  Node const& node = section.need("tolerance", "\"1 %\"");
  auto const* text = std::get_if<std::string>(&node.value);
  bool const relative = text != nullptr && text->find('%') != std::string::npos;
  double const tolerance = relative ? section.quantity("tolerance", dimension::number) * std::fabs(value)
                                    : section.quantity("tolerance", dimension);
  if (!(tolerance > 0)) {
    throw section.error("tolerance", "is not positive", "give \"1 %\" or an amount in the value's unit");
  }
  return tolerance;
}

}  // namespace

OutputPlan read_output(Section const& root, double start, double end, double left, double right) {
  OutputPlan plan;
  plan.threshold = 0;
  if (!root.has("output")) {
    plan.snapshots = {start, end};
    return plan;
  }
  Section const section = root.table("output", {"snapshots", "every", "threshold", "probe", "map"});
  if (section.has("snapshots")) {
    for (double const t : section.quantities("snapshots", dimension::time)) {
      if (!plan.snapshots.empty() && !(t > plan.snapshots.back())) {
        throw section.error("snapshots", "do not increase", "sort the times");
      }
      if (t < 0) {
        throw section.error("snapshots", fmt::format("{} s is before the start", t), "give times from 0");
      }
      plan.snapshots.push_back(t);
    }
  }
  // Times outside this run's interval belong to another variant; every run records its two ends.
  std::erase_if(plan.snapshots, [&](double t) { return t <= start || t >= end; });
  plan.snapshots.insert(plan.snapshots.begin(), start);
  plan.snapshots.push_back(end);
  plan.history_every = section.has("every") ? section.positive("every", dimension::time) : 0.0;
  plan.threshold = section.has("threshold") ? section.positive("threshold", dimension::pressure) : 0.0;
  plan.map_times = section.has("map") ? static_cast<int>(section.integer("map", 0, 10000)) : plan.map_times;
  for (Section const& probe : section.tables("probe", {"name", "position"})) {
    Probe const read{probe.text("name"), probe.quantity("position", dimension::length)};
    if (read.name.empty() || read.name.find('/') != std::string::npos) {
      throw probe.error("name", "is empty or has a slash", "give a short name");
    }
    for (Probe const& other : plan.probes) {
      if (other.name == read.name) {
        throw probe.error("name", fmt::format("'{}' is taken", read.name), "give each probe its own name");
      }
    }
    if (read.position < left) {
      throw probe.error("position", fmt::format("{} m lies outside the domain", read.position),
                        fmt::format("choose it from {} m to {} m", left, right));
    }
    if (read.position <= right) {  // a variant may have a shorter domain
      plan.probes.push_back(read);
    }
  }
  return plan;
}

std::vector<Expectation> read_expectations(Section const& root, std::vector<std::string> const& variants) {
  std::vector<std::string> const keys{"quantity", "variant", "probe", "schemes",   "time",
                                      "after",    "window",  "value", "tolerance", "source"};
  std::vector<std::string> names;
  for (auto const& quantity : all_quantities()) {
    names.push_back(quantity.name);
  }
  std::vector<Expectation> out;
  for (Section const& section : root.tables("expect", keys)) {
    Expectation e;
    e.quantity = section.text("quantity");
    auto const& quantity = all_quantities()[index_of_choice(section, "quantity", e.quantity, names)];
    e.variant = variants[section.choice("variant", variants, 0)];
    for (auto const& [key, target] : {std::pair{"time", &e.time}, {"after", &e.after}, {"window", &e.window}}) {
      bool const wanted = quantity.needs.find(key) != std::string::npos;
      if (wanted != section.has(key)) {
        throw section.error(key, fmt::format("{} by '{}'", wanted ? "is needed" : "is not used", e.quantity),
                            wanted ? fmt::format("add {} = \"20 us\"", key) : fmt::format("remove {}", key));
      }
      if (wanted) {
        *target = section.quantity(key, dimension::time);
      }
    }
    if (quantity.needs.find("threshold") != std::string::npos &&
        (!root.has("output") || root.need("output", "").find("threshold") == nullptr)) {
      throw section.error("quantity", fmt::format("'{}' needs output.threshold", e.quantity),
                          "add threshold = \"10 bar\" to [output]");
    }
    if (quantity.needs.find("probe") != std::string::npos) {
      e.probe = section.text("probe");
      bool known = false;
      for (Section const& probe : root.table("output", {"snapshots", "every", "threshold", "probe", "map"})
                                      .tables("probe", {"name", "position"})) {
        known = known || probe.text("name") == e.probe;
      }
      if (!known) {
        throw section.error("probe", fmt::format("'{}' is not in [[output.probe]]", e.probe), "name one of the probes");
      }
    }
    e.value = section.quantity("value", quantity.dimension);
    e.tolerance = read_tolerance(section, quantity.dimension, e.value);
    e.unit = unit_of(section.node().find("value") != nullptr ? *section.node().find("value") : section.node());
    e.unit = e.unit.empty() ? si_unit(quantity.dimension.exponents) : e.unit;
    e.unit_si = parse_unit(e.unit).value_or(Quantity{1, {}, true}).value;
    e.source = section.text("source", "");
    if (section.has("schemes")) {
      auto const* list = std::get_if<Node::Array>(&section.need("schemes", "").value);
      if (list == nullptr) {
        throw section.error("schemes", "is not a list", "write [\"linear\", \"parabolic\"]");
      }
      for (Node const& node : *list) {
        auto const* text = std::get_if<std::string>(&node.value);
        e.schemes.push_back(
            predictor_names()[index_of_choice(section, "schemes", text != nullptr ? *text : "?", predictor_names())]);
      }
    }
    out.push_back(std::move(e));
  }
  return out;
}

}  // namespace g27
