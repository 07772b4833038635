#pragma once
/// Gauss-Legendre averages over a cell in planar, cylindrical and spherical measure.
#include <array>
#include <stdexcept>

#include "scheme/grid/line.hpp"

namespace g27 {

struct GaussPoint {
  double x, weight;  ///< on [-1, 1]
};

/// Nodes and weights for 1 to 5 points (Abramowitz & Stegun, table 25.4).
inline std::array<GaussPoint, 5> gauss_points(int points) {
  switch (points) {
    case 1:
      return {{{0.0, 2.0}}};
    case 2:
      return {{{-0.57735026918962576451, 1.0}, {0.57735026918962576451, 1.0}}};
    case 3:
      return {{{-0.77459666924148337704, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.77459666924148337704, 5.0 / 9.0}}};
    case 4:
      return {{{-0.86113631159405257522, 0.34785484513745385737},
               {-0.33998104358485626480, 0.65214515486254614263},
               {0.33998104358485626480, 0.65214515486254614263},
               {0.86113631159405257522, 0.34785484513745385737}}};
    case 5:
      return {{{-0.90617984593866399280, 0.23692688505618908751},
               {-0.53846931010568309104, 0.47862867049936646804},
               {0.0, 128.0 / 225.0},
               {0.53846931010568309104, 0.47862867049936646804},
               {0.90617984593866399280, 0.23692688505618908751}}};
    default:
      throw std::invalid_argument("1 to 5 Gauss points");
  }
}

/// Calls f(x, weight) at the Gauss points of the cell [x0, x1], weighted with x^alpha.
/// out  sum of the weights
template <class F>
double cell_quadrature(Symmetry symmetry, double x0, double x1, int points, F const& f) {
  auto const gauss = gauss_points(points);
  double sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(points); ++k) {
    double const x = 0.5 * (x0 + x1) + 0.5 * (x1 - x0) * gauss[k].x;
    double weight = gauss[k].weight;
    if (symmetry != Symmetry::planar) weight *= x;
    if (symmetry == Symmetry::spherical) weight *= x;
    f(x, weight);
    sum += weight;
  }
  return sum;
}

/// Mean of `density(x)` over the cell [x0, x1], weighted with x^alpha.
template <class F>
GasConserved<> cell_average(Symmetry symmetry, double x0, double x1, int points, F const& density) {
  GasConserved<> sum{0, 0, 0};
  double const measure = cell_quadrature(symmetry, x0, x1, points, [&](double x, double weight) {
    GasConserved<> const q = density(x);
    sum = {sum.mass + weight * q.mass, sum.momentum + weight * q.momentum, sum.energy + weight * q.energy};
  });
  return {sum.mass / measure, sum.momentum / measure, sum.energy / measure};
}

}  // namespace g27
