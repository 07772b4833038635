#pragma once
/// What is told of a scene's results: tables, and a summary as JSON.
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/scene_run.hpp"
#include "studies/driver/table.hpp"

namespace g27 {

struct RunReport {
  std::vector<Table> tables;  ///< those with rows
  std::string summary;        ///< JSON
};

/// Writes OUT/summary.json and a CSV file a table. Throws OutputError.
RunReport write_report(Scene const& scene, SceneResult const& result, std::filesystem::path const& out);

}  // namespace g27
