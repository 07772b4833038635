#include "studies/driver/section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/driver/nearest_key.hpp"

namespace g27 {
namespace {

/// "a length", "an energy"
std::string with_article(std::string_view name) {
  bool const vowel = !name.empty() && std::string_view("aeiou").find(name.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", name);
}

}  // namespace

void Reading::note_bare(std::string const& key, double value, Dimension const& dimension) {
  auto note = fmt::format("{} = {} ({}, {})", key, value, dimension.name, si_unit(dimension.exponents));
  if (std::find(bare_numbers.begin(), bare_numbers.end(), note) == bare_numbers.end()) {
    bare_numbers.push_back(std::move(note));
  }
}

Section::Section(Reading& reading, Node const& node, std::string path, std::vector<std::string> known)
    : reading_(&reading), node_(&node), path_(std::move(path)) {
  auto const* table = std::get_if<Node::Table>(&node.value);
  if (table == nullptr) {
    throw error_at(node, path_, fmt::format("is {}, not a table", node.type_name()),
                   fmt::format("give it entries: {}", fmt::join(known, ", ")));
  }
  for (auto const& entry : *table) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      throw error_at(entry.node, full(entry.key), "unknown key", suggestion(entry.key, known));
    }
  }
}

InputError Section::error_at(Node const& node, std::string const& key, std::string const& what,
                             std::string const& remedy) const {
  std::string const place = node.line > 0 ? fmt::format(":{}:{}", node.line, node.column) : "";
  return {reading_->file + place, key.empty() ? "scene" : key, what, remedy};
}

InputError Section::error(std::string const& key, std::string const& what, std::string const& remedy) const {
  Node const* at = node_->find(key);
  return error_at(at != nullptr ? *at : *node_, key.empty() ? path_ : full(key), what, remedy);
}

Node const& Section::need(std::string const& key, std::string const& example) const {
  Node const* found = node_->find(key);
  if (found == nullptr) {
    throw error(key, "is missing", fmt::format("add {} = {}", key, example));
  }
  return *found;
}

double Section::quantity_of(Node const& node, std::string const& key, Dimension const& dimension) const {
  std::string const kind = with_article(dimension.name);
  auto const fail = [&](std::string const& what) {
    return error_at(node, full(key), what, fmt::format("give {} such as \"{}\"", kind, dimension.example));
  };
  double value = 0;
  if (auto const* text = std::get_if<std::string>(&node.value)) {
    auto const parsed = parse_quantity(*text);
    if (!parsed) {
      throw fail(fmt::format("'{}' is not a number with a unit", *text));
    }
    if (parsed->has_unit && parsed->exponents != dimension.exponents) {
      throw fail(fmt::format("'{}' is not {} but has the dimension {}", *text, kind, si_unit(parsed->exponents)));
    }
    value = parsed->value;
    if (!parsed->has_unit && dimension.exponents != dimension::number.exponents) {
      reading_->note_bare(full(key), value, dimension);
    }
  } else if (std::holds_alternative<double>(node.value) || std::holds_alternative<long>(node.value)) {
    auto const* integer = std::get_if<long>(&node.value);
    value = integer != nullptr ? static_cast<double>(*integer) : std::get<double>(node.value);
    if (dimension.exponents != dimension::number.exponents) {
      reading_->note_bare(full(key), value, dimension);
    }
  } else {
    throw fail(fmt::format("is {}, not a number", node.type_name()));
  }
  if (!std::isfinite(value)) {
    throw fail("is not a finite number");
  }
  return value;
}

double Section::quantity(std::string const& key, Dimension const& dimension) const {
  return quantity_of(need(key, fmt::format("\"{}\"", dimension.example)), key, dimension);
}

double Section::quantity(std::string const& key, Dimension const& dimension, double fallback) const {
  Node const* found = node_->find(key);
  return found != nullptr ? quantity_of(*found, key, dimension) : fallback;
}

