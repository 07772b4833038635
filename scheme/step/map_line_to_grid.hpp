#pragma once
/// From a line in cylindrical or spherical symmetry to a grid of two or three dimensions, once and conservatively.
///
/// A grid cell takes the mean, over samples^dimensions points, of linear profiles in the line's cells. What the points
/// of all cells lack of the line's mass, momentum and energy goes to the cells in proportion to how far each differs
/// from the gas outside. Handing each shell's content to the points that lie in it would be exact at once, but the
/// number of points in a shell scatters: with 4 points a direction and shells of a third of a cell, uniform gas comes
/// out with noise of up to 1 %. Cells beyond the wave take the gas outside bit by bit: they stay uniform.
#include "scheme/step/gas_grid_options.hpp"
#include "scheme/step/gas_line.hpp"

namespace g27 {

struct GridBox {
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};  ///< m
  Int3 cells{1, 1, 1};                  ///< 1 along z: two dimensions
};

/// Radius [m] beyond which the line's gas is that of its last cell, to 1e-10.
double disturbed_radius(GasLine const& line);

/// Angle [radian or steradian] that a box leaves open around a point of its inside or its sides: full, half, quarter,
/// eighth.
double open_angle(GridBox const& box, Vec3 const& centre);

class LineToGrid {
 public:
  /// Throws std::invalid_argument when the wave does not lie within the box, as far as the sides through the centre
  /// leave room for it.
  LineToGrid(GasLine const& line, Vec3 const& centre, GridBox const& box, int samples = 4);

  /// Averages of a grid cell.
  [[nodiscard]] GasDensities operator()(Int3 const& cell) const;

  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] GasDensities const& outside() const noexcept { return outside_; }
  /// Integrals over the box: of the gas outside over the whole of it, and what the wave holds beyond that.
  [[nodiscard]] GasDensities const& total() const noexcept { return total_; }
  /// What was missing of the wave's mass, momentum and energy before the correction, relative to the integral of the
  /// magnitudes.
  [[nodiscard]] double missing() const noexcept { return missing_; }

 private:
  struct Shell {
    double centroid = 0;
    GasConserved<> mean{0, 0, 0}, slope{0, 0, 0};
  };
  [[nodiscard]] bool beyond(Vec3 const& lower) const;
  [[nodiscard]] GasDensities sampled(Vec3 const& lower) const;
  [[nodiscard]] GasDensities difference(Int3 const& cell, bool& outside) const;

  GridBox box_;
  Vec3 centre_, widths_;
  int dimensions_, samples_;
  std::vector<double> faces_;
  std::vector<Shell> shells_;  ///< those within the wave; densities less those outside
  double radius_ = 0, missing_ = 0;
  GasDensities outside_, total_;
  GasDensities share_;  ///< of its own magnitude that a cell's difference gains
};

}  // namespace g27
