#pragma once
/// Cell averages of states in two and three dimensions.
#include <functional>

#include "riemann/eos/registry.hpp"
#include "scheme/step/gas_grid_options.hpp"
#include "verification/cases/line_problem.hpp"

namespace g27 {

/// Mean of the conserved densities over the cell with this centre and these widths [m].
using GridMean = std::function<GasDensities(Vec3 const& centre, Vec3 const& widths)>;

GasDensities densities_of(AnyEos const& eos, GasPoint const& s);
/// A vacuum has no velocity: it is at rest, without pressure.
GasPoint point_of(AnyEos const& eos, GasDensities const& q);

/// Cell mean of a state given at points: Gauss quadrature with 1 to 5 `points` along each of the first `dimensions`
/// axes.
GridMean mean_of(AnyEos const& eos, int dimensions, std::function<GasPoint(Vec3 const& x)> state, int points = 4);

/// Cell mean of a flow that depends on s = x.normal alone (a unit vector), of which `line` gives the means over [a, b]
/// in s. The gas drifts along the planes with `drift`, drift.normal = 0: the conserved densities of the line in the
/// frame that drifts. Exact along the longest projection of the cell, ten Gauss points along the others.
GridMean plane_mean(int dimensions, Vec3 const& normal, CellMean line, Vec3 const& drift = {0, 0, 0});

/// Cell mean of two uniform states that meet on the plane x.normal = offset (a unit vector, it points `above`); the
/// same quadrature.
GridMean half_space_mean(int dimensions, Vec3 const& normal, double offset, GasDensities const& below,
                         GasDensities const& above);

/// Cell mean of a flow that depends on the distance r from the origin alone and jumps at r = front: three Gauss points
/// a direction; in cells that the front crosses, the midpoints of 16 (in three dimensions 8) parts a direction.
GridMean radial_mean(AnyEos const& eos, int dimensions, std::function<GasState<>(double r)> state, double front);

}  // namespace g27
