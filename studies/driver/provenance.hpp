#pragma once
/// Where a result comes from: the build and the run that made it.
#include <string>

#include "studies/driver/table.hpp"

namespace g27 {

struct BuildFacts {
  std::string version, commit, compiler, build_type, flags;
  std::string sources;     ///< digest of the sources that determine a run's numbers
  std::string source_dir;  ///< where scenes and figure scripts are found
};

/// Of this program; written by CMake at build time.
BuildFacts build_facts();

/// Facts of this build and machine, in order: version, commit, compiler, build_type, flags, sources, instruction_set,
/// threads, date (UTC). Free of host and user names.
std::vector<std::pair<std::string, std::string>> provenance(int threads);

}  // namespace g27
