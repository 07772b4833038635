#pragma once
/// Elastoplastic solids (Jaumann rate, von Mises, linear hardening) on Cartesian grids of one, two and three
/// dimensions, unsplit; an axis of one cell is not swept. All three velocities and all six stresses are there in any
/// dimension.
///
/// The scheme is that of the gas: characteristic families traced to their feet in the predictor, the linearised
/// Riemann problem on the faces (OG section 4), own-cell transverse terms, one conservative corrector; then the Jaumann
/// terms from the face velocities and the return to the yield surface. Results do not depend on the number of threads
/// nor on the tiles.
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "riemann/solid/material.hpp"
#include "scheme/step/gas_grid.hpp"
#include "scheme/step/solid_grid_options.hpp"

namespace g27 {

struct SolidGridSetup {
  AnySolid material{};
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};   ///< corners of the box [m]
  Int3 cells{1, 1, 1};                   ///< 1: that axis is not there; at least 4 else
  std::array<SolidBoundary, 6> sides{};  ///< in the order of Side
  SolidSource source{};
  SolidSchemeOptions options{};
};

class SolidGrid {
 public:
  /// Throws std::invalid_argument for a setup that makes no sense.
  explicit SolidGrid(SolidGridSetup setup);
  ~SolidGrid();
  SolidGrid(SolidGrid&&) noexcept;
  SolidGrid& operator=(SolidGrid&&) noexcept;

  /// Averages of the conserved variables by Gauss quadrature (`points` a direction) of the state at (x, t = 0). Called
  /// from the threads of the grid at once.
  void set_state(std::function<SolidPoint(Vec3 const& x)> const& state, int points = 3);
  /// Cell averages given by the centre and the widths of the cell, at time `time`.
  void set_averages(std::function<SolidDensities(Vec3 const& centre, Vec3 const& widths)> const& mean, double time = 0);
  /// The same by the cell's indices: to go on from stored averages.
  void set_cells(std::function<SolidDensities(Int3 const& cell)> const& mean, double time = 0);

  /// Other averages of some cells, between two steps: of those beside the body's surface, which other grids compute.
  /// The ledger does not count the change.
  void replace(std::span<Int3 const> cells, std::span<SolidDensities const> averages);

  /// From now on steps update the tiles that hold one of these cells, at a cost in proportion, and leave the others as
  /// they are: those are for the caller to replace. In the time step tiles left alone count by what is replaced from
  /// now on.
  void compute_only(std::span<Int3 const> cells);
  /// Whether steps update this cell.
  [[nodiscard]] bool computes(Int3 const& cell) const noexcept;

  /// One step, not beyond t_end; on failure the state is that before the step.
  GridStepReport step(double t_end);
  /// Time passes until t_end and nothing happens: the step of a uniform state at rest.
  void rest(double t_end) noexcept;

  [[nodiscard]] int dimensions() const noexcept;
  [[nodiscard]] Int3 cells() const noexcept;
  [[nodiscard]] std::size_t cell_count() const noexcept;
  [[nodiscard]] Vec3 widths() const noexcept;                  ///< of a cell [m]; 1 along axes that are not there
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;  ///< [m]; the lower corner along axes that are not there
  [[nodiscard]] double time() const noexcept;
  /// Time step that the CFL condition allows now [s].
  [[nodiscard]] double stable_dt() const noexcept;
  /// That the CFL condition goes by [1/s]; cells replaced since the last step count in it. With it, after set_cells(),
  /// the grid goes on bit by bit as that would have from which the averages come.
  [[nodiscard]] double signal_rate() const noexcept;
  void set_signal_rate(double rate) noexcept;
  [[nodiscard]] double signal_rate_of(SolidDensities const& cell) const noexcept;  ///< what one cell contributes [1/s]
  [[nodiscard]] SolidDensities average(Int3 const& cell) const noexcept;
  [[nodiscard]] SolidPoint primitive(Int3 const& cell) const noexcept;
  /// Conserved densities of a point's state.
  [[nodiscard]] SolidDensities conserved(SolidPoint const& s) const noexcept;

  /// One field of all cells, x fastest, [nx ny nz]. `energy`: specific internal energy; `mises`: sqrt(3/2 S:S).
  enum class Field {
    density,
    velocity_x,
    velocity_y,
    velocity_z,
    pressure,
    sxx,
    syy,
    szz,
    sxy,
    sxz,
    syz,
    plastic_strain,
    energy,
    mises
  };
  [[nodiscard]] std::vector<double> field(Field which) const;

  [[nodiscard]] SolidCounters const& counters() const noexcept;
  [[nodiscard]] SolidLedger ledger() const;
  [[nodiscard]] SolidGridSetup const& setup() const noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept;  ///< of all arrays

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
