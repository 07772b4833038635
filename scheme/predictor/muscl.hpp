#pragma once
/// MUSCL-Hancock with van Leer's harmonic slopes on primitive variables (Toro, 3rd ed., 14.4): the comparison scheme.
#include "scheme/predictor/stencil.hpp"

namespace g27 {

/// A cell's two edge states after the half step, seen from faces moving at w_left and w_right.
template <Lane V>
struct CellEdges {
  GasState<V> left, right;
};

/// van Leer's harmonic mean of two slopes; zero at extrema.
template <Lane V>
G27_INLINE V van_leer(V a, V b) noexcept {
  V const product = a * b;
  return select(product > 0.0, 2.0 * product / select(product > 0.0, a + b, V(1.0)), V(0.0));
}

/// in m, c, p: cells i-1, i, i+1; pair_*: 1/(sum of widths) between them; h: width of c; inc: half-step increments.
template <Lane V>
G27_INLINE CellEdges<V> muscl_edges(Cell<V> const& m, Cell<V> const& c, Cell<V> const& p, V pair_m, V pair_p, V h, V dt,
                                    V w_left, V w_right, bool incremented, GasState<V> const& inc) noexcept {
  V const to_left = 2.0 * pair_m, to_right = 2.0 * pair_p;
  V const s_rho = van_leer((c.rho - m.rho) * to_left, (p.rho - c.rho) * to_right);
  V const s_u = van_leer((c.u - m.u) * to_left, (p.u - c.u) * to_right);
  V const s_p = van_leer((c.p - m.p) * to_left, (p.p - c.p) * to_right);
  V const inv_rho = 1.0 / c.rho, t2 = 0.5 * dt;
  auto const edge = [&](V x, V w) G27_INLINE_LAMBDA {
    V const v = c.u - w;
    GasState<V> e{c.rho + s_rho * x - t2 * (v * s_rho + c.rho * s_u), c.u + s_u * x - t2 * (v * s_u + s_p * inv_rho),
                  c.p + s_p * x - t2 * (v * s_p + c.K * s_u)};
    if (incremented) e = {e.rho + inc.rho, e.u + inc.u, e.p + inc.p};
    return e;
  };
  return {.left = edge(-0.5 * h, w_left), .right = edge(0.5 * h, w_right)};
}

}  // namespace g27
