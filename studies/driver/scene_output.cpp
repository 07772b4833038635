/// [output] and [[expect]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/driver/quantity.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

std::vector<std::string> output_keys(int dimensions) {
  if (dimensions == 1) {
    return {"snapshots", "every", "threshold", "probe", "map"};
  }
  return {"snapshots", "every", "threshold", "probe", "origin", "repairs"};
}

std::vector<std::string> probe_keys(std::vector<std::string> const& bodies) {
  return bodies.empty() ? std::vector<std::string>{"name", "position"}
                        : std::vector<std::string>{"name", "position", "body", "face"};
}

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
  auto const* text = std::get_if<std::string>(&section.need("tolerance", "\"1 %\"").value);
  bool const relative = text != nullptr && text->find('%') != std::string::npos;
  double const tolerance = relative ? section.quantity("tolerance", dimension::number) * std::fabs(value)
                                    : section.quantity("tolerance", dimension);
  if (!(tolerance > 0)) {
    throw section.error("tolerance", "is not positive", "give \"1 %\" or an amount in the value's unit");
  }
  return tolerance;
}

/// A list for `value` stands for as many expectations: the other lists run along with it, single entries are shared.
std::vector<Node> spread(Section const& section) {
  auto const& entries = std::get<Node::Table>(section.node().value);
  auto const length = [](Node const& node) {
    auto const* list = std::get_if<Node::Array>(&node.value);
    return list != nullptr ? list->size() : 0;
  };
  std::size_t const count = section.has("value") ? length(section.need("value", "")) : 0;
  std::vector<Node> out(std::max<std::size_t>(count, 1), section.node());
  for (std::size_t e = 0; e < entries.size(); ++e) {
    std::size_t const n = length(entries[e].node);
    if (entries[e].key == "schemes" || n == 0) {
      continue;
    }
    if (n != count) {
      throw section.error(entries[e].key,
                          fmt::format("has {} entries, value has {}", n, std::max<std::size_t>(count, 1)),
                          "make the lists equally long, or give one entry for all");
    }
    for (std::size_t i = 0; i < n; ++i) {
      std::get<Node::Table>(out[i].value)[e].node = std::get<Node::Array>(entries[e].node.value)[i];
    }
  }
  return out;
}

/// `probe` of an expectation: one of the scene, on a body's face or in the gas as the quantity asks.
std::string read_expected_probe(Section const& root, Section const& section, std::vector<std::string> const& bodies,
                                int dimensions, std::string const& quantity, bool on_face) {
  std::string const name = section.text("probe");
  if (root.has("output")) {
    for (Section const& probe : root.table("output", output_keys(dimensions)).tables("probe", probe_keys(bodies))) {
      if (probe.text("name") != name) {
        continue;
      }
      if (on_face && !probe.has("body")) {
        throw section.error("probe", fmt::format("'{}' is not on a body, as '{}' needs", name, quantity),
                            "name a probe with body and face");
      }
      if (probe.has("body") && quantity == "probe_density") {
        throw section.error("probe", fmt::format("'{}' is on a body's face, which has no density", name),
                            "name a probe with a position");
      }
      return name;
    }
  }
  throw section.error("probe", fmt::format("'{}' is not in [[output.probe]]", name), "name one of the probes");
}

std::vector<std::string> read_judged_schemes(Section const& section) {
  std::vector<std::string> out;
  if (!section.has("schemes")) {
    return out;
  }
  auto const* list = std::get_if<Node::Array>(&section.need("schemes", "").value);
  if (list == nullptr || list->empty()) {
    throw section.error("schemes", "is not a list of names", "write [\"linear\", \"parabolic\"]");
  }
  for (Node const& node : *list) {
    auto const* text = std::get_if<std::string>(&node.value);
    out.push_back(
        predictor_names()[index_of_choice(section, "schemes", text != nullptr ? *text : "?", predictor_names())]);
  }
  return out;
}

bool is_later(double time, double end) { return time > end * (1 + 1e-9); }

/// What a run never gets to is never measured.
void check_reached(Section const& section, std::string const& key, double t, SceneRun const& run) {
  bool const span = key != "time";
  if (is_later(t, span ? run.end - run.start : run.end)) {
    throw section.error(
        key,
        span ? fmt::format("{:g} s is longer than '{}', from {:g} s to {:g} s", t, run.variant, run.start, run.end)
             : fmt::format("{:g} s is after the end of '{}' at {:g} s", t, run.variant, run.end),
        "choose it within the run, set time.end later, or expect nothing by --set expect=[]");
  }
  if (!span && t < run.start) {
    throw section.error(key, fmt::format("{:g} s is before the start of '{}' at {:g} s", t, run.variant, run.start),
                        "choose it within the run");
  }
}

