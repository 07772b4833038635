/// Compiled once per instruction set (isa.cmake): every template is instantiated for this set's vector type.
#include "scheme/kernel/predict_loop.hpp"
#include "scheme/kernel/solve_loop.hpp"
#include "scheme/kernel/update_loop.hpp"

namespace g27 {
namespace G27_ISA {

#define G27_NAME_OF(isa) #isa
#define G27_NAME(isa) G27_NAME_OF(isa)

template <class List>
struct TablesOf;
template <class... E>
struct TablesOf<std::variant<E...>> {
  static constexpr std::array<std::array<GasKernels::Solve, 3>, sizeof...(E)> solve{
      {{&g27::solve<RiemannSolver::fast, E, Simd>, &g27::solve<RiemannSolver::exact, E, Simd>,
        &g27::solve<RiemannSolver::hllc, E, Simd>}...}};
  static constexpr std::array<GasKernels::Primitive, sizeof...(E)> primitive{{&g27::primitive<E, Simd>...}};
  static constexpr std::array<GasKernels::Update, sizeof...(E)> update{{&g27::update<E, Simd>...}};
};

template <class P, bool cell_feet = false>
inline constexpr std::array<GasKernels::Predict, 2> both_meshes{&predict<P, false, Simd, cell_feet>,
                                                                &predict<P, true, Simd, cell_feet>};

static constexpr GasKernels table{
    .isa = G27_NAME(G27_ISA),
    .width = width<Simd>,
    .predict = {{both_meshes<GodunovPredictor>,
                 both_meshes<LinearPredictor<Switch::off>>,
                 both_meshes<LinearPredictor<Switch::literal>>,
                 both_meshes<LinearPredictor<Switch::binary>>,
                 both_meshes<LinearPredictor<Switch::graded>>,
                 both_meshes<LinearPredictor<Switch::off, false, true>>,
                 both_meshes<LinearPredictor<Switch::off, true>, true>,
                 both_meshes<ParabolicPredictor<false>>,
                 both_meshes<ParabolicPredictor<true>>,
                 {&predict_muscl<false, Simd>, &predict_muscl<true, Simd>}}},
    .solve = TablesOf<AnyEos>::solve,
    .primitive = TablesOf<AnyEos>::primitive,
    .update = TablesOf<AnyEos>::update,
};

GasKernels const& gas_kernel_table() noexcept { return table; }

}  // namespace G27_ISA
}  // namespace g27
