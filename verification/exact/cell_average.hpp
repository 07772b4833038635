#pragma once
/// Cell averages of exact solutions that are given point by point.
#include <functional>
#include <span>

#include "riemann/state/gas.hpp"
#include "verification/exact/eos.hpp"

namespace g27 {

/// Mean of the conserved densities of `state` over [x0, x1], weighted with x^symmetry (0 planar, 1 cylindrical,
/// 2 spherical). Gauss-Legendre quadrature with `points` nodes on every piece between x0, the `breaks` inside the cell
/// (where the state jumps or has a kink, in increasing order) and x1.
GasConserved<> cell_average(ExactEos const& eos, std::function<GasState<>(double x)> const& state, double x0, double x1,
                            int symmetry = 0, std::span<double const> breaks = {}, int points = 12);

}  // namespace g27
