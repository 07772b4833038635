#pragma once
/// The arrays of a row of gas cells and of its faces.
#include <cstddef>

#include "riemann/state/gas.hpp"
#include "scheme/grid/line.hpp"

namespace g27 {

/// Conserved averages and the primitives made from them; index -2 .. cells + 1, ghosts in the primitives only.
struct GasCells {
  Padded mass, momentum, energy, rho, u, p, K, margin;

  explicit GasCells(std::size_t n)
      : mass(n, 1.0), momentum(n, 0.0), energy(n, 1.0), rho(n, 1.0), u(n, 0.0), p(n, 1.0), K(n, 1.0), margin(n, 1.0) {}

  [[nodiscard]] GasState<> state(std::ptrdiff_t i) const noexcept { return {rho[i], u[i], p[i]}; }
  [[nodiscard]] GasConserved<> average(std::ptrdiff_t i) const noexcept { return {mass[i], momentum[i], energy[i]}; }
  void copy_primitives(std::ptrdiff_t to, GasCells const& from, std::ptrdiff_t i) noexcept {
    rho[to] = from.rho[i], u[to] = from.u[i], p[to] = from.p[i], K[to] = from.K[i], margin[to] = from.margin[i];
  }
  void copy_cell(std::ptrdiff_t to, GasCells const& from, std::ptrdiff_t i) noexcept {
    mass[to] = from.mass[i], momentum[to] = from.momentum[i], energy[to] = from.energy[i];
    copy_primitives(to, from, i);
  }
};

/// Fluxes per area through the moving faces, the pressure and velocity there, the fields switched.
struct GasFaces {
  Padded mass, momentum, energy, p, u, rho, switched;

  explicit GasFaces(std::size_t n) : mass(n), momentum(n), energy(n), p(n), u(n), rho(n), switched(n) {}
  void copy_face(std::ptrdiff_t to, GasFaces const& from, std::ptrdiff_t f) noexcept {
    mass[to] = from.mass[f], momentum[to] = from.momentum[f], energy[to] = from.energy[f];
    p[to] = from.p[f], u[to] = from.u[f], rho[to] = from.rho[f], switched[to] = from.switched[f];
  }
};

/// A face's Riemann problem, as the predictor leaves it and the solver takes it, for a chunk of faces.
struct FaceProblems {
  Padded l_rho, l_u, l_p, r_rho, r_u, r_p, s_rho, s_u, s_p, d_rho, d_u, d_p, switched, strong;

  explicit FaceProblems(std::size_t n)
      : l_rho(n),
        l_u(n),
        l_p(n),
        r_rho(n),
        r_u(n),
        r_p(n),
        s_rho(n),
        s_u(n),
        s_p(n),
        d_rho(n),
        d_u(n),
        d_p(n),
        switched(n),
        strong(n) {}
};

/// What a predictor reads of a row, by the cell on the left of its first face and by that face.
struct PredictorRow {
  double const *rho, *u, *p, *K, *dK_dp, *h, *inv_pair, *inv_triple, *w, *inc_rho, *inc_u, *inc_p, *foot_shift,
      *foot_factor;
};

/// A row of one face, for the problem beside a left wall seen in the mirror: walls on both sides then compute the same.
struct MirrorRow {
  Padded rho{4, 1.0}, u{4}, p{4, 1.0}, K{4, 1.0}, dK_dp{4}, h{4, 1.0}, inv_pair{4, 1.0}, inv_triple{4, 1.0}, w{4},
      inc_rho{4}, inc_u{4}, inc_p{4};
  Padded foot_shift{4}, foot_factor{4, 1.0};

  [[nodiscard]] PredictorRow row() const noexcept {
    return {.rho = rho.data(),
            .u = u.data(),
            .p = p.data(),
            .K = K.data(),
            .dK_dp = dK_dp.data(),
            .h = h.data(),
            .inv_pair = inv_pair.data(),
            .inv_triple = inv_triple.data(),
            .w = w.data(),
            .inc_rho = inc_rho.data(),
            .inc_u = inc_u.data(),
            .inc_p = inc_p.data(),
            .foot_shift = foot_shift.data(),
            .foot_factor = foot_factor.data()};
  }
};

}  // namespace g27
