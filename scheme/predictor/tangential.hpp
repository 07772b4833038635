#pragma once
/// Velocities along a face: each is constant along the contact's characteristic, so its two predicted sides lie where
/// that one starts, with a switch of its own.
#include "scheme/predictor/monotonicity.hpp"
#include "scheme/predictor/parabolic.hpp"

namespace g27 {

/// What is common to the fields of a face. `l`: signed length that the contact's characteristic sweeps in the step.
template <Lane V>
struct ContactPath {
  Stencil<V> mesh;  ///< widths and mesh factors alone are set
  V K, rho;         ///< sums over the two cells: the scale of the switch is their sound speed
  V speed, l;
  G27_INLINE V sound() const noexcept { return sqrt(V(K / rho)); }
};

template <Lane V>
struct TwoSides {
  V left, right;
};

struct GodunovTangential {
  static constexpr bool needs_pressure = false;
  template <Lane V>
  G27_INLINE static TwoSides<V> sides(ContactPath<V> const&, V, V a, V b, V) noexcept {
    return {a, b};
  }
  template <Lane V>
  G27_INLINE static V swept(V, V dt, V, V v) noexcept {
    return v * dt;
  }
};

template <Switch kind>
struct LinearTangential {
  static constexpr bool needs_pressure = kind == Switch::literal;
  template <Lane V>
  G27_INLINE static TwoSides<V> sides(ContactPath<V> const& f, V z, V a, V b, V y) noexcept {
    Stencil<V> const& s = f.mesh;
    V const d = b - a;
    V const A = (a - z) * s.pair_za, B = d * s.pair_ab, C = (y - b) * s.pair_by;
    V phi(1.0);
    if constexpr (kind != Switch::off) {
      // where the upwind slope is at least half of that across the face, the graded switch does not act
      V const D = select(f.speed >= 0.0, A, C);
      if (kind != Switch::graded || !all(2.0 * D * B >= B * B)) {
        phi = switch_value<kind>(s, A, B, C, f.speed >= 0.0, f.sound());
      }
    }
    TwoSides<V> t = at_foot(f, a, d, b, phi);
    if constexpr (kind == Switch::graded) {
      if (Mask<V> const stands = f.speed == 0.0 && B != 0.0; any(stands)) {
        t.right = select(stands, at_foot(f, a, d, b, switch_value<kind>(s, A, B, C, f.speed > 0.0, f.sound())).right,
                         t.right);
      }
    }
    return t;
  }
  template <Lane V>
  G27_INLINE static TwoSides<V> at_foot(ContactPath<V> const& f, V a, V d, V b, V phi) noexcept {
    Stencil<V> const& s = f.mesh;
    V const foot = max(-0.5 * s.h_a, min(0.5 * s.h_b, V(-0.5 * f.l)));
    V const x = s.h_a * s.pair_ab + foot * (2.0 * s.pair_ab);
    return {a + phi * x * d, b - phi * (1.0 - x) * d};
  }
  template <Lane V>
  G27_INLINE static V swept(V, V dt, V, V v) noexcept {
    return v * dt;
  }
};

template <bool limited>
struct ParabolicTangential {
  static constexpr bool needs_pressure = false;
  template <Lane V>
  G27_INLINE static TwoSides<V> sides(ContactPath<V> const& f, V z, V a, V b, V y) noexcept {
    Stencil<V> const& s = f.mesh;
    V const A = (a - z) * s.pair_za, B = (b - a) * s.pair_ab, C = (y - b) * s.pair_by, zero(0.0);
    Mask<V> const forward = f.l >= 0.0;
    V switched(0.0);
    V const c = f.sound();
    V const hg = ParabolicPredictor<limited>::template field<false>(s, A, B, C, f.l, forward, c, c, zero, zero, {},
                                                                    switched, Mask<V>(false));
    V const far = select(forward, C, A);
    V g = select(far * B > 0.0, select(abs(far) < abs(B), far, B), zero);
    if constexpr (!limited) g = B;
    TwoSides<V> t{a + select(forward, hg, (s.h_a - f.l) * g), b - select(forward, (s.h_b + f.l) * g, hg)};
    if (Mask<V> const stands = f.l == 0.0 && B != 0.0; any(stands)) {
      V const from_right = ParabolicPredictor<limited>::template field<false>(s, A, B, C, f.l, Mask<V>(false), c, c,
                                                                              zero, zero, {}, switched, Mask<V>(false));
      t.right = select(stands, b - from_right, t.right);
    }
    return t;
  }
  /// With half of the speed's change along the path, as for the contact's density.
  template <Lane V>
  G27_INLINE static V swept(V d_u, V dt, V pair, V v) noexcept {
    V const change = V(4.0 / 3.0) * dt * d_u * pair;
    return v * dt * (1.0 - max(V(parabolic::speed_low), min(V(parabolic::speed_high), change)));
  }
};

}  // namespace g27
