#pragma once
/// Godunov's predictor: the Riemann problem between the cell averages.
#include "scheme/predictor/stencil.hpp"

namespace g27 {

struct GodunovPredictor {
  static constexpr bool third_order = false;

  template <Lane V>
  G27_INLINE static FacePrediction<V> predict(Stencil<V> const& s, double /*exponent*/) noexcept {
    GasState<V> const l = state(s.a), r = state(s.b);
    AcousticStar<V> const star = acoustic_star(l, r, 0.5 * (s.a.K + s.b.K), min(s.a.K, s.b.K), s.w);
    return {.star = star.state,
            .change = {},
            .left = l,
            .right = r,
            .weak = star.weak && Mask<V>(s.linear_star),
            .switched = V(0.0)};
  }
};

}  // namespace g27
