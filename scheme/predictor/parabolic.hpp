#pragma once
/// The parabolic predictor: the two parabolas of the monotonicity switch become the interpolant, averaged over the
/// interval that each characteristic sweeps in a step. Third order on smooth flow, inside the paper's stencil.
///
/// On linear waves the swept averages alone are of third order. A nonlinear flow needs three things more, each of
/// second order and each taken where the data are smooth: the cell averages of u and p (average_loop.hpp), the
/// quadratic terms of the face state's mean over the step, and fluxes averaged over the step (solve_loop.hpp).
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
inline constexpr double share_expansion = 2.3, share_compression = 2.0;  ///< bounds over the slope across the face
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
    // one division and one root that do not wait for each other
    V const Z2 = rho * K, inv = 1.0 / Z2, Z = sqrt(Z2), inv_Z = inv * Z, inv_rho = inv * K, inv_K = inv * rho;
    V const c2 = K * inv_rho, inv_c2 = rho * inv_K, c = Z * inv_rho;
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
    Slopes<V> const half{.rho = gr1, .u = d_u * s.pair_ab, .p = gp1, .K = (b.K - a.K) * s.pair_ab};
    V const rel_rho = half.rho * inv_rho, rel_K = half.K * inv_K;
    V const D_u = k * half.u, D_c = (0.5 * k) * c * (rel_K - rel_rho);
    auto const shrink = [&](V d) G27_INLINE_LAMBDA {
      return s.dt * (1.0 - max(V(parabolic::speed_low), min(V(parabolic::speed_high), d)));
    };
    V const l_p = (v + c) * shrink(D_u + D_c), l_m = (v - c) * shrink(D_u - D_c), l_0 = v * shrink(D_u);
    Mask<V> const fwd_p = l_p >= 0.0, fwd_m = l_m >= 0.0, fwd_0 = l_0 >= 0.0;

    V const gate = max(abs(gp0), max(abs(gp1), abs(gp2)));
    V const K_min = min(a.K, b.K), rho_min = min(a.rho, b.rho);
    Slow<V> const slow = limited ? slow_shock(s, c, gate, K_min) : Slow<V>{};
    V switched(0.0);
    auto const acoustic = [&](V A, V B, V C, V l, Mask<V> forward, Mask<V> expands) G27_INLINE_LAMBDA {
      return field<false>(s, A, B, C, l, forward, Z * c, rho, gate, c2, slow, switched, expands);
    };
    V const Ap = gp0 + gu0, Bp = gp1 + gu1, Cp = gp2 + gu2, Am = gp0 - gu0, Bm = gp1 - gu1, Cm = gp2 - gu2;
    V const hg_p = acoustic(Ap, Bp, Cp, l_p, fwd_p, Bp > 0.0), hg_m = acoustic(Am, Bm, Cm, l_m, fwd_m, Bm < 0.0);
    Mask<V> along(false);
    if (s.incremented && s.own_increments) {
      along = s.inc_a.rho != 0.0 || s.inc_b.rho != 0.0 || s.inc_a.p != 0.0 || s.inc_b.p != 0.0;
    }
    V const hg_0 = field<true>(s, gs0, gs1, gs2, l_0, fwd_0, rho, rho, gate, c2, slow, switched, along);

    // the star state without a solver: deviations of the three fields from the mean of the two cells
    auto const deviation = [&](V hg, V B, Mask<V> forward) G27_INLINE_LAMBDA {
      V const e = hg - 0.5 * h_sum * B;
      return select(forward, e, -e);
    };
    V e_p = deviation(hg_p, Bp, fwd_p), e_m = deviation(hg_m, Bm, fwd_m), e_0 = deviation(hg_0, gs1, fwd_0);
    // a contact that stands comes from both sides: mirror images stay so
    Mask<V> const stands = l_0 == 0.0 && gs1 != 0.0;
    V hg_0r = hg_0;
    if (any(stands)) {
      V again(0.0);
      hg_0r = field<true>(s, gs0, gs1, gs2, l_0, Mask<V>(false), rho, rho, gate, c2, slow, again, along);
      e_0 = select(stands, 0.5 * (e_0 + deviation(hg_0r, gs1, Mask<V>(false))), e_0);
    }
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
    Mask<V> const allow(s.linear_star);
    Mask<V> weak = allow && abs(d_p) <= weak_pressure * K_min && abs(d_u) <= weak_velocity * c && rho_s > 0.2 * rho_min;
    if (s.incremented && s.own_increments) weak = weak && alike(s.inc_a, s.inc_b, rho, K_min, c);
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
      // halves of d/dx and of d/dt; A W_x = -W_t without increments
      GasState<V> rate{-(v * half.rho + rho * half.u), -(v * half.u + half.p * inv_rho), -(v * half.p + K * half.u)};
      V const dK_dp = 0.5 * (a.dK_dp + b.dK_dp), v_u = v * half.u, rel = rel_K + rel_rho;
      // What a nonlinear flow adds to the mean of the face state over the step, to third order, beyond the swept
      // averages. The mean is W - (dt/2) A W_x + (dt^2/6) (A^2 W_xx + A (A_x W_x) - A'[W_t] W_x); the swept averages
      // hold A^2 W_xx and, with their shortened lengths, (dt^2/3) lambda lambda_x of each field. What is left:
      GasState<V> q{2.0 * v_u * half.rho - (rel_K - rel_rho) * (half.p + rho * v_u),
                    inv_rho * (half.u * (c2 * half.rho - half.p) - v * half.p * rel),
                    K * (half.u * half.u * (dK_dp - 1.0) + v_u * rel) + half.p * (half.p - half.K) * inv_rho};
      if (s.incremented) {
        V const half_rate = 0.5 / s.dt;  // an increment is half a step of the rate
        GasState<V> const extra{half_rate * (s.inc_a.rho + s.inc_b.rho), half_rate * (s.inc_a.u + s.inc_b.u),
                                half_rate * (s.inc_a.p + s.inc_b.p)};
        rate = {rate.rho + extra.rho, rate.u + extra.u, rate.p + extra.p};
        // dK/dt: its isentropic part, and the rest with dK/dp at constant density
        V const isentropic = c2 * extra.rho, extra_K = dK_dp * isentropic + exponent * (extra.p - isentropic);
        q.rho -= extra.u * half.rho + extra.rho * half.u;
        q.u -= extra.u * half.u - extra.rho * half.p * inv_rho * inv_rho;
        q.p -= extra_K * half.u + extra.u * half.p;
      }
      V const k_q = s.dt * s.dt * (4.0 / 6.0), k_t = s.dt * (2.0 / 3.4641016151377545871);
      out.star = {select(smooth, rho_s + k_q * q.rho, rho_s), select(smooth, u_s + k_q * q.u, u_s),
                  select(smooth, p_s + k_q * q.p, p_s)};
      out.change = {select(smooth, k_t * rate.rho, zero), select(smooth, k_t * rate.u, zero),
                    select(smooth, k_t * rate.p, zero)};
    }
    if (all(weak)) return out;

    // the two sides of the Riemann problem: upwind the bounded parabola, downwind the smaller slope of its far side
    auto const sides = [&](V A, V B, V C, V l, Mask<V> forward, V hg, V& d_l, V& d_r) G27_INLINE_LAMBDA {
      V const far = select(forward, C, A);
      V g = select(far * B > 0.0, select(abs(far) < abs(B), far, B), zero);
      if constexpr (!limited) g = B;
      if (slow.somewhere) g = select(slow.face, zero, g);
      d_l = select(forward, hg, (s.h_a - l) * g);
      d_r = -select(forward, (s.h_b + l) * g, hg);
    };
    V lp, rp, lm, rm, l0, r0;
    sides(Ap, Bp, Cp, l_p, fwd_p, hg_p, lp, rp);
    sides(Am, Bm, Cm, l_m, fwd_m, hg_m, lm, rm);
    sides(gs0, gs1, gs2, l_0, fwd_0, hg_0, l0, r0);
    r0 = select(stands, -hg_0r, r0);
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

  /// Faces near a strong shock that hardly moves over the mesh (relative to the sound speed).
  template <Lane V>
  struct Slow {
    Mask<V> face{false};
    bool somewhere = false;
  };
  template <Lane V>
  G27_INLINE static Slow<V> slow_shock(Stencil<V> const& s, V c, V steepest_p, V K_min) noexcept {
    // cheap and a little too often true; the pressure slopes are differences times pair
    V const K_low = min(K_min, min(s.z.K, s.y.K)),
            pair_low = s.uniform ? s.pair_ab : min(s.pair_za, min(s.pair_ab, s.pair_by));
    if (!any(steepest_p > (0.99 * parabolic::shock_pressure) * pair_low * K_low)) return {};
    auto const jump = [&](Cell<V> const& l, Cell<V> const& r) G27_INLINE_LAMBDA {
      return abs(r.p - l.p) > parabolic::shock_pressure * min(l.K, r.K) && r.u < l.u &&
             abs(r.rho * (r.u - s.w) - l.rho * (l.u - s.w)) <= parabolic::shock_slowness * c * abs(r.rho - l.rho);
    };
    Mask<V> const face = jump(s.z, s.a) || jump(s.a, s.b) || jump(s.b, s.y);
    return {face, any(face)};
  }

  /// (h_u - s) times the bounded slope over the swept interval. `special`: of an acoustic field, the wave expands; of
  /// the entropy, the gas moves along the face as well.
  template <bool entropy, Lane V>
  G27_INLINE static V field(Stencil<V> const& s, V A, V B, V C, V l, Mask<V> forward, V scale, V rho, V gate, V c2,
                            Slow<V> const& slow, V& switched, Mask<V> special) noexcept {
    V const zero(0.0), one(1.0), h_sum = s.h_a + s.h_b;
    V const swept = abs(l), D = select(forward, A, C);
    V const h_u = s.uniform ? s.h_a : select(forward, s.h_a, s.h_b), h_d = h_sum - h_u;
    V const triple = s.uniform ? s.triple_a : select(forward, s.triple_a, s.triple_b);
    V const lin = B + ((swept + h_d) * triple) * (D - B);
    V const rest = max(h_u - swept, zero);
    if constexpr (!limited) return rest * lin;

    V const size_B = abs(B), sign = select(B < 0.0, V(-1.0), one);
    V up = lin * sign;
    V const d = D * sign;
    V bound;
    if constexpr (!entropy) {
      // expansions bear a larger share of the face's own slope than shocks
      V const share = select(special, V(parabolic::share_expansion), V(parabolic::share_compression));
      bound = min(4.0 * d, share * size_B);
    } else {
      // Compression of a contact: where the slope is the steepest of three, by more than the threshold, and no
      // pressure jump goes with it, up to the universal bounds (no new extremum in the swept interval).
      Mask<V> const beyond = up > 2.0 * d || up * h_u > h_sum * size_B;
      Mask<V> const large = size_B * h_sum >= parabolic::compression_jump * rho;
      bound = up;
      if (any(large || beyond)) {
        V const curvature = min(abs(B - A), abs(B - C));
        Mask<V> const steep = large && curvature > parabolic::compression * size_B && size_B > abs(A) &&
                              size_B > abs(C) && gate <= parabolic::compression_sound * c2 * size_B;
        V const e = parabolic::least_share * h_u, from = swept + e, to = max(h_u - swept, e);
        V const each = 1.0 / (from * to);
        // A contact that is carried obliquely is compressed by every direction: no further than the acoustic bounds.
        V const universal =
            select(special, min(4.0 * d, 2.0 * size_B),
                   min(min(2.0 * h_u * to * each, V(8.0)) * d, min(h_sum * from * each, V(8.0)) * size_B));
        bound = select(beyond, universal, bound);
        if (any(steep)) {
          V const share = min(one, curvature / max(parabolic::compression * size_B, V(1e-300)) - 1.0);
          up = select(steep, up + share * (max(universal, up) - up), up);
          bound = select(steep, universal, bound);
        }
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
    if (slow.somewhere) g = select(slow.face, zero, g);
    if (any(changed) || slow.somewhere) {
      // round-off noise in a field that is not there is bounded too, to no effect: it does not count
      switched += select(abs(g - lin) * h_sum > parabolic::round_off * scale, one, zero);
    }
    return rest * g;
  }

 private:
  template <Lane V>
  struct Slopes {
    V rho, u, p, K;
  };
};

}  // namespace g27
