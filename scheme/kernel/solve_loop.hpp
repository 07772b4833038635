#pragma once
/// Solves the Riemann problems that the predictor left, then turns the state on every face into fluxes.
#include "riemann/gas/exact.hpp"
#include "riemann/gas/exact_ideal.hpp"
#include "riemann/gas/exact_jwl.hpp"
#include "riemann/gas/hllc.hpp"
#include "scheme/kernel/flux.hpp"
#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {

/// A predicted side whose density or pressure margin is below this share of its cell's takes the cell state.
inline constexpr double least_side_share = 0.05;

template <class E, class V>
concept HasFastSolver = requires(E const& eos, GasState<V> const& s, Mask<V> m) {
  fast_face(eos, s, s, m);
};

/// The solver of the EOS: its own where it has one, else the general one.
template <RiemannSolver solver, class E, Lane V>
G27_INLINE FaceSolution<V> solve_face(E const& eos, GasState<V> const& l, GasState<V> const& r,
                                      Mask<V> active) noexcept {
  if constexpr (solver == RiemannSolver::fast && HasFastSolver<E, V>) {
    return fast_face(eos, l, r, active);
  } else {
    return exact_face(eos, eos, l, r, active);
  }
}

template <Lane V>
G27_INLINE V gather(double const* p, std::size_t const* index) noexcept {
  if constexpr (std::same_as<V, double>) {
    return p[index[0]];
  } else {
    return V([&](auto i) { return p[index[i]]; });
  }
}
template <Lane V>
G27_INLINE void scatter(double* p, std::size_t const* index, V v, std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) p[index[i]] = lane(v, i);
}

/// in: side state predicted, cell it came from. The cell state replaces a side that is hardly admissible.
template <class E, Lane V>
G27_INLINE GasState<V> guarded(E const& eos, GasState<V> s, GasState<V> const& cell, V cell_margin) noexcept {
  Mask<V> const ok =
      s.rho > least_side_share * cell.rho && eos.pressure_margin(s.rho, s.p) > least_side_share * cell_margin;
  return {select(ok, s.rho, cell.rho), select(ok, s.u, cell.u), select(ok, s.p, cell.p)};
}

/// Solves the faces with strong != 0 and writes their states over the star states.
template <RiemannSolver solver, class E, Lane V>
void solve_strong(SolveArguments& g, E const& eos) noexcept {
  constexpr std::size_t W = width<V>;
  std::size_t index[W];
  std::size_t held = 0;
  auto const flush = [&](std::size_t n) {
    for (std::size_t i = n; i < W; ++i) index[i] = index[n - 1];
    auto const cell = [&](std::ptrdiff_t side) {
      return GasState<V>{gather<V>(g.rho + side, index), gather<V>(g.u + side, index), gather<V>(g.p + side, index)};
    };
    V const w = gather<V>(g.w, index);
    GasState<V> l{gather<V>(g.l_rho, index), gather<V>(g.l_u, index), gather<V>(g.l_p, index)};
    GasState<V> r{gather<V>(g.r_rho, index), gather<V>(g.r_u, index), gather<V>(g.r_p, index)};
    l = guarded(eos, l, cell(0), gather<V>(g.margin, index));
    r = guarded(eos, r, cell(g.stride), gather<V>(g.margin + g.stride, index));
    l.u -= w, r.u -= w;
    FaceSolution<V> const s = solve_face<solver>(eos, l, r, Mask<V>(true));
    if (!all(s.converged)) {
      for (std::size_t i = 0; i < n; ++i) g.failures += lane(select(s.converged, V(0.0), V(1.0)), i) > 0.5 ? 1u : 0u;
    }
    scatter(g.s_rho, index, s.face.rho, n);
    scatter(g.s_u, index, V((g.lagrangian ? s.u_star : s.face.u) + w), n);
    scatter(g.s_p, index, g.lagrangian ? s.p_star : s.face.p, n);
  };
  for (std::size_t f = 0; f < g.faces; f += W) {
    if (!any(load<V>(g.strong + f) > 0.5)) continue;
    std::size_t const end = f + W < g.faces ? f + W : g.faces;
    for (std::size_t i = f; i < end; ++i) {
      if (g.strong[i] < 0.5) continue;
      index[held++] = i;
      if (held == W) flush(W), held = 0;
    }
  }
  if (held > 0) flush(held);
}

