#pragma once
/// A problem in two or three dimensions as data, and how it is run on a grid and held against its reference.
#include <functional>
#include <string>
#include <vector>

#include "scheme/step/gas_grid.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/grid_mean.hpp"

namespace g27 {

/// Where gas does not enter [m]; its sides are put on the nearest faces of the grid.
struct SolidBox {
  Vec3 lower{0, 0, 0}, upper{0, 0, 0};
};

struct GridProblem {
  AnyEos eos{};
  int dimensions = 2;
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};  ///< corners of the box [m]; along axes that are not there they do not matter
  std::array<GridBoundary, 6> sides{};  ///< in the order of Side
  std::vector<BoundaryPatch> patches{};
  std::vector<SolidBox> blocks{};
  GridSource source{};
  ProgrammedBurn burn{};
  double t_end = 1;  ///< [s]
  long steps = 0;    ///< if set: the end, in place of t_end
  GridMean initial{};
  GridMean reference{};                                ///< at t_end; empty: none
  std::function<bool(Vec3 const& centre)> compared{};  ///< the cells held against the reference; empty: all
  /// What else is measured at the end, into the result's facts
  std::function<void(GasGrid const& grid, CaseResult& result)> measure{};
  double cfl = 0.8;
  Switch monotonicity = Switch::graded;
};

inline GridBoundary const periodic_side{.kind = GridBoundary::Kind::periodic, .state = {}};
inline GridBoundary const wall_side{.kind = GridBoundary::Kind::wall, .state = {}};
inline GridBoundary const outflow_side{.kind = GridBoundary::Kind::outflow, .state = {}};
GridBoundary inflow_side(std::function<GasPoint(Vec3 const& x, double t)> state);

/// All sides periodic.
void make_periodic(GridProblem& problem);

/// Meshes of grid cases: "fixed", and "frame" where the case may be run in the frame of its mean flow.
std::vector<std::string> grid_meshes(bool with_frame = false);

/// Cells along each axis when the longest has `cells`: cubic where the box allows, else as near as whole numbers come;
/// at least 4.
Int3 grid_cells(GridProblem const& problem, int cells);

/// Runs the problem; throws std::runtime_error when a step fails. `cells` along the longest axis, unless the options
/// say otherwise.
CaseResult run_problem(std::string const& name, int cells, GridProblem problem, CaseOptions const& options);

}  // namespace g27
