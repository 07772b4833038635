#pragma once
/// Characteristic families of a face whose material yields and is loaded: the tangent modulus
///   M_ep = M - kap Sn Sn^T,  kap = 3 mu/(q^2 (1 + H/(3 mu))),  Sn = (S11, S12, S13), q^2 = 3/2 S:S.
/// Along a particle's path S then changes by a further -kap S (Sn.g), and ep by kap q (Sn.g)/(3 mu).
#include "riemann/solid/eigensystem.hpp"
#include "riemann/strength/von_mises.hpp"

namespace g27 {

template <Lane V>
struct TangentWaves {
  FrozenSolid<V> at;
  V lambda[3], z[3], inv_z[3], inv_lambda[3];
  V kap, q;
  V P[3][3], R[3][3];  ///< P M_ep = diag(lambda) P, R = P^-1

  /// The symmetric part by one sweep of Jacobi's rotations, the two nearest values last; then twice the first-order
  /// correction by what is left off the diagonal, of the sweep and of M's antisymmetric part, O(|S|/gap): P M P^-1 is
  /// diagonal to 6e-8 mu at worst, on the yield surface of metals (a second sweep changes nothing). Where two values
  /// meet their vectors stay those of the symmetric part.
  /// Out of line: long.
  [[gnu::noinline]] TangentWaves(FrozenSolid<V> const& f, Strength const& strength) noexcept : at(f) {
    V const* S = f.S;
    double const mu = f.mu;
    V const q2 = max(mises_squared(S), 1e-300);
    q = sqrt(q2), kap = (3.0 * mu / (1.0 + strength.H / (3.0 * mu))) / q2;
    V const Sn[3] = {S[0], S[3], S[4]};
    V const c12 = -(1.0 + f.f) * S[3], c13 = -(1.0 + f.f) * S[4];
    V M[3][3] = {{f.longitudinal(), c12, c13},
                 {V(0.0), mu + 0.5 * (S[0] - S[1]), -0.5 * S[5]},
                 {V(0.0), -0.5 * S[5], mu + 0.5 * (S[0] - S[2])}};
    unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
      unrolled<3>([&](auto j) G27_INLINE_LAMBDA { M[i][j] -= kap * Sn[i] * Sn[j]; });
    });
    V const zero(0.0), one(1.0);
    V A[3][3] = {{M[0][0], M[0][1] - 0.5 * c12, M[0][2] - 0.5 * c13}, {zero, M[1][1], M[1][2]}, {zero, zero, M[2][2]}};
    unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
      unrolled<3>([&](auto j) G27_INLINE_LAMBDA { P[i][j] = i == j ? one : zero; });
    });
    auto const rotate = [&](auto i, auto j, auto k) G27_INLINE_LAMBDA {  // i < j, k the third
      V& off = A[i][j];
      V& ik = A[i < k ? i : k][i < k ? k : i];
      V& jk = A[j < k ? j : k][j < k ? k : j];
      V const D = 0.5 * (A[i][i] - A[j][j]), d = sqrt(V(D * D + off * off)), sum = select(D < 0.0, D - d, D + d);
      V const t = off / select(abs(sum) > 1e-300, sum, V(1.0)), c = 1.0 / sqrt(V(1.0 + t * t)), s = t * c;
      A[i][i] += t * off, A[j][j] -= t * off, off = zero;
      V const x = ik, y = jk;
      ik = c * x + s * y, jk = c * y - s * x;
      unrolled<3>([&](auto n) G27_INLINE_LAMBDA {
        V const a = P[i][n], b = P[j][n];
        P[i][n] = c * a + s * b, P[j][n] = c * b - s * a;
      });
    };
    constexpr std::integral_constant<int, 0> i0;
    constexpr std::integral_constant<int, 1> i1;
    constexpr std::integral_constant<int, 2> i2;
    rotate(i0, i1, i2), rotate(i0, i2, i1), rotate(i1, i2, i0);
    V const soft = 1e-3 * mu;
