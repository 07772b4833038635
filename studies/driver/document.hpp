#pragma once
/// A parsed TOML file as a plain tree, with the place of every value; keeps the parser's heavy header in one file.
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace g27 {

struct NodeEntry;

struct Node {
  using Array = std::vector<Node>;
  using Table = std::vector<NodeEntry>;
  std::variant<bool, long, double, std::string, Array, Table> value;
  int line = 0, column = 0;  ///< from 1; 0: set on the command line

  [[nodiscard]] Node const* find(std::string const& key) const noexcept;   ///< of a table; null when absent
  [[nodiscard]] Array const* list(std::string const& key) const noexcept;  ///< entry of a table; null when not a list
  [[nodiscard]] std::string type_name() const;                             ///< "a table", "text", ...
};

struct NodeEntry {
  std::string key;
  Node node;
};

struct Document {
  std::string file;  ///< as shown in messages
  std::string text;  ///< verbatim
  Node root;
};

/// Reads and parses; throws InputError when the file cannot be read or is not TOML.
Document read_document(std::filesystem::path const& file);
/// Parses `text`; `file` is the name for messages.
Document parse_document(std::string const& text, std::string const& file);
/// `dotted.key=value`, the value in TOML (a bare word is text, `key.2` is the third entry of an array); throws
/// InputError.
void set_value(Document& document, std::string const& assignment);

}  // namespace g27
