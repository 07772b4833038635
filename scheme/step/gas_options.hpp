#pragma once
/// What a user may choose of the one-dimensional gas scheme.
#include <cstdint>
#include <functional>

#include "riemann/state/gas.hpp"

namespace g27 {

enum class Symmetry : int { planar = 0, cylindrical = 1, spherical = 2 };

/// How the two states of a face's Riemann problem are prepared: the only difference between the schemes.
enum class Predictor {
  godunov,    ///< cell states, first order (`--order 1`)
  linear,     ///< OG (3.11): linear profile sampled where the characteristics start (`--order 2`)
  parabolic,  ///< parabola averaged over what each characteristic sweeps (`--order 3`)
  muscl       ///< MUSCL-Hancock, van Leer slopes: for comparison (Toro, 3rd ed., 14.4)
};

/// Monotonicity switch of the linear predictor; the parabolic one has its own bounds (off, or anything else: on).
enum class Switch { off, literal, binary, graded };

/// Interpolation points of the linear predictor, OG section "Second order on compact stencil".
enum class FootPoints {
  conservative,    ///< from the face, -(u +- c - w) t/2, on every mesh
  corrected_3_10,  ///< (3.10) re-derived from (3.7) and (3.9): not conservative
  printed_3_10     ///< (3.10) as printed, signs mended: for the study that shows it wrong
};

enum class RiemannSolver {
  fast,   ///< closed-form or levelled solver of the EOS, where there is one
  exact,  ///< general solver for any convex EOS
  hllc    ///< for comparison
};

struct GasSchemeOptions {
  Predictor predictor = Predictor::linear;
  Switch monotonicity = Switch::graded;
  FootPoints feet = FootPoints::conservative;
  bool single_foot = false;  ///< all variables at the acoustic feet: an ablation, first order in density
  RiemannSolver riemann = RiemannSolver::fast;
  bool linear_star = true;  ///< acoustic star state where the jump is weak; counted
  double cfl = 0.8;
  int threads = 1;
};

struct GasBoundary {
  enum class Kind {
    periodic,
    wall,
    outflow,
    inflow,
    piston,
    contact  ///< another medium, which steps together with the line: line_contact.hpp
  };
  Kind kind = Kind::outflow;
  /// inflow: the state outside at (x [m], t [s])
  std::function<GasState<>(double x, double t)> state{};
  /// piston: velocity of the wall at t [m/s]
  std::function<double(double t)> velocity{};
};

struct MeshMotion {
  enum class Kind {
    fixed,
    prescribed,  ///< face at `position(x0, t)`, x0 its position at t = 0
    stretched,   ///< faces follow the two boundaries linearly (pistons)
    lagrangian   ///< every face moves with its contact: no mass crosses it
  };
  Kind kind = Kind::fixed;
  std::function<double(double x0, double t)> position{};
};

/// Source terms of a manufactured solution.
struct GasSource {
  /// mean over the cell [x0, x1] and the step [t, t + dt] of the conserved source densities
  std::function<GasConserved<>(double x0, double x1, double t, double dt)> mean{};
  /// d/dt of the primitive variables that the source alone causes, at a point
  std::function<GasState<>(double x, double t)> primitive_rate{};
};

/// How often each thing happened since the start, summed over faces (or cells) and steps.
struct GasCounters {
  std::uint64_t steps = 0, faces = 0, cell_updates = 0;
  std::uint64_t switched = 0;     ///< faces on which the monotonicity switch acted on some field
  std::uint64_t linear_star = 0;  ///< faces that took the acoustic star state
  std::uint64_t repaired = 0;     ///< faces redone at first order for positivity
  std::uint64_t floored = 0;      ///< cells whose pressure or density was raised to the vacuum floor
  std::uint64_t retried = 0;      ///< steps redone with half the time step
};

/// Integral of one conserved quantity and where its change came from (per radian / steradian in curved symmetry).
struct LedgerEntry {
  double initial = 0, current = 0, through_boundary = 0, from_source = 0, from_floor = 0, scale = 0;
  /// what is unaccounted for, relative to the largest of the integrals of |density| seen
  [[nodiscard]] double residual() const noexcept {
    return scale > 0 ? (current - initial - through_boundary - from_source - from_floor) / scale : 0.0;
  }
};
struct GasLedger {
  LedgerEntry mass, momentum, energy;
};

}  // namespace g27
