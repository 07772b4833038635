#include "fsi/overset/gas_integrals.hpp"

#include "fsi/overset/cut_cells.hpp"

namespace g27 {

namespace {

/// A cell near bodies: the window that speaks for it, and its part outside of them.
struct NearCell {
  Body const* body;
  Int3 cell;     ///< in the grid
  double share;  ///< outside
  Vec3 centre;   ///< of that part [m]
};

/// Calls f with each cell of the bodies' windows, once.
template <class F>
void for_each_near_cell(OversetSolver const& solver, int rays, F const& f) {
  Int3 const n = solver.gas().cells();
  auto const place = [&](Int3 const& c) {
    return static_cast<std::size_t>(c[0]) +
           static_cast<std::size_t>(n[0]) *
               (static_cast<std::size_t>(c[1]) + static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(c[2]));
  };
  std::vector<bool> seen(solver.bodies().size() > 1 ? place({0, 0, n[2]}) : 0);
  for (auto const& body : solver.bodies()) {
    CellKinds const& kinds = body->gas.kinds;
    auto const parts = parts_within(kinds, rays);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Int3 const cell = kinds.in_grid(kinds.cell(i));
      if (!seen.empty()) {
        if (seen[place(cell)]) continue;
        seen[place(cell)] = true;
      }
      Vec3 const centre = kinds.centre(kinds.cell(i));
      bool const cut = kinds.kind(i) == CellKind::cut;
      double const share = cut ? std::max(0.0, 1 - parts[i].share) : kinds.valid(i) ? 1.0 : 0.0;
      bool const divided = cut && share > 1e-6;
      f(NearCell{body.get(), cell, share, divided ? (1 / share) * (centre - parts[i].moment) : centre});
    }
  }
}

}  // namespace

std::vector<double> gas_share(OversetSolver const& solver, int rays) {
  Int3 const n = solver.gas().cells();
  auto const size = [&](std::size_t a) { return static_cast<std::size_t>(n[a]); };
  std::vector<double> out(size(0) * size(1) * size(2), 1.0);
  for_each_near_cell(solver, rays, [&](NearCell const& c) {
    out[static_cast<std::size_t>(c.cell[0]) +
        size(0) * (static_cast<std::size_t>(c.cell[1]) + size(1) * static_cast<std::size_t>(c.cell[2]))] = c.share;
  });
  return out;
}

GasIntegrals gas_integrals(OversetSolver const& solver, int rays) {
  GasGrid const& gas = solver.gas();
  Vec3 const h = gas.widths();
  double const volume = h[0] * h[1] * h[2];
  GasIntegrals out;
  auto const add = [&](double v, Vec3 const& x, GasDensities const& q) {
    out.volume += v, out.mass += v * q.mass, out.energy += v * q.energy;
    Vec3 const momentum = v * q.momentum;
    out.momentum = out.momentum + momentum, out.angular = out.angular + cross(x, momentum);
  };
  Int3 const n = gas.cells();
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) add(volume, gas.centre({i, j, k}), gas.average({i, j, k}));
    }
  }
  for_each_near_cell(solver, rays, [&](NearCell const& c) {
    if (c.share == 1) return;
    add(-volume, gas.centre(c.cell), gas.average(c.cell));
    if (!(c.share > 0)) return;
    GasFields const q = c.body->gas.donors.at(c.centre, Donors<GasFields>::From::valid, c.body->ambient);
    add(c.share * volume, c.centre, densities_of(gas.setup().eos, q));
  });
  return out;
}

}  // namespace g27
