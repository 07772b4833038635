/// The faces of the solid scheme, of one instruction set and one predictor (G27_PREDICTOR, see isa.cmake).
#include "scheme/kernel/solid_face_loop.hpp"

namespace g27 {
namespace G27_ISA {

template <Predictor>
void solid_faces_of(SolidFaceArguments& g) noexcept;

template <>
void solid_faces_of<Predictor::G27_PREDICTOR>(SolidFaceArguments& g) noexcept {
  solid_faces<SolidSlope<Predictor::G27_PREDICTOR>, Simd>(g);
}

}  // namespace G27_ISA
}  // namespace g27
