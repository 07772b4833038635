/// The predictors of one instruction set. The ablations run the general mesh only: they are studied, not raced.
#include "scheme/kernel/carbuncle_loop.hpp"
#include "scheme/kernel/grid_loops.hpp"
#include "scheme/kernel/grid_muscl_loop.hpp"
#include "scheme/kernel/predict_loop.hpp"
#include "scheme/kernel/tangential_loop.hpp"
#include "scheme/kernel/transverse_loop.hpp"

namespace g27 {
namespace G27_ISA {

using Row = GasKernels::PredictRow;
template <class P>
inline constexpr Row both_meshes{&predict<P, false, false, Simd>, &predict<P, true, false, Simd>};
template <class P, bool cell_feet = false>
inline constexpr Row general_mesh{&predict<P, false, cell_feet, Simd>, &predict<P, false, cell_feet, Simd>};

extern GasKernels::Predictors const predictors;
constexpr GasKernels::Predictors predictors{
    width<Simd>,
    {{both_meshes<GodunovPredictor>,
      both_meshes<LinearPredictor<Switch::off>>,
      general_mesh<LinearPredictor<Switch::literal>>,
      general_mesh<LinearPredictor<Switch::binary>>,
      both_meshes<LinearPredictor<Switch::graded>>,
      general_mesh<LinearPredictor<Switch::off, false, true>>,
      general_mesh<LinearPredictor<Switch::off, true>, true>,
      both_meshes<ParabolicPredictor<false>>,
      both_meshes<ParabolicPredictor<true>>,
      {&predict_muscl<false, Simd>, &predict_muscl<true, Simd>}}},
    &count<Simd>,
    {.transverse = {&transverse<2, Simd>, &transverse<3, Simd>},
     .shock_flags = {&shock_flags<2, Simd>, &shock_flags<3, Simd>},
     .update = {&grid_update<2, Simd>, &grid_update<3, Simd>},
     .muscl = {&grid_muscl<2, Simd>, &grid_muscl<3, Simd>},
     .upwind = &upwind<Simd>,
     .tangential = {
         &tangential<GodunovTangential, Simd>, &tangential<LinearTangential<Switch::off>, Simd>,
         &tangential<LinearTangential<Switch::literal>, Simd>, &tangential<LinearTangential<Switch::binary>, Simd>,
         &tangential<LinearTangential<Switch::graded>, Simd>, &tangential<LinearTangential<Switch::off>, Simd>, nullptr,
         &tangential<ParabolicTangential<false>, Simd>, &tangential<ParabolicTangential<true>, Simd>, nullptr,
         nullptr}}};

}  // namespace G27_ISA
}  // namespace g27
