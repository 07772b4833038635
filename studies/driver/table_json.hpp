#pragma once
/// Tables as JSON and as HDF5.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "studies/driver/table.hpp"

namespace g27 {

/// {title, columns: [{name, unit}], rows: [{name: value}], facts: {name: value}}
nlohmann::ordered_json to_json(Table const& table);

/// One group a table and one dataset a column (`units` attribute), facts as attributes, and /provenance; atomically.
void write_tables(std::filesystem::path const& file, std::vector<Table> const& tables);

/// Writes OUT/NAME.csv.
void write_csv(std::filesystem::path const& folder, Table const& table);

}  // namespace g27
