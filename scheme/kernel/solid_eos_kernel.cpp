/// What depends on a solid's equation of state, of one instruction set, for all the laws: it compiles in no time.
#include "riemann/solid/material.hpp"
#include "scheme/kernel/solid_eos_loops.hpp"

namespace g27 {
namespace G27_ISA {

extern std::array<SolidEosKernels, std::variant_size_v<AnySolidEos>> const solid_eos_kernels;
template <class... E>
constexpr std::array<SolidEosKernels, sizeof...(E)> tables(std::variant<E...> const*) {
  return {SolidEosKernels{&solid_primitive<E, Simd>, &solid_finish<E, Simd>}...};
}
constexpr std::array<SolidEosKernels, std::variant_size_v<AnySolidEos>> solid_eos_kernels =
    tables(static_cast<AnySolidEos const*>(nullptr));

}  // namespace G27_ISA
}  // namespace g27
