#include "scheme/kernel/solid_kernels.hpp"

#include <string_view>

#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {

// The kernel objects define these in the namespace of their instruction set.
#define G27_FOR_ISA(isa)                                                                        \
  namespace isa {                                                                               \
  extern SolidLoops const solid_loops;                                                          \
  template <Predictor>                                                                          \
  void solid_faces_of(SolidFaceArguments& g) noexcept;                                          \
  extern std::array<SolidEosKernels, std::variant_size_v<AnySolidEos>> const solid_eos_kernels; \
  }
G27_FOR_EACH_ISA
#undef G27_FOR_ISA

namespace {

SolidKernels find() noexcept {
  SolidKernels found{};
  std::string_view const wanted = gas_kernels().isa;
#define G27_FOR_ISA(name)                                                                               \
  if (wanted == #name) {                                                                                \
    found.isa = #name, found.loops = &name::solid_loops;                                                \
    found.faces = {&name::solid_faces_of<Predictor::godunov>, &name::solid_faces_of<Predictor::linear>, \
                   &name::solid_faces_of<Predictor::parabolic>};                                        \
    for (std::size_t k = 0; k < found.eos.size(); ++k) found.eos[k] = &name::solid_eos_kernels[k];      \
  }
  G27_FOR_EACH_ISA
#undef G27_FOR_ISA
  return found;
}

}  // namespace

SolidKernels const& solid_kernels() noexcept {
  static SolidKernels const kernels = find();
  return kernels;
}

}  // namespace g27
