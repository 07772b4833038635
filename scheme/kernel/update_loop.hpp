#pragma once
/// The corrector and the primitive variables of the new state, in one pass over the cells.
#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {

template <class E, Lane V>
struct Primitives {
  V rho, inv_rho, u, p, K, margin;
};

template <class E, Lane V>
G27_INLINE Primitives<E, V> primitives_of(E const& eos, V mass, V momentum, V energy) noexcept {
  V const inv = 1.0 / mass, u = momentum * inv, e = energy * inv - 0.5 * u * u;
  V const p = eos.pressure(mass, e);
  return {mass, inv, u, p, eos.bulk_modulus(mass, p), eos.pressure_margin(mass, p)};
}

template <class E, Lane V>
G27_INLINE void store_primitives(Primitives<E, V> const& s, double* rho, double* u, double* p, double* K,
                                 double* margin, std::size_t i) noexcept {
  store(rho + i, s.rho), store(u + i, s.u), store(p + i, s.p), store(K + i, s.K), store(margin + i, s.margin);
}

template <class E, Lane V>
void primitive(PrimitiveArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    store_primitives(primitives_of<E, V>(eos, load<V>(g.mass + i), load<V>(g.momentum + i), load<V>(g.energy + i)),
                     g.rho, g.u, g.p, g.K, g.margin, i);
  }
}

/// Least of rho/rho_old and margin/margin_old; -1 where it is no number > 0. Where both are above a tenth: 1.
template <Lane V>
G27_INLINE V share_left(V rho, V rho_old, V margin, V margin_old) noexcept {
  if (all(rho > 0.1 * rho_old && margin > 0.1 * margin_old && rho < 1e300 && margin < 1e300)) return V(1.0);
  V const share = min(rho / rho_old, margin / margin_old);
  return select(share > 0.0 && share < 1e300, share, V(-1.0));
}

template <bool plain, class E, Lane V>
void update_row(UpdateArguments& g, E const& eos) noexcept {
  V worst(1.0), rate(0.0);
  for (std::size_t i = 0; i < g.cells; i += width<V>) {
    auto const flux_difference = [&](double const* f) G27_INLINE_LAMBDA {
      if constexpr (plain) {
        return V(load<V>(f + i + 1) - load<V>(f + i));
      } else {
        if (g.area == nullptr) return V(load<V>(f + i + 1) - load<V>(f + i));
        return V(load<V>(g.area + i + 1) * load<V>(f + i + 1) - load<V>(g.area + i) * load<V>(f + i));
      }
    };
    V mass = load<V>(g.mass + i), momentum = load<V>(g.momentum + i), energy = load<V>(g.energy + i);
    if constexpr (plain) {
      V const lambda(g.lambda);
      mass -= lambda * flux_difference(g.f_mass);
      momentum -= lambda * flux_difference(g.f_momentum);
      energy -= lambda * flux_difference(g.f_energy);
    } else {
      V const dt(g.dt), measure = load<V>(g.measure + i), inv_new = load<V>(g.inv_measure_new + i);
      V push = flux_difference(g.f_momentum);
      if (g.area != nullptr) {
        // the pressure on the sides of a shell: with the two pressures' mean it is exactly zero in a gas at rest
        V const p_l = load<V>(g.face_p + i), p_r = load<V>(g.face_p + i + 1);
        V const a_l = load<V>(g.area + i), a_r = load<V>(g.area + i + 1);
        push = a_r * (load<V>(g.f_momentum + i + 1) - p_r) - a_l * (load<V>(g.f_momentum + i) - p_l) +
               0.5 * (a_l + a_r) * (p_r - p_l);
      }
      V new_mass = measure * mass - dt * flux_difference(g.f_mass);
      V new_momentum = measure * momentum - dt * push;
      V new_energy = measure * energy - dt * flux_difference(g.f_energy);
      if (g.src_mass != nullptr) {
        new_mass += load<V>(g.src_mass + i);
        new_momentum += load<V>(g.src_momentum + i);
        new_energy += load<V>(g.src_energy + i);
      }
      mass = new_mass * inv_new, momentum = new_momentum * inv_new, energy = new_energy * inv_new;
    }
    store(g.mass_new + i, mass), store(g.momentum_new + i, momentum), store(g.energy_new + i, energy);
    Primitives<E, V> const s = primitives_of<E, V>(eos, mass, momentum, energy);
    V const rho_old = load<V>(g.rho_old + i), margin_old = load<V>(g.margin_old + i);
    store_primitives(s, g.rho, g.u, g.p, g.K, g.margin, i);
    V const safe = share_left(s.rho, rho_old, s.margin, margin_old);
    V const inv_h = plain ? V(g.inv_width) : load<V>(g.inv_h + i);
    V const speed = (abs(s.u) + sqrt(V(s.K * s.inv_rho))) * inv_h;
    if (i + width<V> <= g.cells) {
      worst = min(worst, safe), rate = max(rate, speed);
    } else {
      for (std::size_t k = 0; i + k < g.cells; ++k) {
        worst = min(worst, V(lane(safe, k))), rate = max(rate, V(lane(speed, k)));
      }
    }
  }
  g.worst = lane_min(worst), g.rate = lane_max(rate);
}

template <class E, Lane V>
void update(UpdateArguments& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  if (g.measure == nullptr) {
    update_row<true, E, V>(g, eos);
  } else {
    update_row<false, E, V>(g, eos);
  }
}

}  // namespace g27
