#pragma once
/// Transverse half-step terms of a row of solid cells, from central differences in each cell.
#include "riemann/strength/jaumann.hpp"
#include "scheme/kernel/solid_face_loop.hpp"

namespace g27 {

/// (dt/2) A_b W_b of one axis, components along x, y, z; `work` (dt/2) S:D of its gradient.
template <Lane V>
struct SolidRateTerm {
  V q[solid_cell::state], work;
};

/// in  here: the cell's state; d: (dt/2) times its derivatives along `axis`
template <int axis, Lane V>
G27_INLINE SolidRateTerm<V> rate_of(double mu, V const* here, V const* d, V K, V f, V inv_rho) noexcept {
  namespace cell = solid_cell;
  constexpr int c[6] = {frame_component(axis, 0), frame_component(axis, 1), frame_component(axis, 2),
                        frame_component(axis, 3), frame_component(axis, 4), frame_component(axis, 5)};
  V const u = here[cell::u + axis];
  V const S[6] = {here[cell::S + c[0]], here[cell::S + c[1]], here[cell::S + c[2]],
                  here[cell::S + c[3]], here[cell::S + c[4]], here[cell::S + c[5]]};
  V const grad[3] = {d[cell::u + axis], d[cell::u + (axis + 1) % 3], d[cell::u + (axis + 2) % 3]};
  V jaumann[6];
  jaumann_along(mu, S, grad, jaumann);
  SolidRateTerm<V> r;
  r.work = S[0] * grad[0] + S[3] * grad[1] + S[4] * grad[2];
  unrolled<cell::state>([&](auto n) G27_INLINE_LAMBDA { r.q[n] = u * d[n]; });
  r.q[cell::rho] += here[cell::rho] * grad[0];
  r.q[cell::u + axis] -= (d[cell::S + c[0]] - d[cell::p]) * inv_rho;
  r.q[cell::u + (axis + 1) % 3] -= d[cell::S + c[3]] * inv_rho;
  r.q[cell::u + (axis + 2) % 3] -= d[cell::S + c[4]] * inv_rho;
  r.q[cell::p] += K * grad[0] - f * r.work;
  r.q[cell::e] += (here[cell::p] * grad[0] - r.work) * inv_rho;
  unrolled<6>([&](auto n) G27_INLINE_LAMBDA { r.q[cell::S + c[n]] -= jaumann[n]; });
  return r;
}

template <int axis, Lane V>
G27_INLINE SolidRateTerm<V> rate_along(SolidTransverseArguments const& g, std::ptrdiff_t i, V const* here, V K, V f,
                                       V inv_rho) noexcept {
  namespace cell = solid_cell;
  std::ptrdiff_t const s = g.stride[axis];
  V const k(g.quarter_dt_over_h[axis]);
  V d[cell::state];
  unrolled<cell::state>(
      [&](auto n) G27_INLINE_LAMBDA { d[n] = k * (load<V>(g.cell[n] + i + s) - load<V>(g.cell[n] + i - s)); });
  return rate_of<axis>(g.mu, here, d, K, f, inv_rho);
}

template <Lane V>
void solid_transverse(SolidTransverseArguments const& g) noexcept {
  namespace cell = solid_cell;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V here[cell::state];
    unrolled<cell::state>([&](auto k) G27_INLINE_LAMBDA { here[k] = load<V>(g.cell[k] + i); });
    V const K = load<V>(g.cell[cell::K] + i), f = load<V>(g.cell[cell::f] + i), inv_rho = 1.0 / here[cell::rho];
    SolidRateTerm<V> r[3]{};
    unrolled<3>([&](auto b) G27_INLINE_LAMBDA {
      if (g.quarter_dt_over_h[b] != 0.0) r[b] = rate_along<b>(g, i, here, K, f, inv_rho);
    });
    unrolled<3>([&](auto a) G27_INLINE_LAMBDA {
      constexpr int b = a == 0 ? 1 : 0, c = a == 2 ? 1 : 2;
      FieldRows const& to = g.term[a];
      if (to.data == nullptr) return;
      unrolled<cell::state>([&](auto k) G27_INLINE_LAMBDA { store(to[k] + i, V(-(r[b].q[k] + r[c].q[k]))); });
      store(to[cell::work] + i, V(r[b].work + r[c].work));
    });
  }
}

}  // namespace g27
