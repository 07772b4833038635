# Writes build_facts.cpp (only when it changed): version, commit, compiler and flags of this build.
find_package(Git QUIET)
set(COMMIT "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --dirty --abbrev=12
                  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
# What determines a run's numbers: commands and figures do not.
file(GLOB_RECURSE FILES RELATIVE ${SOURCE} ${SOURCE}/riemann/*.[ch]pp ${SOURCE}/scheme/*.[ch]pp ${SOURCE}/fsi/*.[ch]pp
     ${SOURCE}/studies/driver/*.[ch]pp)
list(FILTER FILES EXCLUDE REGEX "driver/(command|figure|python|scene_cache|run_report)")
set(DIGESTS "")
foreach(file ${FILES})
  file(SHA256 ${SOURCE}/${file} digest)
  string(APPEND DIGESTS "${file} ${digest}\n")
endforeach()
string(SHA256 SOURCES "${DIGESTS}")
string(SUBSTRING ${SOURCES} 0 12 SOURCES)
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[#include "studies/driver/provenance.hpp"
namespace g27 {
BuildFacts build_facts() {
  return {.version = "@VERSION@", .commit = "@COMMIT@", .compiler = "@COMPILER@", .build_type = "@BUILD_TYPE@",
          .flags = "@FLAGS@", .sources = "@SOURCES@", .source_dir = "@SOURCE@"};
}
}  // namespace g27
]])
