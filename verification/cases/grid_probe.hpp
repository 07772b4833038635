#pragma once
/// Looking at the fields of a grid: values between cell centres, and fronts along rays.
#include <vector>

#include "scheme/step/gas_grid.hpp"

namespace g27 {

class GridProbe {
 public:
  GridProbe(GasGrid const& grid, GasGrid::Field which) : grid_(grid), values_(grid.field(which)) {}

  [[nodiscard]] double cell(Int3 const& at) const;
  /// Linear between cell centres along every axis; constant beyond the outermost centres.
  [[nodiscard]] double at(Vec3 const& x) const;
  [[nodiscard]] double least() const;
  [[nodiscard]] double most() const;

  /// Largest s in [0, length] at which the value on the ray origin + s direction falls through `level`: where a front
  /// that runs outwards stands. Sampled four times a cell; 0 if the value stays below.
  [[nodiscard]] double front(Vec3 const& origin, Vec3 const& direction, double length, double level) const;

 private:
  GasGrid const& grid_;
  std::vector<double> values_;
};

}  // namespace g27
