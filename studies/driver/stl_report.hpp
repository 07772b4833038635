#pragma once
/// What `g27 stl` says about a surface.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/repair.hpp"

namespace g27 {

struct StlReport {
  std::string source;           ///< "cube.stl: binary, 12 facets in 1 solid"
  std::string unit_name = "m";  ///< of the lengths in the text
  double unit = 1;              ///< [m]
  bool unit_assumed = false;
  std::vector<std::string> remarks;
  TriangleSurface surface;
  Diagnosis diagnosis;
  std::vector<int> origin;                        ///< [triangles] numbers to name them by
  std::optional<double> density;                  ///< [kg/m^3]
  std::optional<double> cell;                     ///< [m]
  std::vector<SurfaceFinding> found;              ///< before the repair
  std::vector<RepairStep> repaired;               ///< empty unless asked for
  std::optional<double> volume_before_remeshing;  ///< [m^3]
  std::vector<std::string> written;               ///< files
};

std::string to_text(StlReport const& report);
/// SI; triangles counted from 0.
nlohmann::ordered_json to_json(StlReport const& report);

}  // namespace g27
