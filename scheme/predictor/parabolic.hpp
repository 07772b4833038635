#pragma once
/// The parabolic predictor: the two parabolas of the monotonicity switch become the interpolant, averaged over the
/// interval that each characteristic sweeps in a step. Third order on smooth flow, inside the paper's stencil.
///
/// On linear waves the swept averages alone are of third order. A nonlinear flow needs three things more, each of
/// second order and each taken where the data are smooth: the cell averages of u and p (average_loop.hpp), the
/// quadratic terms of the face state's mean over the step (quadratic, below), and fluxes averaged over the step
/// (solve_loop.hpp).
///
/// Fields: R+- = dp +- Z du, S = drho - dp/c^2. A, B, C are a field's differences over the sum of the two widths across
/// the three intervals. Of the upwind cell's parabola only its slope over the swept interval matters,
///   lin = B + (s + h_d)/H3 (D - B),  D = A or C upwind, s = |lambda| dt, h_d the downwind width, H3 = sum of three,
/// and the face value of the field is (upwind cell) + (h_u - s) lin. Bounds on lin make it monotone.
#include "scheme/predictor/stencil.hpp"

namespace g27 {

namespace parabolic {
inline constexpr double speed_low = -0.05, speed_high = 0.25;  ///< clip of the swept length's relative correction
inline constexpr double smooth_acoustic = 0.01, smooth_entropy = 0.003;  ///< amplitude of exempt smooth extrema
inline constexpr double compression = 0.2;        ///< curvature over slope from which a contact is steepened
inline constexpr double compression_jump = 0.05;  ///< its least density jump over the mean
inline constexpr double compression_sound = 0.3;  ///< its largest pressure slope over c^2 times the entropy slope
inline constexpr double shock_pressure = 1.0 / 1.4, shock_slowness = 0.2;  ///< slow strong shock: first order
inline constexpr double smooth_change = 0.05;  ///< largest jump over rho, K, c with which the flux is averaged
inline constexpr double round_off = 1e-8;      ///< a change below this share of the field's scale is not counted
inline constexpr double least_share = 1e-3;    ///< of the cell width, in the universal bounds
}  // namespace parabolic

template <bool limited>
struct ParabolicPredictor {
  static constexpr bool third_order = true;

