# One binary for every x86-64: a kernel file is compiled once per instruction set, each copy in a namespace of its own
# (G27_ISA), and selected at run time. Nothing but kernel files is compiled above the baseline.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(G27_ISAS x86_64 x86_64_v3 x86_64_v4)
  set(G27_FLAGS_x86_64 "")
  set(G27_FLAGS_x86_64_v3 -march=x86-64-v3)
  set(G27_FLAGS_x86_64_v4 -march=x86-64-v4 -mprefer-vector-width=512)
else()
  set(G27_ISAS baseline)
  set(G27_FLAGS_baseline "")
endif()

function(g27_isa_kernels target)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
  file(GLOB kernels CONFIGURE_DEPENDS ${ARGN})
  foreach(isa ${G27_ISAS})
    add_library(g27_kernel_${isa} OBJECT ${kernels})
    target_link_libraries(g27_kernel_${isa} PRIVATE g27_options)
    target_compile_definitions(g27_kernel_${isa} PRIVATE G27_ISA=${isa})
    # GCC 12 warns about its own AVX-512 intrinsics (GCC bug 105593).
    target_compile_options(g27_kernel_${isa} PRIVATE ${G27_FLAGS_${isa}} -fno-exceptions -Wno-uninitialized
                                                     -Wno-maybe-uninitialized)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:g27_kernel_${isa}>)
    list(APPEND calls "G27_FOR_ISA(${isa})")
  endforeach()
  string(REPLACE ";" " " calls "${calls}")
  target_compile_definitions(${target} PRIVATE "G27_FOR_EACH_ISA=${calls}")
endfunction()
