#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/cases/grid_probe.hpp"
#include "verification/cases/grid_problem.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {

namespace {

constexpr double degree = std::numbers::pi / 180, length = 1.5, leading_edge = 0.25;
std::vector<CaseParameter> const parameters{{"mach", 3, "1", "Mach number upstream"},
                                            {"angle_deg", 15, "deg", "angle of the wedge"}};

/// Slope of the least-squares line through (x, y).
double slope_of(std::vector<double> const& x, std::vector<double> const& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  double const n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

ObliqueShock shock_of(double mach, double angle) {
  try {
    return oblique_shock(1.4, mach, angle * degree);
  } catch (NumericsError const& error) {
    throw std::invalid_argument(error.what());
  }
}

/// The frame of the wall: gas comes down upon the x axis, which is a wall behind the leading edge.
CaseResult run(CaseOptions const& options) {
  double const mach = value_of(parameters, options, "mach"), angle = value_of(parameters, options, "angle_deg");
  ObliqueShock const shock = shock_of(mach, angle);
  double const rise = shock.angle - shock.deflection, height = (length - leading_edge) * std::tan(rise) + 0.1;
  GasPoint const ahead{1.4, {mach * std::cos(shock.deflection), -mach * std::sin(shock.deflection), 0}, 1.0};
  double const rho = ahead.rho * shock.density_ratio, p = ahead.p * shock.pressure_ratio;
  GasPoint const behind{rho, {shock.mach_behind * std::sqrt(1.4 * p / rho), 0, 0}, p};

  GridProblem grid{.eos = IdealGas{1.4}, .upper = {length, height, 1}, .t_end = 5 * length / ahead.u[0]};
  GridBoundary const inflow = inflow_side([=](Vec3 const&, double) { return ahead; });
  grid.sides = {inflow, outflow_side, wall_side, inflow, periodic_side, periodic_side};
  grid.patches = {{.side = Side::y_low, .upper = {leading_edge, 1e300, 1e300}, .condition = inflow}};
  GasDensities const above = densities_of(grid.eos, ahead), below = densities_of(grid.eos, behind);
  grid.initial = [=](Vec3 const&, Vec3 const&) { return above; };
  Vec3 const normal{-std::sin(rise), std::cos(rise), 0};
  grid.reference = half_space_mean(2, normal, normal[0] * leading_edge, below, above);
  double const first = leading_edge + 0.3, last = length - 0.15;
  grid.compared = [=](Vec3 const& x) { return x[0] > first && x[0] < last && x[1] > 0.05; };
  grid.measure = [=](GasGrid const& done, CaseResult& r) {
    GridProbe const pressure(done, GasGrid::Field::pressure), density(done, GasGrid::Field::density);
    std::vector<double> x, y;
    for (int i = 0; i < done.cells()[0]; ++i) {
      double const at = done.centre({i, 0, 0})[0];
      if (at < first || at > last) continue;
      x.push_back(at);
      y.push_back(pressure.front({at, 0, 0}, {0, 1, 0}, height, 0.5 * (ahead.p + behind.p)));
    }
    r.facts["shock_angle_deg"] = (std::atan(slope_of(x, y)) + shock.deflection) / degree;
    r.facts["shock_angle_exact_deg"] = shock.angle / degree;
    r.facts["pressure_on_wall"] = pressure.at({1.0, 0, 0}) / behind.p - 1;
    r.facts["density_on_wall"] = density.at({1.0, 0, 0}) / behind.rho - 1;
  };
  return run_problem("wedge-2d", 150, grid, options);
}

}  // namespace

Case wedge_2d_case() {
  return {.name = "wedge-2d",
          .title = "steady oblique shock of a Mach 3 flow on a wedge of 15 degrees",
          .source = "Anderson, Modern Compressible Flow, 3rd ed., 4.3",
          .dimensions = 2,
          .default_cells = 150,
          .meshes = grid_meshes(),
          .parameters = parameters,
          .run = run};
}

}  // namespace g27
