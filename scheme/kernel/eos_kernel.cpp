/// What depends on the equation of state, of one instruction set and one law (G27_EOS, see isa.cmake).
#include "scheme/kernel/average_loop.hpp"
#include "scheme/kernel/carbuncle_loop.hpp"
#include "scheme/kernel/grid_loops.hpp"
#include "scheme/kernel/solve_loop.hpp"
#include "scheme/kernel/update_loop.hpp"

namespace g27 {
namespace G27_ISA {

template <class E>
EosKernels const& eos_kernels() noexcept;

template <class E>
std::array<double, 2> energy_line(void const* law) noexcept {
  if constexpr (requires(E const& eos) { eos.energy_line(); }) {
    return static_cast<E const*>(law)->energy_line();
  } else {
    return {0.0, 0.0};
  }
}

template <>
EosKernels const& eos_kernels<G27_EOS>() noexcept {
  // a law without a solver of its own takes the general one: the same function, compiled once
  constexpr RiemannSolver fast = HasFastSolver<G27_EOS, Simd> ? RiemannSolver::fast : RiemannSolver::exact;
  static constexpr EosKernels table{
      .solve = {&solve<fast, G27_EOS, Simd>, &solve<RiemannSolver::exact, G27_EOS, Simd>,
                &solve<RiemannSolver::hllc, G27_EOS, Simd>},
      .primitive = &primitive<G27_EOS, Simd>,
      .update = &update<G27_EOS, Simd>,
      .average = &average<G27_EOS, Simd>,
      .energy_line = &energy_line<G27_EOS>,
      .grid = {.primitive = {&grid_primitive<2, G27_EOS, Simd>, &grid_primitive<3, G27_EOS, Simd>},
               .average = {&grid_average<2, G27_EOS, Simd>, &grid_average<3, G27_EOS, Simd>},
               .finish = {&grid_finish<2, G27_EOS, Simd>, &grid_finish<3, G27_EOS, Simd>},
               .hlle = {&hlle<2, G27_EOS, Simd>, &hlle<3, G27_EOS, Simd>}}};
  return table;
}

}  // namespace G27_ISA
}  // namespace g27
