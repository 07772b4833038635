#pragma once
/// Transverse half-step terms of a row of cells.
#include "riemann/base/lane.hpp"
#include "scheme/kernel/carbuncle_loop.hpp"
#include "scheme/kernel/grid_kernels.hpp"

namespace g27 {

inline constexpr double transverse_smooth = 0.05;  ///< share of rho, K, c up to which slopes are central
inline constexpr double transverse_least = 0.2;    ///< share of density and pressure margin that a term leaves

template <Lane V>
struct GridState {
  V rho, u[3], p;
};

/// Difference over a cell: central, or the smallest of twice both one-sided ones and the central one.
template <Lane V>
G27_INLINE V limited_difference(V below, V above, Mask<V> smooth) noexcept {
  V const central = 0.5 * (below + above), small = min(abs(below), abs(above));
  V const bounded = min(V(2.0 * small), abs(central));
  V const mc = select(below * above > 0.0, select(central < 0.0, -bounded, bounded), V(0.0));
  return select(smooth, central, mc);
}

template <int dims, Lane V>
void transverse(TransverseArguments& g) noexcept {
  g.any = false;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  double const* const u_row[3]{g.primitive.vector[0], g.primitive.vector[1], g.primitive.vector[2]};
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V const rho = load<V>(g.primitive.first + i), p = load<V>(g.primitive.last + i), K = load<V>(g.K + i);
    V const margin = load<V>(g.margin + i), inv_rho = 1.0 / rho;
    V u[3];
    unrolled<dims>([&](auto a) G27_INLINE_LAMBDA { u[a] = load<V>(u_row[a] + i); });
    V const most_rho = transverse_smooth * rho, most_p = transverse_smooth * K;
    V const most_u2 = (transverse_smooth * transverse_smooth) * K * inv_rho;

    // (dt/2) A W_x of every axis: density, velocities, pressure
    GridState<V> rate[dims];
    bool rough = false;
    unrolled<dims>([&](auto a) G27_INLINE_LAMBDA {
      std::ptrdiff_t const s = g.stride[a];
      V const k(g.half_dt_over_h[a]);
      auto const sides = [&](double const* q, V centre, V& below, V& above) G27_INLINE_LAMBDA {
        below = centre - load<V>(q + i - s), above = load<V>(q + i + s) - centre;
      };
      V r_b, r_a, p_b, p_a, u_b[3], u_a[3];
      sides(g.primitive.first, rho, r_b, r_a);
      sides(g.primitive.last, p, p_b, p_a);
      V u2(0.0);
      unrolled<dims>([&](auto c) G27_INLINE_LAMBDA {
        sides(u_row[c], u[c], u_b[c], u_a[c]);
        u2 = max(u2, max(u_b[c] * u_b[c], u_a[c] * u_a[c]));
      });
      Mask<V> const smooth = max(abs(r_b), abs(r_a)) <= most_rho && max(abs(p_b), abs(p_a)) <= most_p && u2 <= most_u2;
      V d_rho = 0.5 * (r_b + r_a), d_p = 0.5 * (p_b + p_a), d_u[3];
      unrolled<dims>([&](auto c) G27_INLINE_LAMBDA { d_u[c] = 0.5 * (u_b[c] + u_a[c]); });
      if (!all(smooth)) {
        rough = true;
        d_rho = limited_difference(r_b, r_a, smooth), d_p = limited_difference(p_b, p_a, smooth);
        unrolled<dims>([&](auto c) G27_INLINE_LAMBDA { d_u[c] = limited_difference(u_b[c], u_a[c], smooth); });
      }
      V const v = k * u[a], spread = k * d_u[a];
      rate[a].rho = v * d_rho + rho * spread;
      rate[a].p = v * d_p + K * spread;
      unrolled<dims>([&](auto c) G27_INLINE_LAMBDA { rate[a].u[c] = v * d_u[c]; });
      rate[a].u[a] += k * d_p * inv_rho;
    });
    if (g.flag != nullptr) {
      V flag(0.0);
      if (rough) flag = shock_flag<dims, V>(g.primitive, g.K, g.stride, i);
      store(g.flag + i, flag);
      if (any(flag > 0.0)) g.any = g.any || flagged(flag, i, n);
    }
    unrolled<dims>([&](auto a) G27_INLINE_LAMBDA {
      RowOut const& out = g.term[a];
      if (out.first == nullptr) return;
      GridState<V> t;
      if constexpr (dims == 2) {
        GridState<V> const& o = rate[1 - a];
        t = {-o.rho, {-o.u[0], -o.u[1], V(0.0)}, -o.p};
      } else {
        GridState<V> const &o = rate[(a + 1) % 3], &q = rate[(a + 2) % 3];
        t = {-(o.rho + q.rho), {-(o.u[0] + q.u[0]), -(o.u[1] + q.u[1]), -(o.u[2] + q.u[2])}, -(o.p + q.p)};
      }
      Mask<V> const deep = rho + t.rho < transverse_least * rho || margin + t.p < transverse_least * margin;
      if (any(deep)) {
        V const zero(0.0);
        t.rho = select(deep, zero, t.rho), t.p = select(deep, zero, t.p);
        unrolled<dims>([&](auto c) G27_INLINE_LAMBDA { t.u[c] = select(deep, zero, t.u[c]); });
      }
      store(out.first + i, t.rho), store(out.last + i, t.p);
      unrolled<dims>([&](auto c) G27_INLINE_LAMBDA { store(out.vector[c] + i, t.u[c]); });
    });
  }
}

}  // namespace g27
