#pragma once
/// Smooth plane waves that cross the grid at an angle, in a box in which they are periodic.
///
/// The box of Gardiner and Stone (J. Comput. Phys. 227 (2008) 4123): the wavelength is 1 m in the direction
/// (1, 2)/sqrt(5) of a box sqrt(5) x sqrt(5)/2, or (1, 2, 2)/3 of a box 3 x 3/2 x 3/2; cells are cubic for even numbers
/// of them.
#include <functional>
#include <string>

#include "verification/cases/grid_problem.hpp"
#include "verification/cases/media.hpp"

namespace g27 {

struct ObliqueBox {
  Vec3 normal, upper;
};
ObliqueBox oblique_box(int dimensions);
/// A normal without two equal components, and more cells a wavelength: (12, 15, 16)/25 of a box 25/12 x 5/3 x 25/16;
/// cells are cubic for multiples of 20 of them.
ObliqueBox uneven_box();

/// Sine of velocity of amplitude 1e-5 c over one period of the carrying characteristic, the exact simple wave. The
/// medium moves; in the frame of its mean flow it is at rest.
Case acoustic_case(std::string const& name, int dimensions);

}  // namespace g27
