/// The solid scheme of one instruction set, but for the faces and for what depends on the equation of state.
#include "scheme/kernel/solid_boundary_loop.hpp"
#include "scheme/kernel/solid_correct_loop.hpp"
#include "scheme/kernel/solid_transverse_loop.hpp"

namespace g27 {
namespace G27_ISA {

extern SolidLoops const solid_loops;
constexpr SolidLoops solid_loops{.width = width<Simd>,
                                 .boundary = &solid_boundary<Simd>,
                                 .transverse = &solid_transverse<Simd>,
                                 .correct = &solid_correct<Simd>};

}  // namespace G27_ISA
}  // namespace g27
