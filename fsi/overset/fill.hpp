#pragma once
/// States of the cells of a medium that neither its grid's scheme nor a local grid has computed.
#include <vector>

#include "fsi/overset/body.hpp"

namespace g27 {

/// Cells in the grid's numbers, with the states that they take.
template <class Fields>
struct FilledCells {
  std::vector<Int3> cells;
  std::vector<Fields> states;
};

/// Within `around` cells of the bodies: cells of the medium that were not deep before take their states from their
/// donors (with `started` they have them already), those beside the medium are continued, and the rest is `still` where
/// `computed` says that the grid reads or steps the cell.
template <class Fields, class Computed>
FilledCells<Fields> fill(Region<Fields>& region, bool started, Fields const& still, int around,
                         Computed const& computed, int threads) {
  using From = typename Donors<Fields>::From;
  CellKinds const& kinds = region.kinds;
  FilledCells<Fields> out;
  std::vector<std::size_t> wanted, fringe;
  kinds.for_each_near(around, [&](std::size_t i) {
    if (kinds.is_image(i)) return;
    if (kinds.valid(i)) {
      if (!started && kinds.kind_before(i) != CellKind::deep) wanted.push_back(i);
    } else if (kinds.fringe(i)) {
      fringe.push_back(i);
    } else if (Int3 const c = kinds.in_grid(kinds.cell(i)); computed(c)) {
      out.cells.push_back(c), out.states.push_back(still);
    }
  });
  // from donors, or what `otherwise` has of the cell
  auto const take = [&](std::vector<std::size_t> const& cells, From from, auto const& otherwise) {
    std::size_t const first = out.states.size();
    out.cells.resize(first + cells.size()), out.states.resize(first + cells.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 32)
    for (std::size_t n = 0; n < cells.size(); ++n) {
      Int3 const cell = kinds.cell(cells[n]);
      out.cells[first + n] = kinds.in_grid(cell);
      out.states[first + n] = region.donors.at(kinds.centre(cell), from, otherwise(cells[n]));
    }
    return first;
  };
  std::size_t const first =
      take(wanted, From::own_update, [&](std::size_t i) -> Fields const& { return region.states[i]; });
  for (std::size_t n = 0; n < wanted.size(); ++n) region.states[wanted[n]] = out.states[first + n];
  region.update(threads);
  take(fringe, From::valid, [&](std::size_t) -> Fields const& { return still; });
  return out;
}

}  // namespace g27