  template <Lane V>
  G27_INLINE static FacePrediction<V> predict(Stencil<V> const& s, double exponent) noexcept {
    Cell<V> const &z = s.z, &a = s.a, &b = s.b, &y = s.y;
    V const zero(0.0), one(1.0);
    V const rho = 0.5 * (a.rho + b.rho), p = 0.5 * (a.p + b.p), K = 0.5 * (a.K + b.K), u = 0.5 * (a.u + b.u);
    V const inv = 1.0 / (rho * K), inv_rho = inv * K, inv_K = inv * rho;
    V const c2 = K * inv_rho, c = sqrt(c2), inv_c2 = inv_K * rho, Z = rho * c, inv_Z = inv_rho * c * inv_c2;
    V const v = u - s.w, h_sum = s.h_a + s.h_b;

    V const d_p = b.p - a.p, d_u = b.u - a.u;
    V const gp0 = (a.p - z.p) * s.pair_za, gp1 = d_p * s.pair_ab, gp2 = (y.p - b.p) * s.pair_by;
    V const gu0 = (a.u - z.u) * (Z * s.pair_za), gu1 = d_u * (Z * s.pair_ab), gu2 = (y.u - b.u) * (Z * s.pair_by);
    V const gr1 = (b.rho - a.rho) * s.pair_ab;
    V const gs0 = (a.rho - z.rho) * s.pair_za - gp0 * inv_c2, gs1 = gr1 - gp1 * inv_c2;
    V const gs2 = (y.rho - b.rho) * s.pair_by - gp2 * inv_c2;

    // speeds at the middle of the swept interval: u +- c less half of its change along the path,
    // c_x = (c/2)(K_x/K - rho_x/rho) since c^2 = K/rho for every EOS
    V const k = V(4.0 / 3.0) * s.dt;
    V const D_u = k * gu1 * inv_Z, D_c = (0.5 * k) * c * ((b.K - a.K) * s.pair_ab * inv_K - gr1 * inv_rho);
    auto const shrink = [&](V d) G27_INLINE_LAMBDA {
      return s.dt * (1.0 - max(V(parabolic::speed_low), min(V(parabolic::speed_high), d)));
    };
    V const l_p = (v + c) * shrink(D_u + D_c), l_m = (v - c) * shrink(D_u - D_c), l_0 = v * shrink(D_u);
    Mask<V> const fwd_p = l_p >= 0.0, fwd_m = l_m >= 0.0, fwd_0 = l_0 >= 0.0;

    V const keep = limited ? slow_shock(s, c) : one;
    V switched(0.0);
    V const gate = max(abs(gp0), max(abs(gp1), abs(gp2)));
    auto const acoustic = [&](V A, V B, V C, V l, Mask<V> forward) G27_INLINE_LAMBDA {
      return field<false>(s, A, B, C, l, forward, Z * c, rho, gate, c2, keep, switched);
    };
    V const Ap = gp0 + gu0, Bp = gp1 + gu1, Cp = gp2 + gu2, Am = gp0 - gu0, Bm = gp1 - gu1, Cm = gp2 - gu2;
    V const hg_p = acoustic(Ap, Bp, Cp, l_p, fwd_p), hg_m = acoustic(Am, Bm, Cm, l_m, fwd_m);
    V const hg_0 = field<true>(s, gs0, gs1, gs2, l_0, fwd_0, rho, rho, gate, c2, keep, switched);

    // the star state without a solver: deviations of the three fields from the mean of the two cells
    auto const deviation = [&](V hg, V B, Mask<V> forward) G27_INLINE_LAMBDA {
      V const e = hg - 0.5 * h_sum * B;
      return select(forward, e, -e);
    };
    V e_p = deviation(hg_p, Bp, fwd_p), e_m = deviation(hg_m, Bm, fwd_m), e_0 = deviation(hg_0, gs1, fwd_0);
    if (s.incremented) {
      // at a third of the path (the time mean of the rate along it), linear between the centres; or the upwind cell's
      auto const third = [&](V l, V in_a, V in_b) G27_INLINE_LAMBDA {
        if (s.own_increments) return select(l >= 0.0, in_a, in_b);
        V const share = (s.h_a - l * (2.0 / 3.0)) * s.pair_ab;
        return V(in_a + share * (in_b - in_a));
      };
      GasState<V> const &ia = s.inc_a, &ib = s.inc_b;
      e_p += third(l_p, ia.p + Z * ia.u, ib.p + Z * ib.u);
      e_m += third(l_m, ia.p - Z * ia.u, ib.p - Z * ib.u);
      e_0 += third(l_0, ia.rho - ia.p * inv_c2, ib.rho - ib.p * inv_c2);
    }
    V const x_s = 0.5 * (e_p + e_m);
    V const p_s = p + x_s, u_s = u + 0.5 * (e_p - e_m) * inv_Z, rho_s = rho + e_0 + x_s * inv_c2;
    V const K_min = min(a.K, b.K), rho_min = min(a.rho, b.rho);
    Mask<V> const allow(s.linear_star);
    Mask<V> weak = allow && abs(d_p) <= weak_pressure * K_min && abs(d_u) <= weak_velocity * c && rho_s > 0.2 * rho_min;
    FacePrediction<V> out{.star = {rho_s, u_s, p_s},
                          .change = {zero, zero, zero},
                          .left = state(a),
                          .right = state(b),
                          .weak = weak,
                          .switched = switched};
    // Over the step the face state runs through W +- W_t dt/sqrt(12) in the mean square: the flux is averaged between
    // the two (Gauss), or its second derivative would leave a second-order error.
    Mask<V> const smooth = weak && abs(b.rho - a.rho) <= parabolic::smooth_change * rho &&
                           abs(d_p) <= parabolic::smooth_change * K && abs(d_u) <= parabolic::smooth_change * c;
    if (any(smooth)) {
      Slopes<V> const x{.rho = 2.0 * gr1, .u = 2.0 * gu1 * inv_Z, .p = 2.0 * gp1, .K = 2.0 * (b.K - a.K) * s.pair_ab};
      GasState<V> rate{-(v * x.rho + rho * x.u), -(v * x.u + x.p * inv_rho), -(v * x.p + K * x.u)};
      V rate_K = -(v * x.K + 0.5 * (a.dK_dp + b.dK_dp) * K * x.u);
      if (s.incremented) {
        V const inv_dt = 1.0 / s.dt;  // an increment is half a step of the rate
        GasState<V> const extra{inv_dt * (s.inc_a.rho + s.inc_b.rho), inv_dt * (s.inc_a.u + s.inc_b.u),
                                inv_dt * (s.inc_a.p + s.inc_b.p)};
        rate = {rate.rho + extra.rho, rate.u + extra.u, rate.p + extra.p};
        // its isentropic part, and the rest with dK/dp at constant density
        V const along = c2 * extra.rho;
        rate_K += 0.5 * (a.dK_dp + b.dK_dp) * along + exponent * (extra.p - along);
      }
      GasState<V> const q = quadratic(s.dt, rho, v, K, c, rate, rate_K, x);
      out.star = {select(smooth, rho_s + q.rho, rho_s), select(smooth, u_s + q.u, u_s), select(smooth, p_s + q.p, p_s)};
      V const share = s.dt * (1.0 / 3.4641016151377545871);
      out.change = {select(smooth, share * rate.rho, zero), select(smooth, share * rate.u, zero),
                    select(smooth, share * rate.p, zero)};
    }
    if (all(weak)) return out;

    // the two sides of the Riemann problem: upwind the bounded parabola, downwind the smaller slope of its far side
    auto const sides = [&](V A, V B, V C, V l, Mask<V> forward, V hg, V& d_l, V& d_r) G27_INLINE_LAMBDA {
      V const far = select(forward, C, A);
      V g = select(far * B > 0.0, select(abs(far) < abs(B), far, B), zero);
      if constexpr (!limited) g = B;
      g = g * keep;
      d_l = select(forward, hg, (s.h_a - l) * g);
      d_r = -select(forward, (s.h_b + l) * g, hg);
    };
    V lp, rp, lm, rm, l0, r0;
    sides(Ap, Bp, Cp, l_p, fwd_p, hg_p, lp, rp);
    sides(Am, Bm, Cm, l_m, fwd_m, hg_m, lm, rm);
    sides(gs0, gs1, gs2, l_0, fwd_0, hg_0, l0, r0);
    V const x_l = 0.5 * (lp + lm), x_r = 0.5 * (rp + rm);
    GasState<V> left{a.rho + l0 + x_l * inv_c2, a.u + 0.5 * (lp - lm) * inv_Z, a.p + x_l};
    GasState<V> right{b.rho + r0 + x_r * inv_c2, b.u + 0.5 * (rp - rm) * inv_Z, b.p + x_r};
    if (s.incremented) {
      left = {left.rho + s.inc_a.rho, left.u + s.inc_a.u, left.p + s.inc_a.p};
      right = {right.rho + s.inc_b.rho, right.u + s.inc_b.u, right.p + s.inc_b.p};
    }
    V const floor = min(a.p, b.p) - 0.8 * K_min / exponent;
    Mask<V> const weak_sides = allow && abs(right.p - left.p) <= weak_pressure * K_min &&
                               abs(right.u - left.u) <= weak_velocity * c && p_s > floor && rho_s > 0.2 * rho_min &&
                               left.rho > 0.2 * rho_min && right.rho > 0.2 * rho_min;
    out.left = left, out.right = right, out.weak = weak || weak_sides;
    return out;
  }

