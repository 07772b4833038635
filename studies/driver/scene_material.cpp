/// [material.NAME]: the gas's equation of state, and the solids.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "riemann/eos/factory.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

bool is_solid(Node const& material) { return material.find("strength") != nullptr; }

/// Every `material = "..."` must name the gas.
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
        throw root.error(
            key, fmt::format("material '{}' is not defined as a gas", text != nullptr ? *text : used->type_name()),
            fmt::format("use '{}'", name));
      }
    }
  }
}

/// [material.NAME] eos, opened with all of its keys.
Section open_eos(Section const& material, std::string const& example) {
  auto const* table = std::get_if<Node::Table>(&material.need("eos", example).value);
  std::vector<std::string> every_key{"type"};
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    every_key.push_back((*table)[i].key);
  }
  return material.table("eos", every_key);
}

/// `given`: parameters that the scene does not write here, with their values.
std::map<std::string, double> read_parameters(Section const& any, std::string const& law,
                                              std::map<std::string, double> const& given) {
  std::vector<std::string> keys{"type"};
  auto const parameters = eos_parameters(law);
  for (auto const& parameter : parameters) {
    if (!given.contains(parameter.name)) {
      keys.push_back(parameter.name);
    }
  }
  Section const section = any.reopened(keys);
  std::map<std::string, double> values = given;
  for (auto const& parameter : parameters) {
    if (given.contains(parameter.name)) {
      continue;
    }
    auto const unit = parse_unit(parameter.unit == "1" ? "%" : parameter.unit).value_or(Quantity{});
    Dimension const dimension{parameter.what, parameter.unit, unit.exponents};
    std::string const unit_text = parameter.unit == "1" ? "" : fmt::format(" {}", parameter.unit);
    std::string const example = fmt::format("{}{}", parameter.default_value, unit_text);
    Node const& node = section.need(parameter.name, fmt::format("\"{}\"", example));
    double const value = section.quantity_of(node, parameter.name, {dimension.name, example, dimension.exponents});
    if (value > parameter.highest || value < parameter.lowest ||
        (value == parameter.lowest && !parameter.lowest_included)) {
      throw section.error(parameter.name, fmt::format("{} is out of range", value),
                          fmt::format("choose it in {}{}, {}]{}", parameter.lowest_included ? '[' : '(',
                                      parameter.lowest, parameter.highest, unit_text));
    }
    values[parameter.name] = value;
  }
  return values;
}

AnyEos make_law(Section const& any, std::string const& law, std::map<std::string, double> const& values) {
  try {
    return make_eos(law, values);
  } catch (std::invalid_argument const& flaw) {
    throw any.error("", flaw.what(), "correct the parameters");
  }
}

constexpr char const* gas_example = "{ type = \"ideal\", gamma = 1.4 }";
constexpr char const* solid_example = "{ type = \"bulk-modulus\", K = \"175 GPa\" }";

AnySolidEos read_solid_eos(Section const& material, double density) {
  Section const any = open_eos(material, solid_example);
  std::string const law = any.text("type");
  (void)index_of_choice(any, "type", law, {BulkModulus::name, MieGruneisen::name, StiffenedGas::name});
  if (law == BulkModulus::name) {
    return BulkModulus{.rho0 = density, .K0 = any.reopened({"type", "K"}).positive("K", dimension::pressure)};
  }
  if (law == MieGruneisen::name) {
    return std::get<MieGruneisen>(make_law(any, law, read_parameters(any, law, {{"rho0", density}})));
  }
  return std::get<StiffenedGas>(make_law(any, law, read_parameters(any, law, {})));
}

