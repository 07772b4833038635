#pragma once
/// Characteristic families of a solid across a face, OG (4.1)-(4.12): u_t = s_x/rho, s_t = M u_x for the velocity u and
/// the traction s = (S11 - p, S12, S13), with
///   M = [[rho a^2, -(1+f) S12, -(1+f) S13], [0, mu + (S11-S22)/2, -S23/2], [0, -S23/2, mu + (S11-S33)/2]],
///   rho a^2 = rho c^2 + 4/3 mu - f S11.
/// P diagonalises M from the left: P M = diag(lambda) P. The families are frozen at one state, the face's mean.
#include "riemann/state/solid.hpp"

namespace g27 {

/// What M and the changes along a particle's path are made of, at the state where they are frozen.
template <Lane V>
struct FrozenSolid {
  V rho, K, f, p, S[6];  ///< K = rho c^2, f = (1/rho) dp/de
  double mu;

  /// rho a^2 [Pa].
  [[nodiscard]] G27_INLINE V longitudinal() const noexcept { return K + (4.0 / 3.0 * mu) - f * S[0]; }
};

/// Changes along a particle's path where its velocity gradient integrates to g: density over rho is -g1.
template <Lane V>
struct PathChange {
  V g1, e, S22, S33, S23, ep;
};

/// An elastic face. M is block triangular: the shear block is rotated to its axes by an angle of at most 45 degrees
/// (none where S23 = 0), and l_P = (1, m) takes the coupling of P and S with it. No singularity at equal speeds; a
/// family of zero modulus, as in a fluid, has inv_z = inv_lambda = 0.
template <Lane V>
struct ElasticWaves {
  FrozenSolid<V> at;
  V lambda[3], z[3], inv_z[3], inv_lambda[3];  ///< rho c_k^2 [Pa], rho c_k [Pa s/m], and their reciprocals
  V cosine, sine, m[2];

  G27_INLINE explicit ElasticWaves(FrozenSolid<V> const& q) noexcept : at(q) {
    V const B22 = q.mu + 0.5 * (q.S[0] - q.S[1]), B33 = q.mu + 0.5 * (q.S[0] - q.S[2]), B23 = -0.5 * q.S[5];
    cosine = V(1.0), sine = V(0.0), lambda[1] = B22, lambda[2] = B33;
    if (any(B23 != 0.0)) {
      V const D = 0.5 * (B22 - B33), d = sqrt(V(D * D + B23 * B23)), sum = select(D < 0.0, D - d, D + d);
      V const t = select(abs(sum) > 1e-300, B23 / select(sum == 0.0, V(1.0), sum), V(0.0));
      cosine = 1.0 / sqrt(V(1.0 + t * t)), sine = t * cosine;
      lambda[1] += t * B23, lambda[2] -= t * B23;
    }
    lambda[0] = q.longitudinal();
    V const M12 = -(1.0 + q.f) * q.S[3], M13 = -(1.0 + q.f) * q.S[4], least = 1e-12 * lambda[0];
    m[0] = (cosine * M12 + sine * M13) / (lambda[0] - lambda[1]);
    m[1] = (cosine * M13 - sine * M12) / (lambda[0] - lambda[2]);
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      Mask<V> const there = lambda[k] > least;
      V const safe = select(there, lambda[k], V(1.0)), zero(0.0), square = q.rho * safe, inv = 1.0 / square;
      V const root = sqrt(square);
      lambda[k] = select(there, lambda[k], zero);
      z[k] = select(there, root, zero), inv_z[k] = select(there, V(inv * root), zero);
      inv_lambda[k] = select(there, V(inv * q.rho), zero);
    });
  }

  /// P v
  [[nodiscard]] G27_INLINE Triple<V> project(Triple<V> const& v) const noexcept {
    V const s = cosine * v[1] + sine * v[2], t = cosine * v[2] - sine * v[1];
    return {{v[0] + m[0] * s + m[1] * t, s, t}};
  }
  /// P^-1 r
  [[nodiscard]] G27_INLINE Triple<V> unproject(Triple<V> const& r) const noexcept {
    return {{r[0] - m[0] * r[1] - m[1] * r[2], cosine * r[1] - sine * r[2], sine * r[1] + cosine * r[2]}};
  }
  /// Changes where the traction's amplitudes change by r: g = M^-1 ds, then OG (4.6)-(4.11) with u_,1 = g.
  [[nodiscard]] G27_INLINE PathChange<V> path(Triple<V> const& r) const noexcept {
    Triple<V> const g = unproject({{r[0] * inv_lambda[0], r[1] * inv_lambda[1], r[2] * inv_lambda[2]}});
    V const* S = at.S;
    V const stretch = (2.0 / 3.0 * at.mu) * g[0], turn_2 = S[3] * g[1], turn_3 = S[4] * g[2];
    return {g[0],
            ((S[0] - at.p) * g[0] + turn_2 + turn_3) / at.rho,
            turn_2 - stretch,
            turn_3 - stretch,
            0.5 * (S[4] * g[1] + S[3] * g[2]),
            V(0.0)};
  }
  static constexpr bool plastic = false;
};

}  // namespace g27
