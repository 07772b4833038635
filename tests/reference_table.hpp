#pragma once
/// Reads a table of tests/reference: '#' lines are notes, then a header line, then numbers separated by commas.
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace g27 {

struct ReferenceTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  [[nodiscard]] std::vector<double> column(std::string const& name) const {
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (names[j] != name) continue;
      std::vector<double> out;
      for (auto const& row : rows) out.push_back(row.at(j));
      return out;
    }
    throw std::runtime_error("no column " + name);
  }
};

inline std::vector<std::string> split_line(std::string const& line) {
  std::vector<std::string> out;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) out.push_back(cell);
  return out;
}

/// `names`: the columns of a table whose only header is its "#" line.
inline ReferenceTable read_reference(std::string const& file, std::vector<std::string> names = {}) {
  std::string const path = std::string(G27_SOURCE_DIR) + "/tests/reference/" + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  ReferenceTable table{.names = std::move(names), .rows = {}};
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (table.names.empty()) {
      table.names = split_line(line);
      continue;
    }
    std::vector<double> row;
    for (auto const& cell : split_line(line)) row.push_back(std::stod(cell));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace g27
