#pragma once
/// What running a case is, whatever the medium of its grid.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "scheme/grid/cell_place.hpp"
#include "scheme/step/gas_grid.hpp"
#include "verification/cases/case.hpp"

namespace g27 {

/// Throws std::invalid_argument for a run that takes no step or never ends.
inline void require_end(double t_end) {
  if (!(t_end > 0 && std::isfinite(t_end))) {
    throw std::invalid_argument("with these parameters it would end at t = " + std::to_string(t_end) + " s");
  }
}

/// Of a grid; without overflow.
inline double count_of(Int3 const& cells) { return 1.0 * cells[0] * cells[1] * cells[2]; }

/// Steps while `more`, not beyond t_end, and calls `after` with the length of each step; throws when one fails, or when
/// there is no end: an unstable run stalls at ever smaller steps.
template <class Grid, class More, class After>
void advance(std::string const& name, Grid& grid, int cells, double t_end, More const& more, After const& after) {
  std::uint64_t const most = 100'000 + 1000 * static_cast<std::uint64_t>(cells);
  while (more()) {
    GridStepReport const step = grid.step(t_end);
    std::string const where = name + ": the step at t = " + std::to_string(grid.time());
    if (step.status != StepStatus::ok) {
      throw std::runtime_error(where + " failed in cell (" + std::to_string(step.cell[0]) + ", " +
                               std::to_string(step.cell[1]) + ", " + std::to_string(step.cell[2]) + ")");
    }
    if (grid.counters().steps > most) throw std::runtime_error(where + " is one too many");
    after(step.dt);
  }
}

/// The ledger of a case: of the momenta that of which most is unaccounted for.
template <class Ledger>
GasLedger case_ledger(Ledger const& ledger) {
  auto const less = [](LedgerEntry const& a, LedgerEntry const& b) {
    return std::fabs(a.residual()) < std::fabs(b.residual());
  };
  return {.mass = ledger.mass,
          .momentum = *std::max_element(ledger.momentum.begin(), ledger.momentum.end(), less),
          .energy = ledger.energy};
}

/// The error of the velocity from those of its components.
inline void combine_velocity(CaseResult& r) {
  Norms squares{};
  for (char const* name : {"velocity_x", "velocity_y", "velocity_z"}) {
    auto const found = r.errors.find(name);
    if (found == r.errors.end()) continue;
    Norms const& e = found->second;
    squares.l1 += e.l1 * e.l1, squares.l2 += e.l2 * e.l2, squares.linf += e.linf * e.linf;
  }
  r.errors["velocity"] = {std::sqrt(squares.l1), std::sqrt(squares.l2), std::sqrt(squares.linf)};
}

}  // namespace g27
