#pragma once
/// Ghost cells of a line: two on each side, set from the boundary conditions at the start of a step.
#include "scheme/step/gas_fields.hpp"
#include "scheme/step/gas_line.hpp"

namespace g27 {

/// A boundary that gas does not pass: a wall, fixed or moving.
inline bool is_wall(GasBoundary const& b) noexcept {
  return b.kind == GasBoundary::Kind::wall || b.kind == GasBoundary::Kind::piston;
}

inline bool is_contact(GasBoundary const& b) noexcept { return b.kind == GasBoundary::Kind::contact; }

/// Speed of the boundary itself at time t [m/s].
inline double boundary_speed(GasBoundary const& b, double t) {
  return b.kind == GasBoundary::Kind::piston ? b.velocity(t) : 0.0;
}

/// Fills the ghosts of `cells` at time t: copies (outflow), images in the wall, the partner (periodic), the given
/// state averaged over the ghost cell (inflow), or the gas continued linearly (contact).
void fill_ghosts(GasLineSetup const& setup, Line const& line, double t, GasCells& cells);

/// The same for averages of velocity and pressure and for dK/dp alone, whose inner cells are set; an inflow's state is
/// an average, its dK/dp that of the cell beside it.
void fill_mean_ghosts(GasLineSetup const& setup, Line const& line, GasCells const& cells, Padded& u, Padded& p,
                      Padded& dK_dp);

}  // namespace g27