#pragma GCC unroll 1
    for (int pass = 0; pass < 2; ++pass) {
      invert();
      V T[3][3], E[3][3];
      unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
        V row[3];
        unrolled<3>([&](auto j)
                        G27_INLINE_LAMBDA { row[j] = P[i][0] * M[0][j] + P[i][1] * M[1][j] + P[i][2] * M[2][j]; });
        unrolled<3>([&](auto j)
                        G27_INLINE_LAMBDA { T[i][j] = row[0] * R[0][j] + row[1] * R[1][j] + row[2] * R[2][j]; });
      });
      unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
        unrolled<3>([&](auto j) G27_INLINE_LAMBDA {
          if constexpr (i != j) {
            V const gap = T[i][i] - T[j][j];
            E[i][j] = T[i][j] * gap / (gap * gap + soft * soft);
          }
        });
        lambda[i] = T[i][i];
      });
      V old[3][3];
      unrolled<3>([&](auto i)
                      G27_INLINE_LAMBDA { unrolled<3>([&](auto j) G27_INLINE_LAMBDA { old[i][j] = P[i][j]; }); });
      unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
        unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
          if constexpr (i != k) {
            lambda[i] += E[i][k] * T[k][i];
            unrolled<3>([&](auto j) G27_INLINE_LAMBDA { P[i][j] += E[i][k] * old[k][j]; });
          }
        });
      });
    }
    invert();
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      lambda[k] = max(lambda[k], 1e-8 * mu);
      V const square = f.rho * lambda[k], inv = 1.0 / square;
      z[k] = sqrt(square), inv_z[k] = inv * z[k], inv_lambda[k] = inv * f.rho;
    });
  }

  [[nodiscard]] G27_INLINE Triple<V> project(Triple<V> const& v) const noexcept { return times(P, v); }
  [[nodiscard]] G27_INLINE Triple<V> unproject(Triple<V> const& r) const noexcept { return times(R, r); }
  [[nodiscard]] G27_INLINE PathChange<V> path(Triple<V> const& r) const noexcept {
    Triple<V> const g = unproject({{r[0] * inv_lambda[0], r[1] * inv_lambda[1], r[2] * inv_lambda[2]}});
    V const* S = at.S;
    V const stretch = (2.0 / 3.0 * at.mu) * g[0], turn_2 = S[3] * g[1], turn_3 = S[4] * g[2];
    V const flow = kap * (S[0] * g[0] + turn_2 + turn_3);
    return {g[0],
            ((S[0] - at.p) * g[0] + turn_2 + turn_3) / at.rho,
            turn_2 - stretch - flow * S[1],
            turn_3 - stretch - flow * S[2],
            0.5 * (S[4] * g[1] + S[3] * g[2]) - flow * S[5],
            flow * q * (1.0 / (3.0 * at.mu))};
  }
  static constexpr bool plastic = true;

 private:
  G27_INLINE static Triple<V> times(V const (&A)[3][3], Triple<V> const& v) noexcept {
    return {{A[0][0] * v[0] + A[0][1] * v[1] + A[0][2] * v[2], A[1][0] * v[0] + A[1][1] * v[1] + A[1][2] * v[2],
             A[2][0] * v[0] + A[2][1] * v[1] + A[2][2] * v[2]}};
  }
  G27_INLINE void invert() noexcept {
    V cof[3][3];
    unrolled<3>([&](auto i) G27_INLINE_LAMBDA {
      unrolled<3>([&](auto j) G27_INLINE_LAMBDA {
        constexpr int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        cof[i][j] = P[a][c] * P[b][d] - P[a][d] * P[b][c];
      });
    });
    V const inv = 1.0 / (P[0][0] * cof[0][0] + P[0][1] * cof[0][1] + P[0][2] * cof[0][2]);
    unrolled<3>([&](auto i)
                    G27_INLINE_LAMBDA { unrolled<3>([&](auto j) G27_INLINE_LAMBDA { R[i][j] = cof[j][i] * inv; }); });
  }
};

}  // namespace g27
