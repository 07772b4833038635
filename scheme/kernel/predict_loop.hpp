#pragma once
/// Loops over the faces of a row: gathers the stencil, calls the predictor, stores what the solver needs.
#include "scheme/kernel/flux.hpp"
#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/predictor/godunov.hpp"
#include "scheme/predictor/linear.hpp"
#include "scheme/predictor/muscl.hpp"
#include "scheme/predictor/parabolic.hpp"

namespace g27 {

template <Lane V>
G27_INLINE Cell<V> load_cell(PredictArguments const& g, std::ptrdiff_t i) noexcept {
  return {load<V>(g.rho + i), load<V>(g.u + i), load<V>(g.p + i), load<V>(g.K + i), V(0.0)};
}
template <Lane V>
G27_INLINE GasState<V> left_increment(PredictArguments const& g, std::ptrdiff_t i) noexcept {
  return {load<V>(g.inc_rho + i), load<V>(g.inc_u + i), load<V>(g.inc_p + i)};
}
template <Lane V>
G27_INLINE GasState<V> right_increment(PredictArguments const& g, std::ptrdiff_t i) noexcept {
  return {load<V>(g.next_rho + i), load<V>(g.next_u + i), load<V>(g.next_p + i)};
}

/// Stores one vector of predictions; the two sides only where a problem is left to solve.
template <bool third_order, Lane V>
G27_INLINE void store_prediction(PredictArguments const& g, std::size_t f, FacePrediction<V> const& r) noexcept {
  bool const solved = all(r.weak);
  store(g.switched + f, r.switched);
  store(g.strong + f, select(r.weak, V(0.0), V(1.0)));
  FluxesAtOnce const& o = g.at_once;
  if (o.mass != nullptr) {
    V const scale(o.per_pressure), zero(o.at_zero);
    auto const energy_density = [&](V, V p) G27_INLINE_LAMBDA { return V(p * scale + zero); };
    GasConserved<V> q;
    if constexpr (third_order) {
      q = mean_flux(r.star, r.change, V(0.0), energy_density);
    } else {
      q = flux_of(r.star.rho, r.star.u, r.star.p, energy_density(r.star.rho, r.star.p), V(0.0));
    }
    store(o.mass + f, q.mass), store(o.momentum + f, q.momentum), store(o.energy + f, q.energy);
  }
  if (o.mass == nullptr || g.at_once.keep_states || !solved) {
    store(g.s_rho + f, r.star.rho), store(g.s_u + f, r.star.u), store(g.s_p + f, r.star.p);
    if constexpr (third_order) {
      store(g.d_rho + f, r.change.rho), store(g.d_u + f, r.change.u), store(g.d_p + f, r.change.p);
    }
  }
  if (!solved) {
    store(g.l_rho + f, r.left.rho), store(g.l_u + f, r.left.u), store(g.l_p + f, r.left.p);
    store(g.r_rho + f, r.right.rho), store(g.r_u + f, r.right.u), store(g.r_p + f, r.right.p);
  }
}

template <class Predictor, bool uniform, bool cell_feet, Lane V>
void predict(PredictArguments const& g) noexcept {
  bool const increments = g.inc_rho != nullptr;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces);
  // Equal widths: lengths and times in units of two widths make every mesh factor a constant, and leave speeds alone.
  V const dt(uniform ? g.dt * g.inv_pair[0] : g.dt);
  V const h0(0.5), pair0(1.0), triple0(2.0 / 3.0);
  for (std::ptrdiff_t f = 0; f < n; f += static_cast<std::ptrdiff_t>(width<V>)) {
    Stencil<V> s{.z = load_cell<V>(g, f - g.stride),
                 .a = load_cell<V>(g, f),
                 .b = load_cell<V>(g, f + g.stride),
                 .y = load_cell<V>(g, f + 2 * g.stride),
                 .h_a = h0,
                 .h_b = h0,
                 .pair_za = pair0,
                 .pair_ab = pair0,
                 .pair_by = pair0,
                 .triple_a = triple0,
                 .triple_b = triple0,
                 .w = V(0.0),
                 .dt = dt,
                 .foot_shift = V(0.0),
                 .foot_factor = V(1.0),
                 .linear_star = g.linear_star,
                 .incremented = increments,
                 .own_increments = g.own_increments,
                 .inc_a = {},
                 .inc_b = {},
                 .uniform = uniform};
    if constexpr (!uniform) {
      s.h_a = load<V>(g.h + f), s.h_b = load<V>(g.h + f + 1);
      s.pair_za = load<V>(g.inv_pair + f - 1), s.pair_ab = load<V>(g.inv_pair + f);
      s.pair_by = load<V>(g.inv_pair + f + 1);
      s.triple_a = load<V>(g.inv_triple + f), s.triple_b = load<V>(g.inv_triple + f + 1);
      s.w = load<V>(g.w + f);
    }
    if constexpr (cell_feet) {
      s.foot_shift = load<V>(g.foot_shift + f), s.foot_factor = load<V>(g.foot_factor + f);
    }
    if (increments) s.inc_a = left_increment<V>(g, f), s.inc_b = right_increment<V>(g, f);
    if constexpr (Predictor::third_order) {
      s.a.dK_dp = load<V>(g.dK_dp + f), s.b.dK_dp = load<V>(g.dK_dp + f + g.stride);
    }
    store_prediction<Predictor::third_order>(g, static_cast<std::size_t>(f), Predictor::predict(s, g.exponent));
  }
}