double Section::positive(std::string const& key, Dimension const& dimension) const {
  double const value = quantity(key, dimension);
  if (!(value > 0)) {
    throw error(key, fmt::format("{} {} is not positive", value, si_unit(dimension.exponents)),
                fmt::format("give a {} > 0 such as \"{}\"", dimension.name, dimension.example));
  }
  return value;
}

long Section::integer(std::string const& key, long least, long most) const {
  Node const& node = need(key, std::to_string(std::clamp(100L, least, most)));
  auto const* value = std::get_if<long>(&node.value);
  auto const remedy = fmt::format("give a whole number from {} to {}", least, most);
  if (value == nullptr) {
    throw error(key, fmt::format("is {}, not a whole number written without point and exponent", node.type_name()),
                remedy);
  }
  if (*value < least || *value > most) {
    throw error(key, fmt::format("{} is out of range", *value), remedy);
  }
  return *value;
}

std::array<int, 3> Section::counts(std::string const& key, std::size_t number, long least, long most) const {
  auto const* list = std::get_if<Node::Array>(&need(key, "[100, 100]").value);
  if (list == nullptr || list->size() != number) {
    throw error(key, list == nullptr ? "is not a list" : fmt::format("has {} entries", list->size()),
                fmt::format("give {} whole numbers, one an axis", number));
  }
  std::array<int, 3> out{1, 1, 1};
  for (std::size_t d = 0; d < number; ++d) {
    auto const* count = std::get_if<long>(&(*list)[d].value);
    if (count == nullptr || *count < least || *count > most) {
      throw error(key,
                  count == nullptr ? fmt::format("entry {} is not a whole number written without point and exponent", d)
                                   : fmt::format("{} is out of range", *count),
                  fmt::format("give whole numbers from {} to {}", least, most));
    }
    out[d] = static_cast<int>(*count);
  }
  return out;
}

bool Section::flag(std::string const& key, bool fallback) const {
  Node const* found = node_->find(key);
  if (found == nullptr) {
    return fallback;
  }
  if (auto const* value = std::get_if<bool>(&found->value)) {
    return *value;
  }
  auto const* word = std::get_if<std::string>(&found->value);
  if (word == nullptr || (*word != "on" && *word != "off")) {
    throw error(key, fmt::format("is {}, not true or false", found->type_name()), "give true or false (or on, off)");
  }
  return *word == "on";
}

std::string Section::text(std::string const& key) const {
  Node const& node = need(key, "\"...\"");
  auto const* value = std::get_if<std::string>(&node.value);
  if (value == nullptr) {
    throw error(key, fmt::format("is {}, not text", node.type_name()), "put it in quotes");
  }
  return *value;
}

std::string Section::text(std::string const& key, std::string const& fallback) const {
  return has(key) ? text(key) : fallback;
}

std::size_t index_of_choice(Section const& where, std::string const& key, std::string const& name,
                            std::vector<std::string> const& options) {
  auto const found = std::find(options.begin(), options.end(), name);
  if (found == options.end()) {
    std::string const near = nearest_key(name, options);
    throw where.error(key, fmt::format("unknown value '{}'", name),
                      near.empty() ? fmt::format("choose among: {}", fmt::join(options, ", "))
                                   : fmt::format("did you mean '{}'? (choices: {})", near, fmt::join(options, ", ")));
  }
  return static_cast<std::size_t>(found - options.begin());
}

std::size_t Section::choice(std::string const& key, std::vector<std::string> const& options,
                            std::size_t fallback) const {
  return has(key) ? index_of_choice(*this, key, text(key), options) : fallback;
}

std::vector<double> Section::quantities(std::string const& key, Dimension const& dimension) const {
  return quantities_of(need(key, fmt::format("[\"{}\"]", dimension.example)), key, dimension);
}

