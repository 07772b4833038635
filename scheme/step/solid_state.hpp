#pragma once
/// States of a solid as cell averages, and back: what grids and lines share.
#include <array>

#include "riemann/solid/material.hpp"
#include "riemann/state/solid_point.hpp"
#include "scheme/kernel/solid_kernels.hpp"
#include "scheme/step/accumulator.hpp"
#include "scheme/step/solid_grid.hpp"

namespace g27 {

inline constexpr double least_density_share = 1e-2;  ///< of the old one, that a step may leave
inline constexpr double elastic_cfl = 0.8, plastic_cfl = 0.7;

/// Conserved densities in the order of solid_conserved.
using SolidVector = std::array<double, solid_conserved::fields>;

inline SolidVector vector_of(SolidDensities const& q) noexcept {
  return {q.mass,     q.momentum[0], q.momentum[1], q.momentum[2], q.energy,   q.rho_S[0],
          q.rho_S[1], q.rho_S[2],    q.rho_S[3],    q.rho_S[4],    q.rho_S[5], q.rho_ep};
}
inline SolidDensities densities_of(SolidVector const& q) noexcept {
  return {q[0], {q[1], q[2], q[3]}, q[4], {q[5], q[6], q[7], q[8], q[9], q[10]}, q[11]};
}

/// Specific internal energy [J/kg].
inline double internal_energy(SolidVector const& q) noexcept {
  return q[4] / q[0] - 0.5 * (q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) / (q[0] * q[0]);
}

SolidPoint primitive_of(AnySolidEos const& eos, SolidVector const& q) noexcept;
SolidVector conserved_of(AnySolidEos const& eos, SolidPoint const& s) noexcept;

/// One field of a state; `energy`: its specific internal energy.
double solid_field(SolidGrid::Field which, SolidPoint const& s, double energy) noexcept;

/// From sums of mass, momentum and energy: at the start, now, through the boundary, from sources; magnitudes then and
/// now.
SolidLedger solid_ledger(std::array<Accumulator, 5> const& initial, std::array<Accumulator, 5> const& total,
                         std::array<Accumulator, 5> const& boundary, std::array<Accumulator, 5> const& source,
                         std::array<double, 5> const& scale, std::array<double, 5> const& magnitude,
                         Accumulator const& plastic_work) noexcept;

}  // namespace g27
