#include "verification/cases/blast_grid.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "verification/cases/grid_probe.hpp"
#include "verification/exact/noh.hpp"
#include "verification/exact/sedov.hpp"

namespace g27 {

namespace {

constexpr double cold = 1e-8;  ///< pressure of the cold gas: the exact solutions have none

/// The unit diagonal of the quadrant or octant.
Vec3 diagonal(int dimensions) {
  double const d = 1 / std::sqrt(static_cast<double>(dimensions));
  return {d, d, dimensions > 2 ? d : 0};
}

/// Walls at the low sides, `high` at the others.
void make_corner(GridProblem& grid, GridBoundary const& high) {
  for (std::size_t d = 0; d < 3; ++d) grid.sides[2 * d] = wall_side, grid.sides[2 * d + 1] = high;
}

GasState<> with_cold_gas(GasState<> s, double p = cold) {
  s.p += p;
  return s;
}

/// Where the pressure falls outwards through half that behind the exact shock; if a coarse grid has smeared the shock,
/// through 3/4 of its peak on the ray beyond half the exact radius.
double shock_on_ray(GridProbe const& p, Vec3 const& direction, double exact, double length, double behind) {
  double peak = 0;
  for (int i = 0; i <= 400; ++i) {
    double const s = 0.5 * exact + (length - 0.5 * exact) * i / 400;
    peak = std::max(peak, p.at({s * direction[0], s * direction[1], s * direction[2]}));
  }
  return p.front({0, 0, 0}, direction, length, std::min(0.5 * behind, 0.75 * peak));
}

/// Of the domain's edge, no less than a cell: a spherical blast from one cell of a fine grid takes steps in proportion
/// to the square of the number of cells along an edge, for the same error.
constexpr double source_share_3d = 1.0 / 32;
std::vector<CaseParameter> const sedov_parameters{
    {"source_cells", 0, "1",
     "cells along an edge of the cube at the origin where the energy starts; 0: 1 in 2D, cells/32 but at least 1 in "
     "3D",
     0, 1000, true}};
std::vector<CaseParameter> const noh_parameters{{"pressure", cold, "Pa", "of the gas that falls in", 1e-12, 1}};

}  // namespace

Case sedov_grid_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 2 ? 120 : 48;
  auto const run = [=](CaseOptions const& options) {
    double const gamma = 1.4, size = 1.2;
    double const alpha = Sedov(gamma, dimensions - 1, 1.0, 1.0).alpha();
    // with E = alpha the shock is at r = 1 at t = 1
    auto const sedov = std::make_shared<Sedov>(gamma, dimensions - 1, alpha, 1.0);
    GridProblem grid{.eos = IdealGas{gamma}, .dimensions = dimensions, .upper = {size, size, size}, .t_end = 1.0};
    make_corner(grid, outflow_side);
    double const n = options.cells.value_or(cells), asked = value_of(sedov_parameters, options, "source_cells");
    if (asked > n / 4) throw std::invalid_argument("the source must be no wider than a quarter of the domain");
    double const edge = size / n * (asked > 0 ? asked : dimensions == 2 ? 1.0 : std::max(1.0, source_share_3d * n));
    double const hot = alpha / std::pow(2 * edge, dimensions);
    grid.initial = [=](Vec3 const& x, Vec3 const& h) -> GasDensities {
      double share = 1;
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        share *= std::clamp((edge - (x[d] - 0.5 * h[d])) / h[d], 0.0, 1.0);
      return {1.0, {0, 0, 0}, hot * share + cold / (gamma - 1.0)};
    };
    grid.reference = radial_mean(
        grid.eos, dimensions, [=](double r) { return with_cold_gas(sedov->at(r, 1.0)); }, 1.0);
    grid.measure = [=](GasGrid const& done, CaseResult& r) {
      GridProbe const p(done, GasGrid::Field::pressure), rho(done, GasGrid::Field::density);
      r.facts["shock_radius_axis"] = shock_on_ray(p, {1, 0, 0}, 1.0, size, sedov->shocked(1.0).p);
      r.facts["shock_radius_diagonal"] = shock_on_ray(p, diagonal(dimensions), 1.0, size, sedov->shocked(1.0).p);
      r.facts["shock_radius_exact"] = sedov->shock_radius(1.0);
      r.facts["density_peak"] = rho.most();
      r.facts["density_peak_exact"] = sedov->shocked(1.0).rho;
    };
    return run_problem(name, cells, grid, options);
  };
  return {.name = name,
          .title = dimensions == 2 ? "Sedov's explosion, cylindrical, on a quadrant from one cell"
                                   : "Sedov's explosion, spherical, on an octant from one cell",
          .source = "Sedov, Similarity and Dimensional Methods (1959), ch. IV",
          .dimensions = dimensions,
          .default_cells = cells,
          .meshes = grid_meshes(),
          .parameters = sedov_parameters,
          .run = run};
}

Case noh_grid_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 2 ? 100 : 48;
  auto const run = [=](CaseOptions const& options) {
    Noh const noh{.symmetry = dimensions - 1};
    double const pressure = value_of(noh_parameters, options, "pressure");
    GridProblem grid{.eos = IdealGas{noh.gamma}, .dimensions = dimensions, .t_end = 0.6};
    make_corner(grid, inflow_side([=](Vec3 const& x, double t) -> GasPoint {
                  double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + (dimensions > 2 ? x[2] * x[2] : 0.0));
                  GasState<> const s = with_cold_gas(noh.at(r, t), pressure);
                  return {s.rho, {s.u * x[0] / r, s.u * x[1] / r, dimensions > 2 ? s.u * x[2] / r : 0.0}, s.p};
                }));
    auto const at = [=, eos = grid.eos](double t) {
      return radial_mean(
          eos, dimensions, [=](double r) { return with_cold_gas(noh.at(r, t), pressure); }, noh.shock_speed() * t);
    };
    grid.initial = at(0.0), grid.reference = at(grid.t_end);
    grid.measure = [=](GasGrid const& done, CaseResult& r) {
      GridProbe const p(done, GasGrid::Field::pressure), rho(done, GasGrid::Field::density);
      double const shock = noh.shock_speed() * 0.6;
      Vec3 const d = diagonal(dimensions);
      r.facts["shock_radius_axis"] = shock_on_ray(p, {1, 0, 0}, shock, 0.9, noh.shocked().p);
      r.facts["shock_radius_diagonal"] = shock_on_ray(p, d, shock, 0.9, noh.shocked().p);
      r.facts["shock_radius_exact"] = shock;
      // between the heated centre and the profile of the shock
      r.facts["density_plateau_axis"] = rho.at({0.6 * shock, 0, 0});
      r.facts["density_plateau_diagonal"] = rho.at({0.6 * shock * d[0], 0.6 * shock * d[1], 0.6 * shock * d[2]});
      r.facts["density_plateau_exact"] = noh.shocked().rho;
      r.facts["density_centre"] = rho.cell({0, 0, 0});
    };
    return run_problem(name, cells, grid, options);
  };
  return {.name = name,
          .title = dimensions == 2 ? "Noh's implosion, cylindrical, on a quadrant"
                                   : "Noh's implosion, spherical, on an octant",
          .source = "Noh, J. Comput. Phys. 72 (1987) 78",
          .dimensions = dimensions,
          .default_cells = cells,
          .meshes = grid_meshes(),
          .parameters = noh_parameters,
          .run = run};
}

}  // namespace g27
