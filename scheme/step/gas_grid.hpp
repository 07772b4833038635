#pragma once
/// Gas dynamics on two- and three-dimensional Cartesian grids: the scheme of GasLine, unsplit. Predicted states of a
/// face add to those of the line the half-step terms of the transverse derivatives; everything lies inside 3x3x3 cells.
///
/// The domain is made of tiles. A tile is the unit of cache, of threads, of activity and of distribution; results do
/// not depend on how many threads there are nor on the order of the tiles. Along any axis a solution of one dimension
/// is, bit by bit, that of GasLine.
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "riemann/eos/registry.hpp"
#include "scheme/step/gas_grid_options.hpp"
#include "scheme/step/gas_line.hpp"

namespace g27 {

struct GasGridSetup {
  AnyEos eos{};
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};  ///< corners of the box [m]
  Int3 cells{1, 1, 1};                  ///< 1 along z: two dimensions
  std::array<GridBoundary, 6> sides{};  ///< in the order of Side
  std::vector<BoundaryPatch> patches{};
  std::vector<SolidBlock> blocks{};
  GridSource source{};
  ProgrammedBurn burn{};
  GridSchemeOptions options{};
};

struct GridStepReport {
  StepStatus status = StepStatus::ok;
  Int3 cell{0, 0, 0};  ///< where it failed
  double dt = 0;       ///< step taken [s]
};

/// What the steps of a grid remember beside the averages.
struct GasGridMemory {
  double signal_rate = 0;      ///< that the CFL condition goes by [1/s]; cells replaced since the last step count in it
  double largest_density = 0;  ///< at the start, by which the vacuum's floor goes [kg/m^3]
};

class GasGrid {
 public:
  /// Throws std::invalid_argument for a setup that makes no sense.
  explicit GasGrid(GasGridSetup setup);
  ~GasGrid();
  GasGrid(GasGrid&&) noexcept;
  GasGrid& operator=(GasGrid&&) noexcept;

  /// Cell averages by Gauss quadrature (`points` a direction) of the state at (x, t = 0). Called from the threads of
  /// the grid at once.
  void set_state(std::function<GasPoint(Vec3 const& x)> const& state, int points = 3);
  /// Cell averages given by the centre and the widths of the cell, at time `time`.
  void set_averages(std::function<GasDensities(Vec3 const& centre, Vec3 const& widths)> const& mean, double time = 0);
  /// The same by the cell's indices: to go on from stored averages.
  void set_cells(std::function<GasDensities(Int3 const& cell)> const& mean, double time = 0);

  /// Other averages of some cells, between two steps: of those beside bodies, which other grids compute. The ledger
  /// does not count the change. Not of cells in solid blocks.
  void replace(std::span<Int3 const> cells, std::span<GasDensities const> averages);

  /// One step, not beyond t_end; on failure the state is that before the step.
  GridStepReport step(double t_end);

  [[nodiscard]] int dimensions() const noexcept;
  [[nodiscard]] Int3 cells() const noexcept;
  [[nodiscard]] std::size_t cell_count() const noexcept;       ///< without those of solid blocks
  [[nodiscard]] Vec3 widths() const noexcept;                  ///< of a cell [m]; 1 along axes that are not there
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;  ///< [m]; the lower corner along axes that are not there
  [[nodiscard]] double time() const noexcept;
  /// Time step that the CFL condition allows now [s].
  [[nodiscard]] double stable_dt() const noexcept;
  /// To go on, after set_cells(), bit by bit as the grid would have that the averages come from.
  [[nodiscard]] GasGridMemory memory() const noexcept;
  void set_memory(GasGridMemory const& memory) noexcept;
  [[nodiscard]] bool solid(Int3 const& cell) const noexcept;
  [[nodiscard]] GasDensities average(Int3 const& cell) const noexcept;
  [[nodiscard]] GasPoint primitive(Int3 const& cell) const noexcept;

  /// One field of all cells, x fastest, [nx ny nz]; 0 in solid blocks.
  enum class Field { density, velocity_x, velocity_y, velocity_z, pressure, bulk_modulus, switched, cured, repaired };
  [[nodiscard]] std::vector<double> field(Field which) const;

  [[nodiscard]] GridCounters const& counters() const noexcept;
  [[nodiscard]] GridLedger ledger() const;
  [[nodiscard]] GasGridSetup const& setup() const noexcept;
  /// Bytes of all arrays now, and cells for which there is storage.
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] std::size_t cells_stored() const noexcept;
  [[nodiscard]] std::size_t tile_count() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