Expectation read_expectation(Section const& root, Section const& section, std::vector<std::string> const& variants,
                             std::vector<SceneRun> const& runs, std::vector<std::string> const& bodies) {
  int const dimensions = runs[0].dimensions();
  std::vector<std::string> names;
  for (auto const& quantity : all_quantities()) {
    if ((dimensions == 1 ? quantity.on_line : quantity.on_grid) && (!bodies.empty() || !quantity.of_bodies())) {
      names.push_back(quantity.name);
    }
  }
  Expectation e;
  e.quantity = section.text("quantity");
  (void)index_of_choice(section, "quantity", e.quantity, names);
  auto const& quantity = *std::find_if(all_quantities().begin(), all_quantities().end(),
                                       [&](HistoryQuantity const& q) { return q.name == e.quantity; });
  auto const takes = [&](char const* key) { return quantity.needs.find(key) != std::string::npos; };
  e.variant = variants[section.choice("variant", variants, 0)];
  SceneRun const& run =
      *std::find_if(runs.begin(), runs.end(), [&](SceneRun const& r) { return r.variant == e.variant; });
  for (auto const& [key, target] : {std::pair{"time", &e.time}, {"after", &e.after}, {"window", &e.window}}) {
    if (takes(key) != section.has(key)) {
      throw section.error(key, fmt::format("{} by '{}'", takes(key) ? "is needed" : "is not used", e.quantity),
                          takes(key) ? fmt::format("add {} = \"20 us\"", key) : fmt::format("remove {}", key));
    }
    if (takes(key)) {
      *target = section.positive(key, dimension::time);
      check_reached(section, key, **target, run);
    }
  }
  if (takes("threshold") && (!root.has("output") || root.need("output", "").find("threshold") == nullptr)) {
    throw section.error("quantity", fmt::format("'{}' needs output.threshold", e.quantity),
                        "add threshold = \"10 bar\" to [output]");
  }
  if (takes("body")) {
    e.body = bodies[index_of_choice(section, "body", section.text("body"), bodies)];
  } else if (section.has("body")) {
    throw section.error("body", fmt::format("is not used by '{}'", e.quantity), "remove body");
  }
  if (takes("probe")) {
    e.probe = read_expected_probe(root, section, bodies, dimensions, e.quantity, takes("face"));
  } else if (section.has("probe")) {
    throw section.error("probe", fmt::format("is not used by '{}'", e.quantity), "remove probe");
  }
  if (takes("axis")) {
    auto rays = ray_names();
    if (dimensions == 2) {
      std::erase(rays, "z");
    }
    if (quantity.of_bodies()) {
      std::erase(rays, "diagonal");
    }
    e.axis = rays[index_of_choice(section, "axis", section.text("axis"), rays)];
  } else if (section.has("axis")) {
    throw section.error("axis", fmt::format("is not used by '{}'", e.quantity), "remove axis");
  }
  e.value = section.quantity("value", quantity.dimension);
  e.tolerance = read_tolerance(section, quantity.dimension, e.value);
  e.unit = unit_of(section.need("value", ""));
  e.unit = e.unit.empty() ? si_unit(quantity.dimension.exponents) : e.unit;
  e.unit_si = parse_unit(e.unit).value_or(Quantity{1, {}, true}).value;
  e.source = section.text("source", "");
  e.judged = section.flag("judged", true);
  e.schemes = read_judged_schemes(section);
  return e;
}

/// Adds a probe; one beyond the domain is an error below its lower corner and left out above its upper one, since a
/// variant may have a smaller domain.
void read_probe(Section const& section, Extent const& extent, OutputPlan& plan) {
  Probe read{.name = section.text("name")};
  std::vector<Probe>& probes = plan.probes;
  if (read.name.empty() || read.name.find('/') != std::string::npos) {
    throw section.error("name", "is empty or has a slash", "give a short name");
  }
  for (Probe const& other : probes) {
    if (other.name == read.name) {
      throw section.error("name", fmt::format("'{}' is taken", read.name), "give each probe its own name");
    }
  }
  for (BodyProbe const& other : plan.body_probes) {
    if (other.name == read.name) {
      throw section.error("name", fmt::format("'{}' is taken", read.name), "give each probe its own name");
    }
  }
  if (section.has("body") || section.has("face")) {
    if (section.has("position")) {
      throw section.error("position", "is given beside a body", "keep position, or body and face");
    }
    std::size_t const face = index_of_choice(section, "face", section.text("face"), face_names());
    plan.body_probes.push_back({.name = read.name,
                                .body = index_of_choice(section, "body", section.text("body"), extent.bodies),
                                .axis = face / 2,
                                .sign = face % 2 == 0 ? -1.0 : 1.0});
    return;
  }
  if (extent.dimensions == 1) {
    read.position[0] = section.quantity("position", dimension::length);
  } else {
    read.position = section.point("position", dimension::length, extent.dimensions);
  }
  bool inside = true;
  for (std::size_t d = 0; d < static_cast<std::size_t>(extent.dimensions); ++d) {
    if (read.position[d] < extent.lower[d]) {
      throw section.error("position", fmt::format("{} m lies outside the domain", read.position[d]),
                          fmt::format("choose it from {} m to {} m", extent.lower[d], extent.upper[d]));
    }
    inside = inside && read.position[d] <= extent.upper[d];
  }
  if (inside) {
    probes.push_back(std::move(read));
  }
}

}  // namespace