  /// (h_u - s) times the bounded slope over the swept interval.
  template <bool entropy, Lane V>
  G27_INLINE static V field(Stencil<V> const& s, V A, V B, V C, V l, Mask<V> forward, V scale, V rho, V gate, V c2,
                            V keep, V& switched) noexcept {
    V const zero(0.0), one(1.0), h_sum = s.h_a + s.h_b;
    V const swept = abs(l), D = select(forward, A, C), h_u = select(forward, s.h_a, s.h_b), h_d = h_sum - h_u;
    V const lin = B + ((swept + h_d) * select(forward, s.triple_a, s.triple_b)) * (D - B);
    V const rest = max(h_u - swept, zero);
    if constexpr (!limited) return rest * lin;

    V const size_B = abs(B), sign = select(B < 0.0, V(-1.0), one);
    V up = lin * sign;
    V const d = D * sign;
    V bound;
    if constexpr (!entropy) {
      bound = min(4.0 * d, 2.0 * size_B);
    } else {
      // Compression of a contact: where the slope is the steepest of three, by more than the threshold, and no
      // pressure jump goes with it, up to the universal bounds (no new extremum in the swept interval).
      V const curvature = min(abs(B - A), abs(B - C));
      Mask<V> const steep = curvature > parabolic::compression * size_B && size_B > abs(A) && size_B > abs(C) &&
                            size_B * h_sum >= parabolic::compression_jump * rho &&
                            gate <= parabolic::compression_sound * c2 * size_B;
      Mask<V> const beyond = up > 2.0 * d || up * h_u > h_sum * size_B;
      bound = up;
      if (any(steep || beyond)) {
        V const e = parabolic::least_share * h_u, from = swept + e, to = max(h_u - swept, e);
        V const universal = min(min(2.0 * h_u * d / from, 8.0 * d), min(h_sum * size_B / to, 8.0 * size_B));
        V const share =
            min(one, (curvature - parabolic::compression * size_B) / max(parabolic::compression * size_B, V(1e-300)));
        V const steepened = up + share * (max(universal, up) - up);
        up = select(steep, steepened, up);
        bound = select(steep || beyond, universal, bound);
      }
    }
    V g = max(zero, min(up, bound)) * sign;
    Mask<V> const changed = g != lin;
    if (any(changed)) {
      V const k1 = (B - A) * s.triple_a, k2 = (C - B) * s.triple_b;
      double const amplitude = entropy ? parabolic::smooth_entropy : parabolic::smooth_acoustic;
      Mask<V> const smooth = max(abs(A), max(size_B, abs(C))) * h_sum <= amplitude * scale &&
                             k1 * (3.0 * k2 - k1) >= 0.0 && k2 * (3.0 * k1 - k2) >= 0.0;
      g = select(smooth, lin, g);
    }
    g = g * keep;
    // round-off noise in a field that is not there is bounded too, to no effect: it does not count
    switched += select(abs(g - lin) * h_sum > parabolic::round_off * scale, one, zero);
    return rest * g;
  }

