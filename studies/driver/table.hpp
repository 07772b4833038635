#pragma once
/// A named table of results: printed aligned, written as CSV, as HDF5 and as JSON.
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace g27 {

using Value = std::variant<std::string, double, long>;

struct Column {
  std::string name;
  std::string unit;  ///< "1" for pure numbers
};

struct Table {
  std::string name, title;
  std::vector<Column> columns;
  std::vector<std::vector<Value>> rows;  ///< each as long as `columns`
  /// facts that belong to the whole table (yardsticks of a benchmark, settings of a study)
  std::vector<std::pair<std::string, Value>> facts;
};

/// Columns aligned for a terminal; numbers in %.4g.
std::string to_text(Table const& table);
/// Header line, then one line a row; full precision; strings quoted where needed.
std::string to_csv(Table const& table);

}  // namespace g27
