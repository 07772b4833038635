#pragma once
/// The end of a solid line at a contact: its cells, seen from there, and the state extrapolated to it.
#include "scheme/kernel/solid_boundary_loop.hpp"
#include "scheme/step/solid_line_impl.hpp"

namespace g27 {

struct SolidLine::Impl::End {
  std::ptrdiff_t edge;  ///< the cell there
  RidingCells around;
  SolidBoundaryArguments g;
  SolidFrameRows q, term_rows;
  SolidFrameRows const* terms;  ///< none without curvature
  BoundaryState<double> at;

  End(Impl& line, bool low, double dt)
      : edge(low ? 0 : line.cells() - 1),
        around(line.cells_at_end(low)),
        g(line.boundary_arguments(low, dt, around)),
        q(g.cells, 0, solid_cell::fields),
        term_rows(line.term.rows(), 0, solid_cell::terms),
        terms(line.hoops > 0 ? &term_rows : nullptr),
        at(extrapolated_state<RidingCells, double>(g, around, q, edge)) {}
  End(End const&) = delete;
  End& operator=(End const&) = delete;

  template <class W>
  [[nodiscard]] Outgoing<double> outgoing(W const& w) const noexcept {
    return g27::outgoing(g, around, w, q, terms, at.state, edge);
  }
};

}  // namespace g27
