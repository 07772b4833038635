#pragma once
/// MUSCL-Hancock in two and three dimensions, for comparison: edges of a row of cells after the half step with the
/// slopes of all axes.
#include "scheme/kernel/grid_kernels.hpp"
#include "scheme/predictor/muscl.hpp"

namespace g27 {

template <int dims, Lane V>
void grid_muscl(GridMusclArguments const& g) noexcept {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V const rho = load<V>(g.primitive.first + i), p = load<V>(g.primitive.last + i), K = load<V>(g.K + i);
    V const inv_rho = 1.0 / rho;
    V u[dims], d_rho[dims], d_p[dims], d_u[dims][dims];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) u[a] = load<V>(g.primitive.vector[a] + i);
    V half_rho = rho, half_p = p, half_u[dims];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) half_u[a] = u[a];
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) {
      std::ptrdiff_t const s = g.stride[static_cast<std::size_t>(a)];
      V const k(g.half_dt_over_h[static_cast<std::size_t>(a)]);
      auto const slope = [&](double const* q, V centre) G27_INLINE_LAMBDA {
        return van_leer(V(centre - load<V>(q + i - s)), V(load<V>(q + i + s) - centre));
      };
      d_rho[a] = slope(g.primitive.first, rho), d_p[a] = slope(g.primitive.last, p);
#pragma GCC unroll 3
      for (int c = 0; c < dims; ++c) d_u[a][c] = slope(g.primitive.vector[c], u[c]);
      V const v = k * u[a], spread = k * d_u[a][a];
      half_rho -= v * d_rho[a] + rho * spread;
      half_p -= v * d_p[a] + K * spread;
#pragma GCC unroll 3
      for (int c = 0; c < dims; ++c) half_u[c] -= v * d_u[a][c];
      half_u[a] -= k * d_p[a] * inv_rho;
    }
#pragma GCC unroll 3
    for (int a = 0; a < dims; ++a) {
      auto const edge = [&](RowOut const& out, double half) G27_INLINE_LAMBDA {
        if (out.first == nullptr) return;
        store(out.first + i, V(half_rho + half * d_rho[a])), store(out.last + i, V(half_p + half * d_p[a]));
#pragma GCC unroll 3
        for (int c = 0; c < dims; ++c) store(out.vector[c] + i, V(half_u[c] + half * d_u[a][c]));
      };
      edge(g.lower[static_cast<std::size_t>(a)], -0.5), edge(g.upper[static_cast<std::size_t>(a)], 0.5);
    }
  }
}

}  // namespace g27
