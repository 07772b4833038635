# Tables by glob: a file `verification/cases/sod_case.cpp` defines `Case sod_case()`; the generated table lists them all.
# To add a case, an oracle, a study or a benchmark is to add one file.
function(g27_table target table header type function glob)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${glob})
  list(FILTER files EXCLUDE REGEX "/driver/")
  set(declarations "")
  set(entries "")
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    string(APPEND declarations "${type} ${name}();\n")
    string(APPEND entries "      ${name}(),\n")
  endforeach()
  set(out ${PROJECT_BINARY_DIR}/tables/${table}.cpp)
  file(CONFIGURE OUTPUT ${out} @ONLY CONTENT [[// Generated: one entry for each file that matches @glob@.
#include <algorithm>

#include "@header@"

namespace g27 {
@declarations@
std::vector<@type@> @function@() {
  std::vector<@type@> table{
@entries@  };
  std::sort(table.begin(), table.end(), [](auto const& a, auto const& b) { return a.name < b.name; });
  return table;
}
}  // namespace g27
]])
  target_sources(${target} PRIVATE ${out})
endfunction()

# Build facts for /provenance and `g27 --version`: written at build time, so that the commit is never stale.
function(g27_provenance target)
  set(out ${PROJECT_BINARY_DIR}/tables/build_facts.cpp)
  add_custom_target(
    g27_build_facts
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${out} -DVERSION=${PROJECT_VERSION}
            "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
            "-DFLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}}" -P
            ${PROJECT_SOURCE_DIR}/studies/driver/build_facts.cmake
    BYPRODUCTS ${out}
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
  set_source_files_properties(${out} TARGET_DIRECTORY ${target} PROPERTIES GENERATED ON)
  add_dependencies(${target} g27_build_facts)
endfunction()
