#pragma once
/// What every gas Riemann solver returns.
#include "riemann/state/gas.hpp"

namespace g27 {

/// Solution of a Riemann problem in the face frame (the caller subtracts the face speed from both velocities).
template <Lane V = double>
struct FaceSolution {
  GasState<V> face;   ///< state at x/t = 0
  V p_star, u_star;   ///< contact; in a vacuum: p of the vacuum, and the mean of the two fronts' speeds
  Mask<V> converged;  ///< false: the iteration limit was met; the caller must not use the state
};

}  // namespace g27
