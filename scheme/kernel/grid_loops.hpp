#pragma once
/// Rows of cells in two and three dimensions: primitives, averages of the primitives, corrector, what a new state is
/// worth.
#include "riemann/eos/concept.hpp"
#include "scheme/kernel/average_loop.hpp"
#include "scheme/kernel/grid_kernels.hpp"
#include "scheme/kernel/update_loop.hpp"

namespace g27 {

template <int dims, class E, Lane V>
void grid_primitive(GridPrimitiveArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    V const rho = load<V>(g.conserved.first + i);
    V const inv = 1.0 / rho;
    V u[dims];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) u[a] = load<V>(g.conserved.vector[a] + i) * inv;
    V e = load<V>(g.conserved.last + i) * inv - 0.5 * u[0] * u[0];
#pragma GCC unroll 3
    for (int a = 1; a < dims; ++a) e -= 0.5 * u[a] * u[a];
    V const p = eos.pressure(rho, e);
    store(g.primitive.first + i, rho), store(g.primitive.last + i, p);
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) store(g.primitive.vector[a] + i, u[a]);
    store(g.K + i, eos.bulk_modulus(rho, p)), store(g.margin + i, eos.pressure_margin(rho, p));
  }
}

/// The profile is linear along every axis: the second-order terms of average_loop.hpp add up.
template <int dims, class E, Lane V>
void grid_average(GridAverageArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V const rho = load<V>(g.primitive.first + i), p = load<V>(g.primitive.last + i), K = load<V>(g.K + i);
    V u[dims], moved[dims];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) u[a] = load<V>(g.primitive.vector[a] + i), moved[a] = V(0.0);
    Mask<V> smooth(true);
    V bend(0.0);
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) {
      std::ptrdiff_t const s = g.stride[static_cast<std::size_t>(a)];
      auto const sides = [&](double const* q, V centre, V& left, V& right) G27_INLINE_LAMBDA {
        left = centre - load<V>(q + i - s), right = load<V>(q + i + s) - centre;
      };
      V r_l, r_r, p_l, p_r, u_l, u_r;
      sides(g.primitive.first, rho, r_l, r_r), sides(g.primitive.last, p, p_l, p_r);
      smooth = smooth && max(abs(r_l), abs(r_r)) <= smooth_share * rho && max(abs(p_l), abs(p_r)) <= smooth_share * K;
      V const d_rho = 0.5 * (r_l + r_r), d_p = 0.5 * (p_l + p_r);
      V along(0.0), across(0.0);
#pragma GCC unroll 3
      for (int c = 0; c < dims; ++c) {
        sides(g.primitive.vector[c], u[c], u_l, u_r);
        V const most = max(abs(u_l), abs(u_r));
        smooth = smooth && most * most * rho <= (smooth_share * smooth_share) * K;
        V const d_u = 0.5 * (u_l + u_r);
        moved[c] += d_rho * d_u;
        if (c == a) {
          along = d_u;
        } else {
          across += d_u * d_u;
        }
      }
      V one = rho * along * along + eos.energy_bend(rho, d_rho, d_p);
      one += rho * across;
      bend += one;
    }
    store(g.dK_dp + i, V(2.0 * eos.fundamental_derivative(rho, p) - 1.0));
    store(g.p + i, select(smooth, V(p - eos.gruneisen(rho) * bend * (1.0 / 24.0)), p));
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) store(g.velocity[a] + i, select(smooth, V(u[a] - moved[a] / (12.0 * rho)), u[a]));
  }
}

template <int dims, int axes, Lane V>
G27_INLINE void grid_update_by(GridUpdateArguments const& g) noexcept {
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    auto const one = [&](auto const& row_of) G27_INLINE_LAMBDA {
      V q = load<V>(row_of(g.from) + i);
      for (std::size_t a = 0; a < axes; ++a) {
        V const lambda(g.lambda[a]);
        q -= lambda * V(load<V>(row_of(g.upper[a]) + i) - load<V>(row_of(g.lower[a]) + i));
      }
      store(row_of(g.to) + i, q);
    };
    one([](auto const& r) G27_INLINE_LAMBDA { return r.first; });
    one([](auto const& r) G27_INLINE_LAMBDA { return r.vector[0]; });
    one([](auto const& r) G27_INLINE_LAMBDA { return r.vector[1]; });
    if constexpr (dims == 3) one([](auto const& r) G27_INLINE_LAMBDA { return r.vector[2]; });
    one([](auto const& r) G27_INLINE_LAMBDA { return r.last; });
  }
}

template <int dims, Lane V>
void grid_update(GridUpdateArguments const& g) noexcept {
  if (g.axes == 1) {
    grid_update_by<dims, 1, V>(g);
  } else {
    grid_update_by<dims, 2, V>(g);
  }
}

template <int dims, class E, Lane V>
void grid_finish(GridFinishArguments& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  V worst(g.worst), rate(g.rate);
  bool differs = g.differs;
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    V const mass = load<V>(g.conserved.first + i), energy = load<V>(g.conserved.last + i);
    V const inv = 1.0 / mass;
    V u[dims];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) u[a] = load<V>(g.conserved.vector[a] + i) * inv;
    V e = energy * inv - 0.5 * u[0] * u[0];
#pragma GCC unroll 3
    for (int a = 1; a < dims; ++a) e -= 0.5 * u[a] * u[a];
    V const p = eos.pressure(mass, e), K = eos.bulk_modulus(mass, p), margin = eos.pressure_margin(mass, p);
    V const safe = share_left(mass, load<V>(g.rho_old + i), margin, load<V>(g.margin_old + i));
    V const c = sqrt(V(K * inv));
    V speed(0.0);
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) {
      V const one = (abs(u[a]) + c) * g.inv_h[static_cast<std::size_t>(a)];
      speed = g.max_rule ? max(speed, one) : V(speed + one);
    }
    if (i + width<V> <= g.cells) {
      worst = min(worst, safe), rate = max(rate, speed);
      if (!differs) {
        Mask<V> same = mass == g.like[0] && energy == g.like[4];
#pragma GCC unroll 3
        for (int a = 0; a < dims; ++a) same = same && load<V>(g.conserved.vector[a] + i) == g.like[1 + a];
        differs = !all(same);
      }
    } else {
      for (std::size_t k = 0; i + k < g.cells; ++k) {
        worst = min(worst, V(lane(safe, k))), rate = max(rate, V(lane(speed, k)));
        differs = differs || g.conserved.first[i + k] != g.like[0] || g.conserved.last[i + k] != g.like[4];
#pragma GCC unroll 3
        for (int a = 0; a < dims; ++a) differs = differs || g.conserved.vector[a][i + k] != g.like[1 + a];
      }
    }
  }
  g.worst = lane_min(worst), g.rate = lane_max(rate), g.differs = differs;
}

}  // namespace g27