/// Fluxes of the face states; where a predictor gave the change over the step, averaged over it.
template <class E, Lane V>
void fluxes_of_states(SolveArguments& g, E const& eos) noexcept {
  // in a vacuum nothing flows, but its energy per mass must not be 0/0
  auto const energy_density = [&](V rho, V p) G27_INLINE_LAMBDA { return eos.energy_density(max(rho, V(1e-200)), p); };
  for (std::size_t f = 0; f < g.faces; f += width<V>) {
    Mask<V> const strong = load<V>(g.strong + f) > 0.5;
    bool const wanted = !g.weak_done || any(strong);
    if (!wanted && g.face_p == nullptr) continue;
    GasState<V> const s{load<V>(g.s_rho + f), load<V>(g.s_u + f), load<V>(g.s_p + f)};
    if (g.face_p != nullptr) store(g.face_p + f, s.p), store(g.face_u + f, s.u);
    if (!wanted) continue;
    V const w = load<V>(g.w + f);
    GasConserved<V> q;
    if (g.lagrangian) {
      q = {V(0.0), s.p, V(s.p * s.u)};
    } else if (g.d_rho == nullptr) {
      q = flux_of(s.rho, s.u, s.p, energy_density(s.rho, s.p), w);
    } else {
      q = mean_flux(s, {load<V>(g.d_rho + f), load<V>(g.d_u + f), load<V>(g.d_p + f)}, w, energy_density);
    }
    if (g.weak_done) {
      q = {select(strong, q.mass, load<V>(g.f_mass + f)), select(strong, q.momentum, load<V>(g.f_momentum + f)),
           select(strong, q.energy, load<V>(g.f_energy + f))};
    }
    store(g.f_mass + f, q.mass), store(g.f_momentum + f, q.momentum), store(g.f_energy + f, q.energy);
  }
}

/// HLLC gives fluxes, not states: in the frame of the face, then carried to the laboratory frame.
template <class E, Lane V>
void fluxes_hllc(SolveArguments& g, E const& eos) noexcept {
  for (std::size_t f = 0; f < g.faces; f += width<V>) {
    V const w = load<V>(g.w + f);
    auto const cell = [&](std::ptrdiff_t i) {
      return GasState<V>{load<V>(g.rho + i), load<V>(g.u + i), load<V>(g.p + i)};
    };
    GasState<V> l{load<V>(g.l_rho + f), load<V>(g.l_u + f), load<V>(g.l_p + f)};
    GasState<V> r{load<V>(g.r_rho + f), load<V>(g.r_u + f), load<V>(g.r_p + f)};
    std::ptrdiff_t const c = static_cast<std::ptrdiff_t>(f);
    l = guarded(eos, l, cell(c), load<V>(g.margin + c));
    r = guarded(eos, r, cell(c + g.stride), load<V>(g.margin + c + g.stride));
    l.u -= w, r.u -= w;
    GasConserved<V> const q = hllc_flux(eos, l, r);
    store(g.f_mass + f, q.mass);
    store(g.f_momentum + f, V(q.momentum + w * q.mass));
    store(g.f_energy + f, V(q.energy + w * q.momentum + 0.5 * w * w * q.mass));
    if (g.face_p == nullptr) continue;
    // pressure and velocity of the contact, linearised: for the geometric terms and the histories
    V const z_l = sqrt(eos.bulk_modulus(l.rho, l.p) * l.rho), z_r = sqrt(eos.bulk_modulus(r.rho, r.p) * r.rho);
    V const inv = 1.0 / (z_l + z_r);
    store(g.face_p + f, V((z_r * l.p + z_l * r.p - z_l * z_r * (r.u - l.u)) * inv));
    store(g.face_u + f, V((z_l * l.u + z_r * r.u - (r.p - l.p)) * inv + w));
  }
}

template <RiemannSolver solver, class E, Lane V>
void solve(SolveArguments& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  g.failures = 0;
  if constexpr (solver == RiemannSolver::hllc) {
    fluxes_hllc<E, V>(g, eos);
  } else {
    solve_strong<solver, E, V>(g, eos);
    fluxes_of_states<E, V>(g, eos);
  }
}

}  // namespace g27
