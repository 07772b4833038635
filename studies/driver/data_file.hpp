#pragma once
/// Columns of numbers with units from a CSV file.
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/units.hpp"

namespace g27 {

struct ColumnRequest {
  std::string name;
  Dimension dimension;
};

/// Columns named `name [unit]` in the header line ("x [cm],density [g/cm3]"), in SI, in the order of `requests`.
/// Lines that start with # are comments. Throws InputError naming file, line and column.
std::vector<std::vector<double>> read_columns(std::filesystem::path const& file,
                                              std::vector<ColumnRequest> const& requests);

}  // namespace g27
