#include "studies/driver/document.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <array>
#include <charconv>
#include <fstream>
#include <sstream>

#include "studies/driver/input_error.hpp"

namespace g27 {
namespace {

Node convert(toml::node const& from) {
  Node node;
  node.line = static_cast<int>(from.source().begin.line);
  node.column = static_cast<int>(from.source().begin.column);
  if (auto const* table = from.as_table()) {
    Node::Table entries;
    for (auto const& [key, value] : *table) {
      Node child = convert(value);
      if (key.source().begin.line > 0) {
        child.line = static_cast<int>(key.source().begin.line);
        child.column = static_cast<int>(key.source().begin.column);
      }
      entries.push_back({std::string(key.str()), std::move(child)});
    }
    node.value = std::move(entries);
  } else if (auto const* array = from.as_array()) {
    Node::Array entries;
    for (auto const& value : *array) {
      entries.push_back(convert(value));
    }
    node.value = std::move(entries);
  } else if (auto const* text = from.as_string()) {
    node.value = text->get();
  } else if (auto const* integer = from.as_integer()) {
    node.value = static_cast<long>(integer->get());
  } else if (auto const* number = from.as_floating_point()) {
    node.value = number->get();
  } else if (auto const* flag = from.as_boolean()) {
    node.value = flag->get();
  } else {
    std::ostringstream date;
    from.visit([&](auto const& value) { date << value; });
    node.value = date.str();
  }
  return node;
}

/// Entry `key` of a table or array, made when absent in a table.
Node* descend(Node& node, std::string const& key) {
  if (auto* table = std::get_if<Node::Table>(&node.value)) {
    for (auto& entry : *table) {
      if (entry.key == key) {
        return &entry.node;
      }
    }
    table->push_back({key, Node{Node::Table{}}});
    return &table->back().node;
  }
  if (auto* array = std::get_if<Node::Array>(&node.value)) {
    std::size_t index = 0;
    auto const [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (error == std::errc{} && end == key.data() + key.size() && index < array->size()) {
      return &(*array)[index];
    }
  }
  return nullptr;
}

}  // namespace

Node const* Node::find(std::string const& key) const noexcept {
  if (auto const* table = std::get_if<Table>(&value)) {
    for (auto const& entry : *table) {
      if (entry.key == key) {
        return &entry.node;
      }
    }
  }
  return nullptr;
}

Node::Array const* Node::list(std::string const& key) const noexcept {
  Node const* entry = find(key);
  return entry != nullptr ? std::get_if<Array>(&entry->value) : nullptr;
}

std::string Node::type_name() const {
  constexpr char const* names[] = {"a boolean", "a number", "a number", "text", "a list", "a table"};
  return names[value.index()];
}

Document parse_document(std::string const& text, std::string const& file) {
  try {
    return {file, text, convert(toml::parse(text, file))};
  } catch (toml::parse_error const& error) {
    auto const at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}", file, at.line, at.column), "syntax", std::string(error.description()),
                     "correct the TOML there (text needs quotes, every [table] and key appears once)");
  }
}

Document read_document(std::filesystem::path const& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || std::filesystem::is_directory(file) || !(text << in.rdbuf()) || text.str().empty()) {
    throw InputError(file.string(), "scene", "cannot be read or is empty", "check the path and its permissions");
  }
  return parse_document(text.str(), file.string());
}

void set_value(Document& document, std::string const& assignment) {
  auto const bad = [&](std::string const& what, std::string const& remedy) {
    return InputError("--set", assignment.substr(0, assignment.find('=')), what, remedy);
  };
  std::size_t const equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw bad("is not key=value", "write --set domain.cells=400");
  }
  std::string const key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  Node value;
  try {
    value = convert(*toml::parse("v = " + text).get("v"));
  } catch (toml::parse_error const&) {
    value.value = text;  // a bare word or `5 cm`
  }
  value.line = value.column = 0;
  Node* at = &document.root;
  for (std::size_t from = 0; from <= key.size();) {
    std::size_t const dot = std::min(key.find('.', from), key.size());
    std::string const part = key.substr(from, dot - from);
    at = part.empty() ? nullptr : descend(*at, part);
    if (at == nullptr) {
      throw bad(fmt::format("no table or list entry '{}' in the scene", part),
                "name a key of the scene, as in the file");
    }
    from = dot + 1;
  }
  *at = std::move(value);
  // of two keys that say the same a scene has one: the new one replaces the other
  static std::array<std::array<char const*, 3>, 4> constexpr rivals{{{"domain", "cells", "cell"},
                                                                     {"domain", "cell", "cells"},
                                                                     {"scheme", "order", "name"},
                                                                     {"scheme", "name", "order"}}};
  for (auto const& [owner, given, other] : rivals) {
    if (key != fmt::format("{}.{}", owner, given)) continue;
    Node* const table = descend(document.root, owner);
    if (auto* entries = table != nullptr ? std::get_if<Node::Table>(&table->value) : nullptr) {
      std::erase_if(*entries, [&, name = other](NodeEntry const& e) { return e.key == name; });
    }
  }
}

}  // namespace g27
