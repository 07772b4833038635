#include "fsi/overset/fit_kernels.hpp"

#include <string_view>

#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {

// The kernel objects define these in the namespace of their instruction set.
#define G27_FOR_ISA(isa)             \
  namespace isa {                    \
  extern FitKernels const fit_loops; \
  }
G27_FOR_EACH_ISA
#undef G27_FOR_ISA

FitKernels const& fit_kernels() noexcept {
  static FitKernels const* const kernels = [] {
    FitKernels const* found = nullptr;
    std::string_view const wanted = gas_kernels().isa;
#define G27_FOR_ISA(name) \
  if (wanted == #name) found = &name::fit_loops;
    G27_FOR_EACH_ISA
#undef G27_FOR_ISA
    return found;
  }();
  return *kernels;
}

}  // namespace g27