 private:
  template <Lane V>
  struct Slopes {
    V rho, u, p, K;
  };

  /// What a nonlinear flow adds to the mean of the face state over the step, to third order, beyond the swept averages.
  /// From W_t = -A W_x the mean is W - (dt/2) A W_x + (dt^2/6) (A^2 W_xx + A (A_x W_x) - A'[W_t] W_x); the swept
  /// averages with their shortened lengths hold all of it but the last two terms, of which they hold
  /// (dt^2/3) lambda lambda_x for every field. v: velocity over the face; rate, rate_K: d/dt of the state and of K.
  template <Lane V>
  G27_INLINE static GasState<V> quadratic(V dt, V rho, V v, V K, V c, GasState<V> const& rate, V rate_K,
                                          Slopes<V> const& x) noexcept {
    V const inv_rho = 1.0 / rho, inv_rho2 = inv_rho * inv_rho, Z = rho * c, inv_c2 = rho / K;
    // B = A_x W_x
    V const b_rho = 2.0 * x.rho * x.u, b_u = x.u * x.u - x.rho * x.p * inv_rho2, b_p = (x.K + x.p) * x.u;
    V const q_rho = v * b_rho + rho * b_u - rate.u * x.rho - rate.rho * x.u;
    V const q_u = v * b_u + b_p * inv_rho - rate.u * x.u + rate.rho * x.p * inv_rho2;
    V const q_p = K * b_u + v * b_p - rate_K * x.u - rate.u * x.p;
    // already there, by the shortened lengths
    V const c_x = 0.5 * c * (x.K / K - x.rho * inv_rho);
    V const s_p = 2.0 * (v + c) * (x.u + c_x) * (x.p + Z * x.u), s_m = 2.0 * (v - c) * (x.u - c_x) * (x.p - Z * x.u);
    V const s_0 = 2.0 * v * x.u * (x.rho - x.p * inv_c2);
    V const have_p = 0.5 * (s_p + s_m), have_u = 0.5 * (s_p - s_m) / Z, have_rho = s_0 + have_p * inv_c2;
    V const k = dt * dt * (1.0 / 6.0);
    return {k * (q_rho - have_rho), k * (q_u - have_u), k * (q_p - have_p)};
  }

  /// 0 on faces near a strong shock that hardly moves over the mesh (relative to the sound speed), 1 elsewhere.
  template <Lane V>
  G27_INLINE static V slow_shock(Stencil<V> const& s, V c) noexcept {
    V const one(1.0), zero(0.0);
    auto const jump = [&](Cell<V> const& l, Cell<V> const& r) G27_INLINE_LAMBDA {
      return abs(r.p - l.p) > parabolic::shock_pressure * min(l.K, r.K) && r.u < l.u &&
             abs(r.rho * (r.u - s.w) - l.rho * (l.u - s.w)) <= parabolic::shock_slowness * c * abs(r.rho - l.rho);
    };
    V const low = min(min(s.z.p, s.a.p), min(s.b.p, s.y.p)), high = max(max(s.z.p, s.a.p), max(s.b.p, s.y.p));
    V const K_low = min(min(s.z.K, s.a.K), min(s.b.K, s.y.K));
    if (!any(high - low > parabolic::shock_pressure * K_low)) return one;
    return select(jump(s.z, s.a) || jump(s.a, s.b) || jump(s.b, s.y), zero, one);
  }
};

}  // namespace g27
