# One binary for every x86-64: a kernel file is compiled once per instruction set, each copy in a namespace of its
# own (G27_ISA), and selected at run time. Nothing but kernel files is compiled above the baseline.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(G27_ISAS x86_64 x86_64_v3 x86_64_v4 CACHE STRING "instruction sets that the kernels are compiled for")
  set(G27_FLAGS_x86_64 "")
  set(G27_FLAGS_x86_64_v3 -march=x86-64-v3)
  set(G27_FLAGS_x86_64_v4 -march=x86-64-v4 -mprefer-vector-width=512)
else()
  set(G27_ISAS baseline)
  set(G27_FLAGS_baseline "")
endif()

# The laws are read off the registry, so that a new one is compiled by its line there.
file(STRINGS ${PROJECT_SOURCE_DIR}/riemann/eos/registry.hpp G27_EOS_LINE REGEX "EosList = TypeList<")
string(REGEX REPLACE ".*TypeList<([^>]*)>.*" "\\1" G27_EOS_NAMES "${G27_EOS_LINE}")
string(REPLACE ", " ";" G27_EOS_NAMES "${G27_EOS_NAMES}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/riemann/eos/registry.hpp)

function(g27_kernel_object target name isa)
  add_library(${name} OBJECT ${ARGV3})
  target_link_libraries(${name} PRIVATE g27_options)
  target_compile_definitions(${name} PRIVATE G27_ISA=${isa} ${ARGV4})
  # GCC 12 warns about its own AVX-512 intrinsics (GCC bug 105593).
  target_compile_options(${name} PRIVATE ${G27_FLAGS_${isa}} -fno-exceptions -Wno-uninitialized -Wno-maybe-uninitialized)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    # Fully inlined vector code takes the sanitizers' compilers half an hour a file; everything around it is checked.
    target_compile_options(${name} PRIVATE -fno-sanitize=all -O2)
  endif()
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${name}>)
endfunction()

# Compiles the kernels for every instruction set, eos_kernel.cpp once per law as well, into the library `target`.
function(g27_isa_kernels target)
  foreach(isa ${G27_ISAS})
    foreach(kernel predict solid solid_eos)
      g27_kernel_object(${target} g27_${kernel}_${isa} ${isa} ${PROJECT_SOURCE_DIR}/scheme/kernel/${kernel}_kernel.cpp)
    endforeach()
    foreach(predictor godunov linear parabolic)
      g27_kernel_object(${target} g27_solid_${predictor}_${isa} ${isa}
                        ${PROJECT_SOURCE_DIR}/scheme/kernel/solid_face_kernel.cpp G27_PREDICTOR=${predictor})
    endforeach()
    foreach(eos ${G27_EOS_NAMES})
      g27_kernel_object(${target} g27_${eos}_${isa} ${isa} ${PROJECT_SOURCE_DIR}/scheme/kernel/eos_kernel.cpp
                        G27_EOS=${eos})
    endforeach()
    list(APPEND calls "G27_FOR_ISA(${isa})")
  endforeach()
  string(REPLACE ";" " " calls "${calls}")
  target_compile_definitions(${target} PRIVATE "G27_FOR_EACH_ISA=${calls}")
endfunction()

# Those of the interpolation between overset grids, into the library `target`.
function(g27_fit_kernels target)
  foreach(isa ${G27_ISAS})
    g27_kernel_object(${target} g27_fit_${isa} ${isa} ${PROJECT_SOURCE_DIR}/fsi/overset/fit_kernel.cpp)
    list(APPEND calls "G27_FOR_ISA(${isa})")
  endforeach()
  string(REPLACE ";" " " calls "${calls}")
  target_compile_definitions(${target} PRIVATE "G27_FOR_EACH_ISA=${calls}")
endfunction()