void check_probes_seen(Section const& root, std::vector<SceneRun> const& runs) {
  if (!root.has("output")) {
    return;
  }
  Section const output = root.table("output", output_keys(runs[0].dimensions()));
  for (Section const& probe : output.tables("probe", {"name", "position", "body", "face"})) {
    bool const seen = probe.has("body") || std::any_of(runs.begin(), runs.end(), [&](SceneRun const& run) {
                        auto const& probes = run.output.probes;
                        return std::any_of(probes.begin(), probes.end(),
                                           [&](Probe const& p) { return p.name == probe.text("name"); });
                      });
    if (!seen) {
      throw probe.error("position", "lies outside the domain of every run", "choose it within the domain");
    }
  }
}

OutputPlan read_output(Section const& root, double start, double end, Extent const& extent) {
  OutputPlan plan;
  int const dimensions = extent.dimensions;
  // A row of a grid looks at every cell: some hundreds of them tell enough.
  plan.history_every = dimensions > 1 ? (end - start) / 400 : 0.0;
  plan.origin = extent.lower;
  if (!root.has("output")) {
    plan.snapshots = {start, end};
    return plan;
  }
  Section const section = root.table("output", output_keys(dimensions));
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
  // Times outside this run's interval belong to another variant (check_snapshots); every run records its two ends.
  std::erase_if(plan.snapshots, [&](double t) { return t <= start || t >= end; });
  plan.snapshots.insert(plan.snapshots.begin(), start);
  plan.snapshots.push_back(end);
  plan.history_every = section.has("every") ? section.positive("every", dimension::time) : plan.history_every;
  plan.threshold = section.has("threshold") ? section.positive("threshold", dimension::pressure) : 0.0;
  plan.map_times = section.has("map") ? static_cast<int>(section.integer("map", 0, 10000)) : plan.map_times;
  plan.repairs = section.flag("repairs", false);
  if (section.has("origin")) {
    plan.origin = section.point("origin", dimension::length, dimensions);
  }
  for (Section const& probe : section.tables("probe", probe_keys(extent.bodies))) {
    read_probe(probe, extent, plan);
  }
  return plan;
}

void check_snapshots(Section const& root, int dimensions, double latest) {
  if (!root.has("output")) return;
  Section const section = root.table("output", output_keys(dimensions));
  if (!section.has("snapshots")) return;
  for (double const t : section.quantities("snapshots", dimension::time)) {
    if (is_later(t, latest)) {
      throw section.error("snapshots", fmt::format("{:g} s is after the end at {:g} s", t, latest),
                          "leave it out, set time.end later, or take none by --set output.snapshots=[]");
    }
  }
}

std::vector<Expectation> read_expectations(Section const& root, std::vector<std::string> const& variants,
                                           std::vector<SceneRun> const& runs) {
  std::vector<std::string> bodies;
  for (SceneRun const& run : runs) {
    for (std::size_t n = 0; run.grid && n < run.grid->bodies.size(); ++n) bodies.push_back(run.grid->bodies[n].name);
  }
  std::vector<std::string> keys{"quantity", "variant", "probe",     "schemes", "time",  "after",
                                "window",   "value",   "tolerance", "source",  "judged"};
  if (runs[0].dimensions() > 1) {
    keys.emplace_back("axis");
  }
  if (!bodies.empty()) {
    keys.emplace_back("body");
  }
  std::vector<Expectation> out;
  for (Section const& section : root.tables("expect", keys)) {
    for (Node const& node : spread(section)) {
      out.push_back(
          read_expectation(root, Section(section.reading(), node, section.path(), keys), variants, runs, bodies));
    }
  }
  return out;
}

}  // namespace g27