std::vector<double> Section::quantities_of(Node const& node, std::string const& key, Dimension const& dimension) const {
  auto const* list = std::get_if<Node::Array>(&node.value);
  if (list == nullptr) {
    throw error_at(node, full(key), fmt::format("is {}, not a list", node.type_name()),
                   fmt::format("write [\"{}\", ...]", dimension.example));
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < list->size(); ++i) {
    out.push_back(quantity_of((*list)[i], fmt::format("{}.{}", key, i), dimension));
  }
  return out;
}

std::array<double, 3> Section::point_of(Node const& node, std::string const& key, Dimension const& dimension,
                                        int dimensions) const {
  auto const values = quantities_of(node, key, dimension);
  if (static_cast<int>(values.size()) != dimensions) {
    throw error_at(node, full(key), fmt::format("has {} entries", values.size()),
                   fmt::format("give {}, one an axis", dimensions));
  }
  std::array<double, 3> out{0, 0, 0};
  std::copy(values.begin(), values.end(), out.begin());
  return out;
}

std::array<double, 3> Section::point(std::string const& key, Dimension const& dimension, int dimensions) const {
  return point_of(need(key, fmt::format("[\"{0}\", ...]", dimension.example)), key, dimension, dimensions);
}

std::vector<std::array<double, 3>> Section::points(std::string const& key, Dimension const& dimension,
                                                   int dimensions) const {
  std::vector<std::array<double, 3>> out;
  for (auto const& [name, node] : entries(key, fmt::format("[[\"{0}\", ...], ...]", dimension.example), "points")) {
    out.push_back(point_of(*node, name, dimension, dimensions));
  }
  return out;
}

std::array<double, 2> Section::interval_of(Node const& node, std::string const& key, Dimension const& dimension) const {
  auto const ends = quantities_of(node, key, dimension);
  if (ends.size() != 2) {
    throw error_at(node, full(key), fmt::format("has {} entries", ends.size()), "give two: [start, end]");
  }
  if (!(ends[0] < ends[1])) {
    throw error_at(node, full(key), "ends before it starts", "give [start, end] with start < end");
  }
  return {ends[0], ends[1]};
}

std::array<double, 2> Section::interval(std::string const& key, Dimension const& dimension) const {
  return interval_of(need(key, fmt::format("[\"0 m\", \"{}\"]", dimension.example)), key, dimension);
}

std::vector<std::array<double, 2>> Section::intervals(std::string const& key, Dimension const& dimension) const {
  std::vector<std::array<double, 2>> out;
  auto const example = fmt::format("[[\"0 m\", \"{0}\"], [\"0 m\", \"{0}\"]]", dimension.example);
  for (auto const& [name, node] : entries(key, example, "intervals")) {
    out.push_back(interval_of(*node, name, dimension));
  }
  return out;
}

std::vector<std::pair<std::string, Node const*>> Section::entries(std::string const& key, std::string const& example,
                                                                  std::string const& what) const {
  Node const& node = need(key, example);
  auto const* list = std::get_if<Node::Array>(&node.value);
  if (list == nullptr) {
    throw error(key, fmt::format("is {}, not a list of {}", node.type_name(), what), "write " + example);
  }
  std::vector<std::pair<std::string, Node const*>> out;
  for (std::size_t i = 0; i < list->size(); ++i) {
    out.emplace_back(fmt::format("{}.{}", key, i), &(*list)[i]);
  }
  return out;
}

Section Section::table(std::string const& key, std::vector<std::string> known) const {
  return {*reading_, need(key, "{ ... }"), full(key), std::move(known)};
}

std::vector<Section> Section::tables(std::string const& key, std::vector<std::string> const& known) const {
  std::vector<Section> out;
  Node const* found = node_->find(key);
  if (found == nullptr) {
    return out;
  }
  auto const* list = std::get_if<Node::Array>(&found->value);
  if (list == nullptr) {
    throw error(key, fmt::format("is {}, not a list of tables", found->type_name()),
                fmt::format("write it in double brackets: [[{}]]", full(key)));
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    out.emplace_back(*reading_, (*list)[i], fmt::format("{}.{}", full(key), i), known);
  }
  return out;
}

}  // namespace g27
