# Writes build_facts.cpp (only when it changed): version, commit, compiler and flags of this build.
find_package(Git QUIET)
set(COMMIT "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --dirty --abbrev=12
                  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[#include "studies/driver/provenance.hpp"
namespace g27 {
BuildFacts build_facts() {
  return {.version = "@VERSION@", .commit = "@COMMIT@", .compiler = "@COMPILER@", .build_type = "@BUILD_TYPE@",
          .flags = "@FLAGS@", .source_dir = "@SOURCE@"};
}
}  // namespace g27
]])
