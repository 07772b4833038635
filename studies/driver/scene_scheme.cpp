/// [scheme]: which schemes run, and with which options.
#include <fmt/format.h>

#include <algorithm>

#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

Predictor of_order(Section const& section, Node const& node) {
  auto const* order = std::get_if<long>(&node.value);
  if (order == nullptr || *order < 1 || *order > 3) {
    throw section.error("order", order == nullptr ? "is not a whole number" : fmt::format("{} is unknown", *order),
                        "choose 1 (Godunov), 2 (linear profile) or 3 (parabola), or a list of these");
  }
  return static_cast<Predictor>(*order - 1);
}

Predictor of_name(Section const& section, Node const& node) {
  auto const* name = std::get_if<std::string>(&node.value);
  if (name == nullptr) {
    throw section.error("name", fmt::format("is {}, not text", node.type_name()),
                        "choose godunov, linear, parabolic or muscl, or a list of these");
  }
  return static_cast<Predictor>(index_of_choice(section, "name", *name, predictor_names()));
}

/// What [scheme] asks for, applied to `options` one scheme at a time.
template <class Options>
std::vector<Options> one_each(Section const& section, Options options) {
  if (section.has("order") && section.has("name")) {
    throw section.error("name", "is given beside order", "keep one: order = 2 is name = \"linear\"");
  }
  std::string const key = section.has("name") ? "name" : "order";
  if (!section.has(key)) {
    return {options};
  }
  Node const& node = section.need(key, "2");
  auto const* list = std::get_if<Node::Array>(&node.value);
  std::vector<Options> out;
  for (Node const& entry : list != nullptr ? *list : Node::Array{node}) {
    options.predictor = key == "name" ? of_name(section, entry) : of_order(section, entry);
    for (auto const& other : out) {
      if (other.predictor == options.predictor) {
        throw section.error(key, "names a scheme twice", "list each scheme once");
      }
    }
    out.push_back(options);
  }
  if (out.empty()) {
    throw section.error(key, "is an empty list", "name at least one scheme");
  }
  return out;
}

template <class Options>
void read_common(Section const& section, Options& options) {
  options.monotonicity = static_cast<Switch>(section.choice("switch", switch_names(), 3));
  options.riemann = static_cast<RiemannSolver>(section.choice("riemann", riemann_names(), 0));
  options.linear_star = section.flag("linear_star", options.linear_star);
}

}  // namespace

std::vector<GasSchemeOptions> read_schemes(Section const& root, double cfl) {
  GasSchemeOptions options;
  options.cfl = cfl;
  if (!root.has("scheme")) {
    return {options};
  }
  Section const section = root.table("scheme", {"order", "name", "switch", "riemann", "feet", "linear_star"});
  read_common(section, options);
  options.feet = static_cast<FootPoints>(section.choice("feet", feet_names(), 0));
  return one_each(section, options);
}

std::vector<GridSchemeOptions> read_grid_schemes(Section const& root, double cfl, int dimensions) {
  GridSchemeOptions options;
  options.cfl = cfl;
  if (!root.has("scheme")) {
    return {options};
  }
  std::vector<std::string> keys{"order", "name",   "switch", "riemann",  "linear_star", "transverse",
                                "cure",  "repair", "skip",   "max_rule", "tile"};
  if (root.has("body")) {
    keys.insert(keys.end(), {"closure", "remeshing"});
  }
  Section const section = root.table("scheme", keys);
  read_common(section, options);
  options.transverse = static_cast<Transverse>(section.choice("transverse", transverse_names(), 0));
  options.cure = section.flag("cure", options.cure);
  options.repair = section.flag("repair", options.repair);
  options.skip = section.flag("skip", options.skip);
  options.max_rule = section.flag("max_rule", options.max_rule);
  if (section.has("tile")) {
    options.tile = section.counts("tile", static_cast<std::size_t>(dimensions), 4, 1024);
  }
  return one_each(section, options);
}

void read_scheme_of_bodies(Section const& root, GridRun& grid) {
  Node const* scheme = root.node().find("scheme");
  if (scheme == nullptr) {
    return;
  }
  std::vector<std::string> every_key;
  for (NodeEntry const& entry : std::get<Node::Table>(scheme->value)) {
    every_key.push_back(entry.key);
  }
  Section const section = root.table("scheme", every_key);
  grid.closure = section.flag("closure", grid.closure);
  grid.remeshing = section.flag("remeshing", grid.remeshing);
}

void check_schemes_of_bodies(Section const& root, GridSchemeOptions const& options, double body_cfl) {
  if (options.predictor == Predictor::muscl) {
    throw root.error("scheme", "asks for 'muscl', which bodies do not know", "choose order = 1, 2 or 3");
  }
  if (options.predictor == Predictor::parabolic && body_cfl > largest_parabolic_body_cfl) {
    throw root.error(
        "time", fmt::format("body_cfl is {:g}; that of order 3 is at most {:g}", body_cfl, largest_parabolic_body_cfl),
        "lower body_cfl, or choose order = 1 or 2");
  }
  if (options.max_rule) {
    throw root.error("scheme", "asks for max_rule, which bodies do not know", "remove max_rule");
  }
}

}  // namespace g27
