/// [material.NAME]: the equation of state.
#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "riemann/eos/factory.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

/// Every `material = "..."` must name the one that is defined.
void check_material_names(Section const& root, std::string const& name) {
  for (char const* key : {"ambient", "initial", "region", "charge"}) {
    Node const* node = root.node().find(key);
    if (node == nullptr) {
      continue;
    }
    auto const* list = std::get_if<Node::Array>(&node->value);
    for (Node const& entry : list != nullptr ? *list : Node::Array{*node}) {
      Node const* used = entry.find("material");
      auto const* text = used != nullptr ? std::get_if<std::string>(&used->value) : nullptr;
      if (used != nullptr && (text == nullptr || *text != name)) {
        throw root.error(key, fmt::format("material '{}' is not defined", text != nullptr ? *text : used->type_name()),
                         fmt::format("use '{}'", name));
      }
    }
  }
}

}  // namespace

AnyEos read_eos(Section const& root) {
  Node const& materials = root.need("material", "{ gas = { eos = { type = \"ideal\", gamma = 1.4 } } }");
  auto const* table = std::get_if<Node::Table>(&materials.value);
  if (table == nullptr || table->size() != 1) {
    throw root.error(
        "material", table == nullptr ? std::string("is not a table") : fmt::format("holds {} materials", table->size()),
        "write one [material.NAME] with its eos");
  }
  std::string const& name = table->front().key;
  check_material_names(root, name);
  Section const material = root.table("material", {name}).table(name, {"eos"});
  auto const* eos_table = std::get_if<Node::Table>(&material.need("eos", "{ type = \"ideal\", gamma = 1.4 }").value);
  std::vector<std::string> every_key{"type"};
  for (std::size_t i = 0; eos_table != nullptr && i < eos_table->size(); ++i) {
    every_key.push_back((*eos_table)[i].key);
  }
  Section const any = material.table("eos", every_key);
  std::string const law = any.text("type");
  (void)index_of_choice(any, "type", law, eos_names());
  std::vector<std::string> keys{"type"};
  auto const parameters = eos_parameters(law);
  for (auto const& parameter : parameters) {
    keys.push_back(parameter.name);
  }
  Section const section = any.reopened(keys);
  std::map<std::string, double> values;
  for (auto const& parameter : parameters) {
    auto const unit = parse_unit(parameter.unit == "1" ? "%" : parameter.unit).value_or(Quantity{});
    Dimension const dimension{parameter.what, parameter.unit, unit.exponents};
    std::string const example = fmt::format("{} {}", parameter.default_value, parameter.unit);
    Node const& node = section.need(parameter.name, fmt::format("\"{}\"", example));
    double const value = section.quantity_of(node, parameter.name, {dimension.name, example, dimension.exponents});
    if (value > parameter.highest || value < parameter.lowest ||
        (value == parameter.lowest && !parameter.lowest_included)) {
      throw section.error(parameter.name, fmt::format("{} is out of range", value),
                          fmt::format("choose it in {}{}, {}] {}", parameter.lowest_included ? '[' : '(',
                                      parameter.lowest, parameter.highest, parameter.unit));
    }
    values[parameter.name] = value;
  }
  try {
    return make_eos(law, values);
  } catch (std::invalid_argument const& flaw) {
    throw any.error("", flaw.what(), "correct the parameters");
  }
}

}  // namespace g27
