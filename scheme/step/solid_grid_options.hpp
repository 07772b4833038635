#pragma once
/// What a user may choose of the scheme for elastoplastic solids on Cartesian grids of one to three dimensions.
#include <array>
#include <cstdint>
#include <functional>

#include "riemann/state/solid_point.hpp"
#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

/// d/dt of the primitive variables, the specific energy [J/kg] among them.
struct SolidRate {
  double rho = 0;
  Vec3 u{0, 0, 0};
  double p = 0, e = 0;
  Sym3 S{0, 0, 0, 0, 0, 0};
  double ep = 0;
};

struct SolidSchemeOptions {
  Predictor predictor = Predictor::linear;  ///< godunov, linear or parabolic
  /// Per family; off: none. literal: one for all, from the normal stress alone, monotone between the two centres;
  /// binary: monotone on both three-point supports; graded: as binary, by degrees. Parabolic: off, or anything else:
  /// on.
  Switch monotonicity = Switch::graded;
  Transverse transverse = Transverse::own_cell;
  bool tangent = true;   ///< plastic faces take the tangent modulus; false: every face is elastic
  bool midpoint = true;  ///< plastic return along the direction of the step's middle; false: radial
  double cfl = 0;        ///< 0: chosen, 0.8 of an elastic solid, 0.7 of a plastic one
  int threads = 1;
  int cells_per_thread = 8192;  ///< cells below which another thread costs more than it brings
  Int3 tile{0, 0, 0};           ///< cells of a tile along each axis; 0: chosen
};

/// Condition on a side of the box. Functions take the centre of a face of the side (along the side; of a cell for
/// `state`) [m] and the time [s].
struct SolidBoundary {
  enum class Kind {
    periodic,
    symmetry,  ///< mirror
    wall,      ///< rigid, free slip: normal velocity `normal_velocity` along +axis (null: 0), no shear
    fixed,     ///< velocity given by `velocity` (null: 0)
    traction,  ///< stress on the side, (s_xn, s_yn, s_zn) with n the side's axis, not its outward normal (null: 0)
    free,      ///< no stress
    outflow,   ///< the state continues
    inflow,    ///< state outside
    contact    ///< of lines alone: another medium, which steps together with the line: line_contact.hpp
  };
  Kind kind = Kind::outflow;
  std::function<double(Vec3 const& x, double t)> normal_velocity{};  ///< [m/s]
  std::function<Vec3(Vec3 const& x, double t)> velocity{};           ///< [m/s]
  std::function<Vec3(Vec3 const& x, double t)> traction{};           ///< [Pa]
  std::function<SolidPoint(Vec3 const& x, double t)> state{};
};

/// Source terms of a manufactured solution, in all of the variables.
struct SolidSource {
  /// mean over the cell with centre x and widths h, and over the step [t, t + dt], of the conserved source densities
  std::function<SolidDensities(Vec3 const& x, Vec3 const& h, double t, double dt)> mean{};
  /// d/dt of the primitive variables that the source alone causes, at a point
  std::function<SolidRate(Vec3 const& x, double t)> primitive_rate{};
};

/// How often each thing happened since the start, summed over faces (or cells) and steps. A face between two tiles
/// counts twice, since each tile computes it.
struct SolidCounters {
  std::uint64_t steps = 0, faces = 0, cell_updates = 0;
  std::uint64_t switched = 0;  ///< faces on which the monotonicity switch acted on some family
  std::uint64_t tangent = 0;   ///< faces that took the tangent modulus
  std::uint64_t yielded = 0;   ///< cells returned to the yield surface
  std::uint64_t retried = 0;   ///< steps redone with half the time step
};

struct SolidLedger {
  LedgerEntry mass, energy;
  std::array<LedgerEntry, 3> momentum;
  double plastic_work = 0;  ///< since the start [J]
};

}  // namespace g27
