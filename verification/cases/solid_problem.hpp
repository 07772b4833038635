#pragma once
/// A problem of elastoplastic solids in one to three dimensions as data, and how it is run and held against its
/// reference.
#include <functional>
#include <string>

#include "scheme/step/solid_grid.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

/// Mean of the conserved densities over the cell with this centre and these widths [m].
using SolidMean = std::function<SolidDensities(Vec3 const& centre, Vec3 const& widths)>;

struct SolidProblem {
  AnySolid solid{};
  int dimensions = 1;
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};   ///< corners of the box [m]; along axes that are not there they do not matter
  std::array<SolidBoundary, 6> sides{};  ///< in the order of Side
  SolidSource source{};
  double t_end = 1;  ///< [s]
  SolidMean initial{};
  SolidMean reference{};                               ///< at t_end; empty: none
  std::function<bool(Vec3 const& centre)> compared{};  ///< the cells held against the reference; empty: all
  std::function<void(SolidGrid const& grid, double dt)> after_step{};
  /// What else is measured at the end, into the result's facts
  std::function<void(SolidGrid const& grid, CaseResult& result)> measure{};
  double cfl = 0;  ///< 0: the scheme's own
  Switch monotonicity = Switch::graded;
};

/// density velocity_x velocity_y velocity_z pressure sxx syy szz sxy sxz syz
std::vector<std::string> const& solid_variables();
/// In their order.
std::array<double, 11> solid_values(SolidPoint const& s);

/// The primitive state of averages.
SolidPoint solid_point_of(SolidMaterial const& material, SolidDensities const& q);

void make_periodic(SolidProblem& problem);
SolidBoundary solid_inflow(std::function<SolidPoint(Vec3 const& x, double t)> state);

/// Mean of a state given at points, Gauss quadrature.
SolidMean solid_mean(int dimensions, std::function<SolidPoint(Vec3 const& x)> state, int points = 4);

/// Runs the problem; throws std::runtime_error when a step fails. `cells` along the longest axis, unless the options
/// say otherwise. The reference's pressure is that of `material`.
CaseResult run_problem(std::string const& name, int cells, SolidProblem const& problem, SolidMaterial const& material,
                       CaseOptions const& options);

}  // namespace g27
