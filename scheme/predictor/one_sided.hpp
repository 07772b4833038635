#pragma once
/// Extrapolation to the end of a row from the cells on one side of it: what an outgoing characteristic brings there.
#include "scheme/predictor/graded_share.hpp"
#include "scheme/predictor/solid_cells.hpp"
#include "scheme/step/gas_options.hpp"

namespace g27 {

/// A field at the face, averaged over the length s that its characteristic sweeps. F0, F1, F2 lie in the three cells
/// away from the face, which are b, a, z of `cells`; s in units of L. Linear, or parabolic.
template <class Cells, Lane V>
G27_INLINE V one_sided(Predictor predictor, bool limited, Cells const& cells, V F0, V F1, V F2, V s) noexcept {
  V const d = cells.gradient(V(F0 - F1), 1), far = cells.gradient(V(F1 - F2), 0), zero(0.0);
  if (predictor == Predictor::godunov) return F0;
  Mask<V> const monotone = (3.0 * far - d) * d > 0.0 && (3.0 * d - far) * d > 0.0;
  V slope = d;
  if (predictor == Predictor::parabolic) {
    V const beyond = 2.0 * d - far, lin = beyond + cells.boundary_weight(s) * (d - beyond);
    V const sign = select(d < 0.0, V(-1.0), V(1.0));
    V const bounded = sign * max(zero, min(V(sign * lin), min(V(2.0 * abs(d)), V(4.0 * sign * far))));
    slope = limited ? select(monotone, lin, bounded) : lin;
  } else if (limited) {
    slope = graded_share(far, d) * d;
  }
  return F0 + 0.5 * cells.beyond(Mask<V>(false), s) * slope;
}

}  // namespace g27
