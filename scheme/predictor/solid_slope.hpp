#pragma once
/// The slope of one field of a solid towards the foot of its characteristic: the paper's monotonicity switch per
/// family, and the parabolic predictor. A, B, C are the field's differences across the three intervals between the four
/// cells around the face, over their lengths. The face value is (upwind cell) +- (h - s)/2 slope, s = |lambda| dt, with
/// h the cell's width; lengths as solid_cells.hpp has them, h = 1 on a mesh of equal cells.
#include "riemann/base/lane.hpp"
#include "scheme/predictor/graded_share.hpp"
#include "scheme/predictor/solid_cells.hpp"
#include "scheme/step/gas_options.hpp"

namespace g27 {

namespace solid_slope {
inline constexpr double round_off = 1e-12;       ///< differences below this share of the field's scale do not switch
inline constexpr double curvature_ratio = 1.15;  ///< of a smooth extremum's two curvatures
inline constexpr double speed_low = -0.05, speed_high = 0.25;  ///< clip of the swept length's relative correction
inline constexpr double least_share = 1e-3;  ///< of the cell width, in the universal bounds of the contact's fields
/// Bound over the jump on the face where material yields. With 2 it rings behind a plastic shock and unloads, and the
/// states that it releases to are off by 0.2 % on every grid (study solid-lagrange); smooth loading stays below 1.25.
inline constexpr double yielding = 1.25;
inline constexpr double slow = 0.05;  ///< swept share below which those bounds are as of the other families
}  // namespace solid_slope

/// `kind` is the same for all faces of a run: a branch costs nothing, another copy of the loop half a minute.
template <Predictor predictor>
struct SolidSlope {
  static constexpr bool first_order = predictor == Predictor::godunov;
  static constexpr bool third_order = predictor == Predictor::parabolic;
  Switch kind = Switch::off;
  bool two_way = false;  ///< the graded switch acts beside a slope that is much steeper as well

  /// One switch for all families, from the normal stress.
  [[nodiscard]] G27_INLINE bool one_switch() const noexcept {
    return predictor == Predictor::linear && kind == Switch::literal;
  }

  /// Whether both parabolas of the normal stress are monotone between the two centres.
  template <Lane V>
  G27_INLINE static Mask<V> monotone(V A, V B, V C) noexcept {
    return ((B + A) * B >= 0.0 && (3.0 * B - A) * B >= 0.0 && (B + C) * B >= 0.0 && (3.0 * B - C) * B >= 0.0) ||
           B == 0.0;
  }

  /// in  s: swept length; forward: the characteristic comes from the left cell; scale of the field; exempt: smooth
  ///     extrema are left alone, as they are not where material yields; contact: the field rides with the velocity
  /// out slope; switched set to 1 where it was bounded
  template <bool contact, class Cells, Lane V>
  G27_INLINE V slope(Cells const& cells, V A, V B, V C, V s, Mask<V> forward, V scale, Mask<V> exempt,
                     V& switched) const noexcept {
    V const zero(0.0);
    if constexpr (first_order) return zero;
    V const D = select(forward, A, C);
    V wanted = B, bounded;
    if constexpr (third_order) {
      wanted = B + cells.far_weight(forward, s) * (D - B);
      if (kind == Switch::off) return wanted;
      V const size = abs(B), sign = select(B < 0.0, V(-1.0), V(1.0)), up = wanted * sign, d = D * sign;
      V bound = min(4.0 * d, V(2.0 * size));
      if constexpr (contact) {  // of riding cells s = 0
        V const from = s + solid_slope::least_share, to = max(1.0 - s, solid_slope::least_share);
        V const each = 1.0 / (from * to);
        V const universal = min(V(min(V(2.0 * to * each), 8.0) * d), V(min(V(2.0 * from * each), 8.0) * size));
        bound = select(s < solid_slope::slow, bound, universal);
      }
      bound = select(exempt, bound, min(bound, min(V(2.0 * d), V(solid_slope::yielding * size))));
      bounded = max(zero, min(up, bound)) * sign;
    } else if (kind == Switch::graded) {
      V const product = D * B;
      bounded = two_way ? V(two_way_share(D, B) * B)
                        : select(2.0 * product >= B * B, B, select(product > 0.0, V(2.0 * D), zero));
    } else if (kind == Switch::binary) {
      Mask<V> const both =
          (3.0 * A - B) * B >= 0.0 && (3.0 * B - A) * B >= 0.0 && (3.0 * C - B) * B >= 0.0 && (3.0 * B - C) * B >= 0.0;
      bounded = select(both, B, zero);
    } else {
      return B;
    }
    Mask<V> const acts = bounded != wanted;
    if (!any(acts)) return wanted;
    V const k1 = cells.curvature(V(B - A), 0), k2 = cells.curvature(V(C - B), 1);
    Mask<V> const smooth = (exempt && k1 * (solid_slope::curvature_ratio * k2 - k1) >= 0.0 &&
                            k2 * (solid_slope::curvature_ratio * k1 - k2) >= 0.0) ||
                           max(abs(A), max(abs(B), abs(C))) <= solid_slope::round_off * scale;
    switched = select(acts && !smooth, V(1.0), switched);
    return select(smooth, wanted, bounded);
  }

  /// |lambda| dt/h; beyond second order less half of the speed's change along the path. `change` = lambda(b) -
  /// lambda(a).
  template <Lane V>
  G27_INLINE static V swept(V lambda, V change, double nu) noexcept {
    V const s = abs(lambda) * nu;
    if constexpr (!third_order) return s;
    V const D = (2.0 / 3.0 * nu) * change;
    return s * (1.0 - max(V(solid_slope::speed_low), min(V(solid_slope::speed_high), D)));
  }
};

}  // namespace g27
