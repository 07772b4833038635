#pragma once
/// What a user may choose of the gas scheme on two- and three-dimensional Cartesian grids.
#include <array>
#include <cstdint>
#include <functional>

#include "scheme/step/gas_options.hpp"

namespace g27 {

using Vec3 = std::array<double, 3>;
using Int3 = std::array<int, 3>;

/// Primitive state: density [kg/m^3], velocity [m/s], pressure [Pa].
struct GasPoint {
  double rho = 0;
  Vec3 u{0, 0, 0};
  double p = 0;
};

/// Conserved densities: mass [kg/m^3], momentum [kg/(m^2 s)], total energy [J/m^3].
struct GasDensities {
  double mass = 0;
  Vec3 momentum{0, 0, 0};
  double energy = 0;
};

/// Half-step term of the transverse derivatives in the predicted states of a face.
enum class Transverse {
  own_cell,  ///< each side takes that of its own cell: stable to CFL 1 of the sum rule in 2D and 3D
  averaged,  ///< both sides take the mean of the two cells: an ablation, stable to about 0.7
  none       ///< left out: an ablation, unstable and of first order
};

struct GridSchemeOptions {
  Predictor predictor = Predictor::linear;
  Switch monotonicity = Switch::graded;
  RiemannSolver riemann = RiemannSolver::fast;
  Transverse transverse = Transverse::own_cell;
  bool linear_star = true;  ///< acoustic star state where the jump is weak; counted
  bool cure = true;         ///< HLLE at first order on the faces of cells in grid-aligned shocks; counted
  bool repair = true;       ///< faces of cells that lose their density or pressure are redone at first order; counted
  bool skip = true;         ///< uniform tiles among uniform tiles are neither computed nor stored
  bool maps = false;        ///< counts per cell where switch, cure and repair acted: 12 bytes a cell
  bool max_rule = false;    ///< CFL number of the fastest direction instead of the sum over the directions
  double cfl = 0.8;
  int threads = 1;
  int cells_per_thread = 4096;  ///< active cells below which another thread costs more than it brings
  Int3 tile{0, 0, 0};           ///< cells of a tile along each axis; 0: chosen
};

struct GridBoundary {
  enum class Kind { periodic, wall, outflow, inflow };
  Kind kind = Kind::outflow;
  /// inflow: the state outside at (x [m], t [s])
  std::function<GasPoint(Vec3 const& x, double t)> state{};
};

/// Sides of the box in the order -x +x -y +y -z +z.
enum class Side : int { x_low, x_high, y_low, y_high, z_low, z_high };

/// Part of a side with a condition of its own: where the face's centre lies within [lower, upper) along the two axes
/// that span the side.
struct BoundaryPatch {
  Side side = Side::x_low;
  Vec3 lower{-1e300, -1e300, -1e300}, upper{1e300, 1e300, 1e300};
  GridBoundary condition{};
};

/// Box of cells that gas does not enter: its sides are walls.
struct SolidBlock {
  Int3 first{0, 0, 0}, last{0, 0, 0};  ///< cells [first, last)
};

/// Source terms of a manufactured solution.
struct GridSource {
  /// mean over the cell with centre x and widths h, and over the step [t, t + dt], of the conserved source densities
  std::function<GasDensities(Vec3 const& x, Vec3 const& h, double t, double dt)> mean{};
  /// d/dt of the primitive variables that the source alone causes, at a point
  std::function<GasPoint(Vec3 const& x, double t)> primitive_rate{};
};

/// How often each thing happened since the start, summed over faces (or cells) and steps. A face between two tiles
/// counts twice, since each tile computes it.
struct GridCounters : GasCounters {
  std::uint64_t cured = 0;          ///< faces that took the flux of HLLE
  std::uint64_t cells_skipped = 0;  ///< cell updates left out because the tile and its neighbourhood are uniform
};

/// As GasLedger, by component of the momentum.
struct GridLedger {
  LedgerEntry mass, energy;
  std::array<LedgerEntry, 3> momentum;
};

}  // namespace g27
