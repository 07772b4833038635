/// The predictors of one instruction set. The ablations run the general mesh only: they are studied, not raced.
#include "scheme/kernel/predict_loop.hpp"

namespace g27 {
namespace G27_ISA {

using Row = GasKernels::PredictRow;
template <class P>
inline constexpr Row both_meshes{&predict<P, false, false, Simd>, &predict<P, true, false, Simd>};
template <class P, bool cell_feet = false>
inline constexpr Row general_mesh{&predict<P, false, cell_feet, Simd>, &predict<P, false, cell_feet, Simd>};

extern GasKernels::Predictors const predictors;
constexpr GasKernels::Predictors predictors{width<Simd>,
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
                                            &count<Simd>};

}  // namespace G27_ISA
}  // namespace g27
