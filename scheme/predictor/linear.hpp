#pragma once
/// The paper's predictor: W linear between cell centres, each variable family taken where its characteristic starts
/// at half the time step (OG (3.11)): R+- at -(u +- c - w) dt/2, density and transverse velocity at -(u - w) dt/2.
#include "riemann/base/lane_math.hpp"
#include "scheme/predictor/monotonicity.hpp"

namespace g27 {

/// `per_cell_feet`: the points of OG (3.10), -(lambda dt/2 + shift) factor, with the shift and factor of the cell that
/// the face is computed for; otherwise from the face. `single_foot`: density at the acoustic feet as well.
template <Switch kind, bool per_cell_feet = false, bool single_foot = false>
struct LinearPredictor {
  static constexpr bool third_order = false;

  template <Lane V>
  G27_INLINE static FacePrediction<V> predict(Stencil<V> const& s, double exponent) noexcept {
    Cell<V> const &z = s.z, &a = s.a, &b = s.b, &y = s.y;
    V const x_f = s.h_a * s.pair_ab;  // the face between the centres, 0 at a, 1 at b
    V const d_rho = b.rho - a.rho, d_u = b.u - a.u, d_p = b.p - a.p, d_K = b.K - a.K;
    V const rho = a.rho + x_f * d_rho, u = a.u + x_f * d_u, K = a.K + x_f * d_K;
    // one division and one root that do not wait for each other
    V const Z2 = rho * K, inv = 1.0 / Z2, Z = sqrt(Z2), inv_Z = inv * Z, c = Z * (inv * K), inv_c2 = rho * (inv * rho);
    V const v = u - s.w;

    V phi_p(1.0), phi_m(1.0), phi_0(1.0), phi_0r(1.0);
    if constexpr (kind == Switch::literal) {
      // the paper's switch: one for all, from pressure alone
      phi_p = switch_value<kind>(s, (a.p - z.p) * s.pair_za, d_p * s.pair_ab, (y.p - b.p) * s.pair_by, v > 0.0, K);
      phi_m = phi_0 = phi_0r = phi_p;
    } else if constexpr (kind != Switch::off) {
      V const p0 = (a.p - z.p) * s.pair_za, p1 = d_p * s.pair_ab, p2 = (y.p - b.p) * s.pair_by;
      V const u0 = Z * (a.u - z.u) * s.pair_za, u1 = Z * d_u * s.pair_ab, u2 = Z * (y.u - b.u) * s.pair_by;
      V const r0 = (a.rho - z.rho) * s.pair_za, r1 = d_rho * s.pair_ab, r2 = (y.rho - b.rho) * s.pair_by;
      V const Ap = p0 + u0, Bp = p1 + u1, Cp = p2 + u2, Am = p0 - u0, Bm = p1 - u1, Cm = p2 - u2;
      V const A0 = r0 - p0 * inv_c2, B0 = r1 - p1 * inv_c2, C0 = r2 - p2 * inv_c2;
      Mask<V> const fwd_p = v + c >= 0.0, fwd_m = v - c >= 0.0, fwd_0 = v >= 0.0;
      // the graded switch leaves a field alone whose upwind slope is at least half of that across the face
      auto const acts = [&](V A, V B, V C, Mask<V> forward)
                            G27_INLINE_LAMBDA { return !(2.0 * select(forward, A, C) * B >= B * B) || B == 0.0; };
      if (kind != Switch::graded ||
          any(acts(Ap, Bp, Cp, fwd_p) || acts(Am, Bm, Cm, fwd_m) || acts(A0, B0, C0, fwd_0))) {
        phi_p = switch_value<kind>(s, Ap, Bp, Cp, fwd_p, K);
        phi_m = switch_value<kind>(s, Am, Bm, Cm, fwd_m, K);
        phi_0 = phi_0r = switch_value<kind>(s, A0, B0, C0, fwd_0, rho);
      }
      if constexpr (kind == Switch::graded) {
        // a contact that stands comes from both sides, each with its own neighbour: mirror images stay so
        if (Mask<V> const stands = v == 0.0; any(stands)) {
          phi_0r = select(stands, switch_value<kind>(s, A0, B0, C0, v > 0.0, rho), phi_0r);
        }
      }
    }

    // feet in units of the distance between the centres, clipped to the two half cells
    V const t2 = 0.5 * s.dt, to_unit = 2.0 * s.pair_ab;
    auto const at = [&](V lambda) G27_INLINE_LAMBDA {
      V x = -lambda * t2;
      if constexpr (per_cell_feet) x = (x - s.foot_shift) * s.foot_factor;
      return x_f + max(-0.5 * s.h_a, min(0.5 * s.h_b, x)) * to_unit;
    };
    V const x_p = at(v + c), x_m = at(v - c), x_0 = at(v);

    // from the left cell: a + phi (W(x) - a); from the right one: b + phi (W(x) - b)
    GasState<V> left{a.rho + phi_p * x_p * d_rho, a.u + phi_p * x_p * d_u, a.p + phi_p * x_p * d_p};
    GasState<V> right{b.rho - phi_m * (1.0 - x_m) * d_rho, b.u - phi_m * (1.0 - x_m) * d_u,
                      b.p - phi_m * (1.0 - x_m) * d_p};
    // Outside the acoustic cone both families come from one side, each from its own foot.
    Mask<V> const from_left = v - c > 0.0, from_right = v + c < 0.0;
    if (any(from_left || from_right)) {
      V const other_p_l = a.p + phi_m * x_m * d_p, other_u_l = a.u + phi_m * x_m * d_u;
      V const other_p_r = b.p - phi_p * (1.0 - x_p) * d_p, other_u_r = b.u - phi_p * (1.0 - x_p) * d_u;
      V p_l = 0.5 * (left.p + other_p_l) + 0.5 * Z * (left.u - other_u_l);
      V u_l = 0.5 * (left.u + other_u_l) + 0.5 * inv_Z * (left.p - other_p_l);
      V p_r = 0.5 * (other_p_r + right.p) + 0.5 * Z * (other_u_r - right.u);
      V u_r = 0.5 * (other_u_r + right.u) + 0.5 * inv_Z * (other_p_r - right.p);
      // tracing through a strong rarefaction may leave the physical range: take the cell
      V const low = min(a.p, b.p) - 0.5 * min(a.K, b.K) / exponent;
      Mask<V> const bad_l = p_l < low, bad_r = p_r < low;
      p_l = select(bad_l, a.p, p_l), u_l = select(bad_l, a.u, u_l);
      p_r = select(bad_r, b.p, p_r), u_r = select(bad_r, b.u, u_r);
      left.p = select(from_left, p_l, left.p), left.u = select(from_left, u_l, left.u);
      right.p = select(from_right, p_r, right.p), right.u = select(from_right, u_r, right.u);
    }

    // entropy rides with the contact: density at its own foot, moved along the isentrope to the acoustic pressure
    V rho_l = a.rho + phi_0 * x_0 * d_rho, pz_l = a.p + phi_0 * x_0 * d_p;
    V rho_r = b.rho - phi_0r * (1.0 - x_0) * d_rho, pz_r = b.p - phi_0r * (1.0 - x_0) * d_p;
    if constexpr (single_foot) rho_l = left.rho, pz_l = left.p, rho_r = right.rho, pz_r = right.p;

    if (s.incremented) {
      // entropy part of the increment to the density, the acoustic part with the pressure
      rho_l += s.inc_a.rho, pz_l += s.inc_a.p, left.u += s.inc_a.u, left.p += s.inc_a.p;
      rho_r += s.inc_b.rho, pz_r += s.inc_b.p, right.u += s.inc_b.u, right.p += s.inc_b.p;
    }

    V p_s = 0.5 * (left.p + right.p) + 0.5 * Z * (left.u - right.u);
    V u_s = 0.5 * (left.u + right.u) + 0.5 * inv_Z * (left.p - right.p);
    p_s = select(from_left, left.p, select(from_right, right.p, p_s));
    u_s = select(from_left, left.u, select(from_right, right.u, u_s));
    Mask<V> const left_of_contact = u_s > s.w;
    V const rho_s = select(left_of_contact, rho_l + (p_s - pz_l) * inv_c2, rho_r + (p_s - pz_r) * inv_c2);
    V const K_min = min(a.K, b.K);
    Mask<V> weak = Mask<V>(s.linear_star) && abs(d_p) <= weak_pressure * K_min && abs(d_u) <= weak_velocity * c &&
                   rho_s > 0.2 * min(a.rho, b.rho);
    if (s.incremented && s.own_increments) weak = weak && alike(s.inc_a, s.inc_b, rho, K_min, c);
    V const one(1.0), zero(0.0);
    V const switched = select(phi_p < 1.0, one, zero) + select(phi_m < 1.0, one, zero) + select(phi_0 < 1.0, one, zero);

    FacePrediction<V> out{
        .star = {rho_s, u_s, p_s}, .change = {}, .left = left, .right = right, .weak = weak, .switched = switched};
    if (!all(weak)) {
      // rho (1 + g dp/K)^(1/g): exact isentrope of an ideal or stiffened gas, positive for every EOS
      V const K_l = a.K + phi_0 * x_0 * d_K, K_r = b.K - phi_0r * (1.0 - x_0) * d_K;
      V const base_l = max(1.0 + exponent * (left.p - pz_l) / K_l, V(1e-3));
      V const base_r = max(1.0 + exponent * (right.p - pz_r) / K_r, V(1e-3));
      // In a cold stream the pressures are next to nothing and their ratio anything: what they add to the density stays
      // within its own jump, but for what a weak wave may add.
      V const bound = abs(d_rho) + 0.01 * rho;
      auto const moved = [&](V from, V base) G27_INLINE_LAMBDA {
        V const change = from * pow(base, 1.0 / exponent) - from;
        return V(from + max(-bound, min(bound, change)));
      };
      out.left.rho = moved(rho_l, base_l), out.right.rho = moved(rho_r, base_r);
      if constexpr (single_foot) out.left.rho = rho_l, out.right.rho = rho_r;
    }
    return out;
  }
};

}  // namespace g27