/// Equation of state and strength, which a rigid material does not have.
void read_strength(Section const& material, Solid& solid) {
  constexpr char const* example = "{ type = \"elastic\", shear = \"80 GPa\" }";
  auto const* table = std::get_if<Node::Table>(&material.need("strength", example).value);
  std::vector<std::string> every_key{"type"};
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    every_key.push_back((*table)[i].key);
  }
  Section const any = material.table("strength", every_key);
  std::size_t const type = index_of_choice(any, "type", any.text("type"), {"elastic", "von-mises", "rigid"});
  solid.rigid = type == 2;
  if (solid.rigid) {
    constexpr char const* remedy = "remove it, or choose strength.type elastic or von-mises";
    for (std::string const& key : every_key) {
      if (key != "type") throw any.error(key, "is nothing that a rigid body has", remedy);
    }
    if (material.has("eos")) throw material.error("eos", "is nothing that a rigid body has", remedy);
    return;
  }
  AnySolid& out = solid.law;
  out.eos = read_solid_eos(material, solid.density);
  bool const plastic = type == 1;
  Section const section = any.reopened(plastic ? std::vector<std::string>{"type", "shear", "yield", "hardening"}
                                               : std::vector<std::string>{"type", "shear"});
  out.mu = section.positive("shear", dimension::pressure);
  if (plastic) {
    out.Y0 = section.positive("yield", dimension::pressure);
    out.H = section.quantity("hardening", dimension::pressure, 0.0);
    if (out.H < 0) {
      throw section.error("hardening", "is negative", "give 0 or more");
    }
  }
}

}  // namespace

AnyEos read_eos(Section const& root) {
  Node const& materials = root.need("material", "{ gas = { eos = { type = \"ideal\", gamma = 1.4 } } }");
  auto const* table = std::get_if<Node::Table>(&materials.value);
  std::vector<std::string> names, gases, solids;
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    names.push_back((*table)[i].key);
    (is_solid((*table)[i].node) ? solids : gases).push_back(names.back());
  }
  if (gases.size() != 1) {
    throw root.error("material",
                     table == nullptr ? std::string("is not a table")
                                      : fmt::format("holds {} materials without strength", gases.size()),
                     "write one [material.NAME] with the gas's eos");
  }
  if (!solids.empty() && !root.has("body")) {
    throw root.error("material", fmt::format("'{}' has strength, but there is no [[body]]", solids[0]),
                     "add a [[body]] of it, or remove it");
  }
  std::string const& name = gases[0];
  check_material_names(root, name);
  Section const material = root.table("material", names).table(name, {"eos"});
  Section const any = open_eos(material, gas_example);
  std::string const law = any.text("type");
  (void)index_of_choice(any, "type", law, eos_names());
  return make_law(any, law, read_parameters(any, law, {}));
}

Solid read_solid(Section const& root, Section const& body) {
  std::string const name = body.text("material");
  auto const* table = std::get_if<Node::Table>(&root.need("material", "{ ... }").value);
  std::vector<std::string> names, solids;
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    names.push_back((*table)[i].key);
    if (is_solid((*table)[i].node)) {
      solids.push_back(names.back());
    }
  }
  if (std::find(names.begin(), names.end(), name) != names.end() &&
      std::find(solids.begin(), solids.end(), name) == solids.end()) {
    throw body.error("material", fmt::format("'{}' has no strength", name),
                     fmt::format("add strength = {{ type = \"elastic\", shear = \"80 GPa\" }} to [material.{}]", name));
  }
  if (solids.empty()) {
    throw body.error("material", fmt::format("'{}' is not defined", name),
                     fmt::format("add [material.{}] with density, eos and strength", name));
  }
  (void)index_of_choice(body, "material", name, solids);
  Section const material = root.table("material", names).table(name, {"density", "eos", "strength"});
  Solid out;
  out.density = material.positive("density", dimension::density);
  read_strength(material, out);
  return out;
}

SolidPoint solid_at_rest(Solid const& solid, double pressure) {
  SolidPoint s{.rho = solid.density, .u = {}, .p = pressure, .e = 0, .S = {}, .ep = 0};
  if (auto const* law = std::get_if<BulkModulus>(&solid.law.eos)) {
    s.rho = law->rho0 * (1 + pressure / law->K0);
  }
  s.e = std::visit([&](auto const& eos) { return eos.energy(s.rho, s.p); }, solid.law.eos);
  return s;
}

}  // namespace g27
