#pragma once
/// Linear stability of unsplit schemes for the Euler equations on uniform flow: the amplification matrix of a Fourier
/// mode, from the scheme's formulas alone.
///
/// Fields are symmetrised, (p/(rho c), u, v, w, S), so that the flux matrices are symmetric and the norm is the
/// energy's. Each characteristic family of a face is a mean of the two cells, (1 + nu)/2 and (1 - nu)/2 with nu =
/// lambda dt/h (a linear profile sampled where the characteristic starts); or the swept average of the upwind parabola.
#include <array>

namespace g27 {

enum class ModelPredictor { first_order, linear, parabolic };
enum class ModelTransverse { none, averaged, own_cell };

struct StabilityModel {
  int dimensions = 2;
  ModelPredictor predictor = ModelPredictor::linear;
  ModelTransverse transverse = ModelTransverse::own_cell;
  bool max_rule = false;  ///< CFL number by the fastest direction; otherwise the sum over the directions
};

/// Largest modulus of an amplification matrix's eigenvalue over `waves` wave numbers a direction in [0, pi], on cubic
/// cells, for flow at `mach` along `direction` (need not be a unit vector).
double spectral_radius(StabilityModel const& model, double cfl, double mach, std::array<double, 3> const& direction,
                       int waves);

/// Largest CFL number up to `highest` for which no mode grows by more than 1e-9 a step, over the given Mach numbers and
/// a fan of directions; bisection to `resolution`.
double stability_limit(StabilityModel const& model, double const* machs, int count, double highest, double resolution,
                       int waves);

}  // namespace g27
