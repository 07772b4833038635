#pragma once
/// Linear stability of unsplit schemes on uniform flow: the amplification matrix of a Fourier mode, from the scheme's
/// formulas alone, of the Euler equations and of hypoelastic solids.
///
/// Fields of the gas are symmetrised, (p/(rho c), u, v, w, S), so that the flux matrices are symmetric and the norm is
/// the energy's. Each characteristic family of a face is a mean of the two cells, (1 + nu)/2 and (1 - nu)/2 with nu =
/// lambda dt/h (a linear profile sampled where the characteristic starts); or the swept average of the upwind parabola.
#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "verification/exact/solid.hpp"

namespace g27 {

enum class ModelPredictor { first_order, linear, parabolic };
enum class ModelTransverse { none, averaged, own_cell };

struct StabilityModel {
  int dimensions = 2;
  ModelPredictor predictor = ModelPredictor::linear;
  ModelTransverse transverse = ModelTransverse::own_cell;
  bool max_rule = false;  ///< CFL number by the fastest direction; otherwise the sum over the directions
};

/// The matrix of the flux along an axis, and the projectors of its families with their speeds.
struct ModelAxis {
  Eigen::MatrixXd flux;
  std::vector<std::pair<double, Eigen::MatrixXd>> families;
};
/// One a dimension. The gas: c = 1; `u` is the velocity along the axis.
ModelAxis gas_axis(int dimensions, int axis, double u);
/// Velocity, pressure and deviator of a solid around the state `s`, over its P speed and bulk modulus. Throws
/// NumericsError where the speeds are not real.
ModelAxis solid_axis(SolidMaterial const& material, SolidPoint const& s, int axis);

/// Largest modulus of an amplification matrix's eigenvalue over `waves` wave numbers a direction in [0, pi], on cubic
/// cells; steps of `r` cell widths over the unit of speed.
double spectral_radius(StabilityModel const& model, std::vector<ModelAxis> const& axes, double r, int waves);

/// The same of a gas at the CFL number `cfl`, for flow at `mach` along `direction` (need not be a unit vector).
double spectral_radius(StabilityModel const& model, double cfl, double mach, std::array<double, 3> const& direction,
                       int waves);

/// Largest CFL number up to `highest` for which no mode grows by more than 1e-9 a step, over the given Mach numbers and
/// a fan of directions; bisection to `resolution`.
double stability_limit(StabilityModel const& model, double const* machs, int count, double highest, double resolution,
                       int waves);

}  // namespace g27
