#pragma once
/// States of the cells of a medium that neither its grid's scheme nor a local grid has computed.
#include <vector>

#include "fsi/overset/body.hpp"

namespace g27 {

/// Within `around` cells of the bodies: cells of the medium that were not deep before take their states from their
/// donors (with `started` they have them already), those beside the medium are continued, and the rest is `still` where
/// `computed` says that the grid reads or steps the cell. Appends to `cells` in the grid's numbers and calls put(state)
/// for each.
template <class Fields, class Computed, class Put>
void fill(Region<Fields>& region, bool started, Fields const& still, int around, Computed const& computed,
          std::vector<Int3>& cells, Put const& put, int threads) {
  using From = typename Donors<Fields>::From;
  CellKinds const& kinds = region.kinds;
  std::vector<std::size_t> wanted, fringe;
  kinds.for_each_near(around, [&](std::size_t i) {
    if (kinds.is_image(i)) return;
    if (kinds.valid(i)) {
      if (!started && kinds.kind_before(i) != CellKind::deep) wanted.push_back(i);
    } else if (kinds.fringe(i)) {
      fringe.push_back(i);
    } else if (Int3 const c = kinds.in_grid(kinds.cell(i)); computed(c)) {
      cells.push_back(c), put(still);
    }
  });
  std::vector<Fields> filled(wanted.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 32)
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    filled[n] = region.donors.at(kinds.centre(kinds.cell(wanted[n])), From::own_update, region.states[wanted[n]]);
  }
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    region.states[wanted[n]] = filled[n];
    cells.push_back(kinds.in_grid(kinds.cell(wanted[n]))), put(filled[n]);
  }
  region.update();
  filled.resize(fringe.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 32)
  for (std::size_t n = 0; n < fringe.size(); ++n) {
    filled[n] = region.donors.at(kinds.centre(kinds.cell(fringe[n])), From::valid, still);
  }
  for (std::size_t n = 0; n < fringe.size(); ++n) cells.push_back(kinds.in_grid(kinds.cell(fringe[n]))), put(filled[n]);
}

}  // namespace g27
