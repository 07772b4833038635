#pragma once
/// Cell averages of velocity and pressure from the averages of the conserved variables.
///
/// A profile that is linear in the cell, with the differences drho, du, dp across it, has the averages
///   <rho u> = <rho><u> + drho du/12,   <rho e> + <rho u^2>/2 - <rho u>^2/(2 <rho>) = f(<rho>, <p>) + (f'' + <rho>
///   du^2)/24,
/// f(rho, p) = rho e and f'' its second derivative along (drho, dp). The primitives of the averages are off by these
/// second-order terms; a third-order profile must start from the averages of the primitives.
#include "riemann/base/lane.hpp"
#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {

/// Cells are corrected where the differences to both neighbours stay below this share of rho, K and c.
inline constexpr double smooth_share = 0.05;

template <class E, Lane V>
void average(AverageArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V const rho = load<V>(g.rho + i), u = load<V>(g.u + i), p = load<V>(g.p + i), K = load<V>(g.K + i);
    V const h = load<V>(g.h + i), h_l = load<V>(g.h + i - 1), h_r = load<V>(g.h + i + 1);
    V share(0.5);
    if (!all(h == h_l && h == h_r)) share = 2.0 * h / (h_l + 2.0 * h + h_r);
    auto const sides = [&](double const* q, V centre, V& left, V& right) G27_INLINE_LAMBDA {
      left = centre - load<V>(q + i - 1), right = load<V>(q + i + 1) - centre;
    };
    V r_l, r_r, u_l, u_r, p_l, p_r;
    sides(g.rho, rho, r_l, r_r), sides(g.u, u, u_l, u_r), sides(g.p, p, p_l, p_r);
    V const most_u = max(abs(u_l), abs(u_r));
    Mask<V> const smooth = max(abs(r_l), abs(r_r)) <= smooth_share * rho &&
                           max(abs(p_l), abs(p_r)) <= smooth_share * K &&
                           most_u * most_u * rho <= (smooth_share * smooth_share) * K;
    V const d_rho = share * (r_l + r_r), d_u = share * (u_l + u_r), d_p = share * (p_l + p_r);
    V const bend = rho * d_u * d_u + eos.energy_bend(rho, d_rho, d_p);
    V const u_mean = u - d_rho * d_u / (12.0 * rho), p_mean = p - eos.gruneisen(rho) * bend * (1.0 / 24.0);
    store(g.dK_dp + i, V(2.0 * eos.fundamental_derivative(rho, p) - 1.0));
    store(g.u_mean + i, select(smooth, u_mean, u));
    store(g.p_mean + i, select(smooth, p_mean, p));
  }
}

}  // namespace g27
