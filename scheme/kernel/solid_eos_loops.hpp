#pragma once
/// What depends on a solid's equation of state: primitives of a row of cells, what a new state is worth.
#include "riemann/solid/law.hpp"
#include "scheme/kernel/solid_kernels.hpp"

namespace g27 {

template <SolidLaw E, Lane V>
void solid_primitive(SolidPrimitiveArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  namespace from = solid_conserved;
  namespace cell = solid_cell;
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    V const rho = load<V>(g.conserved[from::mass] + i), inv = 1.0 / rho;
    V e = load<V>(g.conserved[from::energy] + i) * inv;
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      V const u = load<V>(g.conserved[from::momentum + k] + i) * inv;
      e -= 0.5 * u * u;
      store(g.cell[cell::u + k] + i, u);
    });
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA {
      store(g.cell[cell::S + k] + i, V(load<V>(g.conserved[from::S + k] + i) * inv));
    });
    V const p = eos.pressure(rho, e);
    store(g.cell[cell::rho] + i, rho), store(g.cell[cell::p] + i, p), store(g.cell[cell::e] + i, e);
    store(g.cell[cell::ep] + i, V(load<V>(g.conserved[from::ep] + i) * inv));
    store(g.cell[cell::K] + i, eos.bulk_modulus(rho, p)), store(g.cell[cell::f] + i, V(eos.gruneisen(rho)));
  }
}

template <SolidLaw E, Lane V>
void solid_finish(SolidFinishArguments& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  namespace from = solid_conserved;
  V least(g.least), rate(g.rate);
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    V const rho = load<V>(g.conserved[from::mass] + i), inv = 1.0 / rho;
    V e = load<V>(g.conserved[from::energy] + i) * inv, u[3];
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      u[k] = load<V>(g.conserved[from::momentum + k] + i) * inv, e -= 0.5 * u[k] * u[k];
    });
    V const p = eos.pressure(rho, e), f = eos.gruneisen(rho), stiff = eos.bulk_modulus(rho, p) + 4.0 / 3.0 * g.mu;
    V sum(0.0), softest(stiff);
    unrolled<3>([&](auto a) G27_INLINE_LAMBDA {
      V const M = stiff - f * load<V>(g.conserved[from::S + a] + i) * inv;
      softest = min(softest, M);
      sum += (abs(u[a]) + sqrt(V(max(M, 0.0) * inv))) * g.inv_h[a];
    });
    V const share = rho / load<V>(g.rho_old + i);
    V const safe = select(softest > 0.0 && share > 0.0 && share < 1e300 && sum < 1e300, share, V(-1.0));
    if (i + width<V> <= g.cells) {
      least = min(least, safe), rate = max(rate, sum);
    } else {
      for (std::size_t k = 0; i + k < g.cells; ++k) {
        least = min(least, V(lane(safe, k))), rate = max(rate, V(lane(sum, k)));
      }
    }
  }
  g.least = lane_min(least), g.rate = lane_max(rate);
}

}  // namespace g27
