#pragma once
/// Tangential velocities on a row of faces, and what they add to the fluxes.
#include "scheme/kernel/grid_kernels.hpp"
#include "scheme/predictor/tangential.hpp"

namespace g27 {

/// Upwind by the mass flux: the side from which the gas comes.
template <Lane V>
G27_INLINE V carried(V mass, V left, V right) noexcept {
  return select(mass >= 0.0, left, right);
}

template <class Kind, int fields, Lane V>
G27_INLINE void tangential_fields(TangentialArguments const& g) noexcept {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces), s = g.stride;
  // lengths in units of two cells
  V const h(0.5), pair(1.0), triple(1.0 / 1.5), dt(0.5 * g.dt / g.h);
  ContactPath<V> path{};
  path.mesh.h_a = path.mesh.h_b = h;
  path.mesh.pair_za = path.mesh.pair_ab = path.mesh.pair_by = pair;
  path.mesh.triple_a = path.mesh.triple_b = triple;
  path.mesh.uniform = true;
  for (std::ptrdiff_t f = 0; f < n; f += static_cast<std::ptrdiff_t>(width<V>)) {
    V const u_a = load<V>(g.u + f), u_b = load<V>(g.u + f + s), d_u = u_b - u_a;
    path.speed = 0.5 * (u_a + u_b);
    path.l = Kind::swept(d_u, dt, pair, path.speed);
    path.K = load<V>(g.K + f) + load<V>(g.K + f + s), path.rho = load<V>(g.rho + f) + load<V>(g.rho + f + s);
    V const mass = load<V>(g.f_mass + f);
    V energy = load<V>(g.f_energy + f);
    unrolled<fields>([&](auto k) G27_INLINE_LAMBDA {
      double const* const q = g.velocity[k];
      V const z = load<V>(q + f - s), a = load<V>(q + f), b = load<V>(q + f + s), y = load<V>(q + f + 2 * s);
      TwoSides<V> t;
      if constexpr (Kind::needs_pressure) {
        V const p_z = load<V>(g.p + f - s), p_a = load<V>(g.p + f), p_b = load<V>(g.p + f + s);
        V const p_y = load<V>(g.p + f + 2 * s);
        V const phi = switch_value<Switch::literal>(path.mesh, V(p_a - p_z), V(p_b - p_a), V(p_y - p_b),
                                                    path.speed > 0.0, V(1.0));
        t = Kind::at_foot(path, a, V(b - a), b, phi);
      } else {
        t = Kind::sides(path, z, a, b, y);
      }
      if (g.increment[k] != nullptr) {
        t.left += load<V>(g.increment[k] + f), t.right += load<V>(g.next[k] + f);
      }
      V const v = carried(mass, t.left, t.right);
      store(g.f_velocity[k] + f, V(mass * v));
      energy += 0.5 * mass * v * v;
    });
    store(g.f_energy + f, energy);
  }
}

template <class Kind, Lane V>
void tangential(TangentialArguments const& g) noexcept {
  if (g.fields == 1) {
    tangential_fields<Kind, 1, V>(g);
  } else {
    tangential_fields<Kind, 2, V>(g);
  }
}

template <Lane V>
void upwind(UpwindArguments const& g) noexcept {
  for (std::size_t f = 0; f < g.faces; f += width<V>) {
    V const mass = load<V>(g.f_mass + f);
    V energy = load<V>(g.f_energy + f);
    for (std::size_t k = 0; k < g.fields; ++k) {
      V const v = carried(mass, load<V>(g.left[k] + f), load<V>(g.right[k] + f));
      store(g.f_velocity[k] + f, V(mass * v));
      energy += 0.5 * mass * v * v;
    }
    store(g.f_energy + f, energy);
  }
}

}  // namespace g27