/// Counts are small integers: their sums do not depend on the order.
template <Lane V>
void count(CountArguments& g) noexcept {
  V const one(1.0), zero(0.0);
  V switched(0.0), strong(0.0);
  std::size_t f = 0;
  for (; f + width<V> <= g.faces; f += width<V>) {
    V const acted = select(load<V>(g.switched + f) > 0.0, one, zero);
    store(g.map + f, V(load<V>(g.map + f) + acted));
    switched += acted, strong += load<V>(g.strong + f);
  }
  for (std::size_t i = 0; i < width<V>; ++i) g.faces_switched += lane(switched, i), g.faces_strong += lane(strong, i);
  for (; f < g.faces; ++f) {
    double const acted = g.switched[f] > 0.0 ? 1.0 : 0.0;
    g.map[f] += acted, g.faces_switched += acted, g.faces_strong += g.strong[f];
  }
}

/// MUSCL computes its edges once a cell: a pass over the cells, then one over the faces.
template <bool uniform, Lane V>
void predict_muscl(PredictArguments const& g) noexcept {
  bool const increments = g.inc_rho != nullptr;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces), step = static_cast<std::ptrdiff_t>(width<V>);
  V const h0(0.5), pair0(1.0), dt(uniform ? g.dt * g.inv_pair[0] : g.dt);  // as in `predict`
  // Cell c lies between the faces c - 1 and c: it writes the left state of face c and the right state of face c - 1.
  // The lanes that run past the row land in the padding.
  for (std::ptrdiff_t c = 0; c <= n; c += step) {
    V h = h0, pair_m = pair0, pair_p = pair0, w_l(0.0), w_r(0.0);
    if constexpr (!uniform) {
      h = load<V>(g.h + c), pair_m = load<V>(g.inv_pair + c - 1), pair_p = load<V>(g.inv_pair + c);
      w_r = load<V>(g.w + c), w_l = load<V>(g.w + c - 1);
    }
    GasState<V> inc{};
    if (increments) inc = left_increment<V>(g, c);
    CellEdges<V> const e = muscl_edges(load_cell<V>(g, c - 1), load_cell<V>(g, c), load_cell<V>(g, c + 1), pair_m,
                                       pair_p, h, dt, w_l, w_r, increments, inc);
    store(g.l_rho + c, e.right.rho), store(g.l_u + c, e.right.u), store(g.l_p + c, e.right.p);
    store(g.r_rho + c - 1, e.left.rho), store(g.r_u + c - 1, e.left.u), store(g.r_p + c - 1, e.left.p);
  }
  for (std::ptrdiff_t f = 0; f < n; f += step) {
    GasState<V> l{load<V>(g.l_rho + f), load<V>(g.l_u + f), load<V>(g.l_p + f)};
    GasState<V> r{load<V>(g.r_rho + f), load<V>(g.r_u + f), load<V>(g.r_p + f)};
    V w(0.0);
    if constexpr (!uniform) w = load<V>(g.w + f);
    V const K_a = load<V>(g.K + f), K_b = load<V>(g.K + f + 1);
    AcousticStar<V> const star = acoustic_star(l, r, 0.5 * (K_a + K_b), min(K_a, K_b), w);
    Mask<V> const weak = star.weak && Mask<V>(g.linear_star);
    store(g.s_rho + f, star.state.rho), store(g.s_u + f, star.state.u), store(g.s_p + f, star.state.p);
    store(g.switched + f, V(0.0));
    store(g.strong + f, select(weak, V(0.0), V(1.0)));
  }
}

}  // namespace g27
