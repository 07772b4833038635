#pragma once
/// The monotonicity switch of the linear predictor, from the two parabolas through (i-1, i, i+1) and (i, i+1, i+2),
/// OG section "On monotonicity for modified scheme". A, B, C are the slopes across the three intervals, in units of
/// difference / (sum of widths); the result phi is the share of the second-order state, 1 where the data are smooth.
#include "scheme/predictor/stencil.hpp"
#include "scheme/step/gas_options.hpp"

namespace g27 {

/// Jumps below round_off * scale and smooth extrema below smooth * scale do not switch.
inline constexpr double switch_round_off = 1e-8;
inline constexpr double switch_smooth = 0.01;
inline constexpr double switch_curvature_ratio = 3.0;

/// phi of one field. `forward`: the characteristic of the field enters from the left cell. `scale` in units of the
/// field. The graded form reads the upwind side only; the binary and the literal one both sides.
template <Switch kind, Lane V>
G27_INLINE V switch_value(Stencil<V> const& s, V A, V B, V C, Mask<V> forward, V scale) noexcept {
  V const one(1.0), zero(0.0);
  if constexpr (kind == Switch::off) {
    return one;
  } else {
    V const h_sum = s.h_a + s.h_b;
    V const size = max(abs(A), max(abs(B), abs(C))) * h_sum;
    V const k1 = (B - A) * s.triple_a, k2 = (C - B) * s.triple_b;
    if constexpr (kind == Switch::literal) {
      // OG: first order where a parabola has its vertex between the two centres. With slopes sa, sb over the spacings
      // da, db: (sa db + sb da) ((da + 2 db) sb - db sa) < 0.
      V const da = 1.0 / s.pair_za, db = h_sum, dc = 1.0 / s.pair_by;
      Mask<V> const left = (A * db + B * da) * ((da + 2.0 * db) * B - db * A) < 0.0;
      Mask<V> const right = (C * db + B * dc) * ((dc + 2.0 * db) * B - db * C) < 0.0;
      return select(left || right, zero, one);
    } else {
      V phi;
      if constexpr (kind == Switch::graded) {
        V const D = select(forward, A, C), twice = 2.0 * D * B, square = B * B;
        phi = max(zero, min(one, twice / max(square, V(1e-300))));
      } else {
        // a parabola that is not monotone on its own three points
        V const da = 1.0 / s.pair_za, db = h_sum, dc = 1.0 / s.pair_by;
        Mask<V> const left = ((db + 2.0 * da) * A - da * B) * B < 0.0 || ((da + 2.0 * db) * B - db * A) * B < 0.0;
        Mask<V> const right = ((db + 2.0 * dc) * C - dc * B) * B < 0.0 || ((dc + 2.0 * db) * B - db * C) * B < 0.0;
        phi = select(left || right, zero, one);
      }
      Mask<V> const smooth_extremum = size <= switch_smooth * scale && k1 * k2 > 0.0 &&
                                      abs(k1) <= switch_curvature_ratio * abs(k2) &&
                                      abs(k2) <= switch_curvature_ratio * abs(k1);
      return select(size <= switch_round_off * scale || smooth_extremum, one, phi);
    }
  }
}

}  // namespace g27
