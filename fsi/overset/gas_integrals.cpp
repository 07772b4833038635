#include "fsi/overset/gas_integrals.hpp"

#include "fsi/overset/body_integrals.hpp"
#include "fsi/overset/cut_cells.hpp"
#include "scheme/grid/cell_place.hpp"

namespace g27 {

namespace {

/// A cell near bodies: the window that speaks for it, and its part outside of them.
struct NearCell {
  Body const* body;
  Int3 cell;     ///< in the grid
  double share;  ///< outside
  Vec3 centre;   ///< of that part [m]
};

/// Each cell that is partly within bodies, once. Parts of cut cells within the bodies are scaled, so that they and the
/// whole cells add up to the polyhedra's volume.
std::vector<NearCell> near_cells(OversetSolver const& solver, int rays) {
  Int3 const n = solver.gas().cells();
  std::vector<bool> seen(solver.bodies().size() > 1 ? cells_in(n) : 0);
  std::vector<NearCell> out;
  std::vector<Vec3> moments;
  double whole = 0, cut = 0, volume = 0;
  for (auto const& body : solver.bodies()) {
    volume += enclosed(*body).volume;
    CellKinds const& kinds = body->gas.kinds;
    for (CellPart const& part : parts_within(kinds, rays)) {
      std::size_t const i = part.cell;
      if (kinds.is_image(i)) continue;
      Int3 const cell = kinds.in_grid(kinds.cell(i));
      if (!seen.empty()) {
        std::size_t const at = cell_number(n, cell);
        if (seen[at]) continue;
        seen[at] = true;
      }
      bool const is_cut = kinds.kind(i) == CellKind::cut;
      double const inside = is_cut ? part.share : kinds.valid(i) ? 0.0 : 1.0;
      (is_cut ? cut : whole) += inside;
      out.push_back({body.get(), cell, 1 - inside, kinds.centre(kinds.cell(i))});
      moments.push_back(part.moment);
    }
  }
  double const h = solver.gas().widths()[0], scale = cut > 0 ? (volume / (h * h * h) - whole) / cut : 1.0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    NearCell& c = out[i];
    if (!(c.share > 0 && c.share < 1)) continue;
    c.centre = (1 / c.share) * (c.centre - moments[i]);
    c.share = std::max(0.0, 1 - scale * (1 - c.share));
  }
  return out;
}

void add(double v, Vec3 const& x, GasDensities const& q, GasIntegrals& to) {
  to.volume += v, to.mass += v * q.mass, to.energy += v * q.energy;
  Vec3 const momentum = v * q.momentum;
  to.momentum = to.momentum + momentum, to.angular = to.angular + cross(x, momentum);
}

}  // namespace

std::vector<double> gas_share(OversetSolver const& solver, int rays) {
  Int3 const n = solver.gas().cells();
  std::vector<double> out(cells_in(n), 1.0);
  for (NearCell const& c : near_cells(solver, rays)) out[cell_number(n, c.cell)] = c.share;
  return out;
}

GasIntegrals gas_integrals(OversetSolver const& solver, int rays) {
  GasGrid const& gas = solver.gas();
  Vec3 const h = gas.widths();
  double const volume = h[0] * h[1] * h[2];
  Int3 const n = gas.cells();
  // a layer of cells each, so that the threads do not decide the order of a sum
  std::vector<GasIntegrals> layers(static_cast<std::size_t>(n[2]));
#pragma omp parallel for num_threads(gas.setup().options.threads) schedule(dynamic, 1)
  for (int k = 0; k < n[2]; ++k) {
    GasIntegrals layer;
    for_each_cell({n[0], n[1], 1}, [&](Int3 const& at) {
      Int3 const cell{at[0], at[1], k};
      add(volume, gas.centre(cell), gas.average(cell), layer);
    });
    layers[static_cast<std::size_t>(k)] = layer;
  }
  GasIntegrals out;
  for (GasIntegrals const& layer : layers) {
    out.volume += layer.volume, out.mass += layer.mass, out.energy += layer.energy;
    out.momentum = out.momentum + layer.momentum, out.angular = out.angular + layer.angular;
  }
  for (NearCell const& c : near_cells(solver, rays)) {
    if (c.share == 1) continue;
    add(-volume, gas.centre(c.cell), gas.average(c.cell), out);
    if (!(c.share > 0)) continue;
    GasFields const q = c.body->gas.donors.at(c.centre, Donors<GasFields>::From::valid, c.body->ambient);
    add(c.share * volume, c.centre, densities_of(gas.setup().eos, q), out);
  }
  return out;
}

}  // namespace g27
