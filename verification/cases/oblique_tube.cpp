#include "verification/cases/oblique_tube.hpp"

#include <cmath>
#include <memory>

#include "verification/cases/shu_osher.hpp"
#include "verification/exact/gas_riemann.hpp"

namespace g27 {

namespace {

constexpr char const* sod_source = "Sod, J. Comput. Phys. 27 (1978) 1";
constexpr char const* shu_osher_source = "Shu and Osher, J. Comput. Phys. 83 (1989) 32, example 8";
constexpr double sod_end = 0.2;

std::shared_ptr<GasRiemann> sod() {
  IdealLaw const law{1.4};
  return std::make_shared<GasRiemann>(law, GasState<>{1.0, 0.0, 1.0}, law, GasState<>{0.125, 0.0, 0.1});
}

/// Means at time t of a layer of the dense gas in |s| < half_layer, periodic in s.
CellMean layer_mean(std::shared_ptr<GasRiemann> const& exact, double half_layer, double period, double t) {
  // Inside one half of the period there is one diaphragm; the other half is its mirror image.
  auto const right_half = [=](double a, double b) { return exact->average(a - half_layer, b - half_layer, t); };
  return [=](double a, double b) {
    double const shift = period * std::round(0.5 * (a + b) / period);
    GasConserved<> sum{0, 0, 0};
    // the middles of the layers and of the gaps between them
    for (int half = -2; half < 2; ++half) {
      double const lo = std::fmax(a - shift, 0.5 * half * period), hi = std::fmin(b - shift, 0.5 * (half + 1) * period);
      if (!(hi > lo)) continue;
      double const share = (hi - lo) / (b - a);
      bool const mirrored = half == -1 || half == 1;
      double const middle = half == 1 ? period : half == -2 ? -period : 0.0;
      GasConserved<> const q = mirrored ? right_half(middle - hi, middle - lo) : right_half(lo - middle, hi - middle);
      sum.mass += share * q.mass, sum.energy += share * q.energy;
      sum.momentum += share * (mirrored ? -q.momentum : q.momentum);
    }
    return sum;
  };
}

Vec3 normal_of(double tangent) {
  double const cosine = 1 / std::sqrt(1 + tangent * tangent);
  return {cosine, cosine * tangent, 0};
}

double along(Vec3 const& normal, Vec3 const& x) { return normal[0] * x[0] + normal[1] * x[1]; }

Case tube_case(std::string const& name, std::string const& title, char const* source, int cells,
               std::function<CaseResult(CaseOptions const&)> run) {
  return {.name = name,
          .title = title,
          .source = source,
          .dimensions = 2,
          .default_cells = cells,
          .meshes = grid_meshes(),
          .run = std::move(run)};
}

}  // namespace

Case sod_aligned_case(std::string const& name) {
  return tube_case(name, "Sod shock tube along an axis", sod_source, 200, [=](CaseOptions const& options) {
    auto const exact = sod();
    GridProblem grid{.eos = IdealGas{1.4}, .upper = {1, 0.125, 1}, .t_end = sod_end};
    make_periodic(grid);
    grid.sides[0] = grid.sides[1] = outflow_side;
    auto const at = [=](double t) {
      return plane_mean(2, {1, 0, 0}, [=](double a, double b) { return exact->average(a - 0.5, b - 0.5, t); });
    };
    grid.initial = at(0.0), grid.reference = at(grid.t_end);
    return run_problem(name, 200, grid, options);
  });
}

Case sod_diagonal_case(std::string const& name) {
  return tube_case(name, "Sod shock tube at 45 degrees, periodic", sod_source, 256, [=](CaseOptions const& options) {
    auto const exact = sod();
    GridProblem grid{.eos = IdealGas{1.4}, .upper = {2, 2, 1}, .t_end = sod_end};
    make_periodic(grid);
    // the rarefaction runs 0.237 m into the layer, the shock 0.350 m into the gap
    double const period = std::sqrt(2.0), half_layer = 0.3;
    Vec3 const normal = normal_of(1.0);
    auto const at = [=](double t) { return plane_mean(2, normal, layer_mean(exact, half_layer, period, t)); };
    grid.initial = at(0.0), grid.reference = at(grid.t_end);
    return run_problem(name, 256, grid, options);
  });
}

Case sod_oblique_case(std::string const& name, double tangent) {
  return tube_case(name, "Sod shock tube at an angle with an irrational tangent", sod_source, 256,
                   [=](CaseOptions const& options) {
                     auto const exact = sod();
                     Vec3 const normal = normal_of(tangent);
                     GridProblem grid{.eos = IdealGas{1.4}, .lower = {-1, -1, 0}, .upper = {1, 1, 1}, .t_end = sod_end};
                     grid.sides.fill(inflow_side([=](Vec3 const& x, double t) -> GasPoint {
                       double const s = along(normal, x), steep = s < 0 ? -1e300 : 1e300;
                       GasState<> const q = exact->at(t > 0 ? s / t : steep);
                       return {q.rho, {q.u * normal[0], q.u * normal[1], 0}, q.p};
                     }));
                     auto const at = [=](double t) {
                       return plane_mean(2, normal, [=](double a, double b) { return exact->average(a, b, t); });
                     };
                     grid.initial = at(0.0), grid.reference = at(grid.t_end);
                     // the fastest signal, u + c = 2.2 m/s, comes 0.44 m far
                     grid.compared = [](Vec3 const& x) { return std::fabs(x[0]) < 0.5 && std::fabs(x[1]) < 0.5; };
                     return run_problem(name, 256, grid, options);
                   });
}

Case shu_osher_aligned_case(std::string const& name) {
  return tube_case(
      name, "Mach 3 shock into a density wave, along an axis", shu_osher_source, 400, [=](CaseOptions const& options) {
        LineProblem const line = shu_osher_problem();
        GridProblem grid{.eos = line.eos, .lower = {line.x0, 0, 0}, .upper = {line.x1, 0.625, 1}, .t_end = line.t_end};
        make_periodic(grid);
        grid.sides[0] = grid.sides[1] = outflow_side;
        grid.initial = plane_mean(2, {1, 0, 0}, line.initial);
        grid.reference = plane_mean(2, {1, 0, 0}, shu_osher_reference());
        return run_problem(name, 400, grid, options);
      });
}

Case shu_osher_oblique_case(std::string const& name, double tangent) {
  return tube_case(
      name, "Mach 3 shock into a density wave, at an angle", shu_osher_source, 256, [=](CaseOptions const& options) {
        LineProblem const line = shu_osher_problem();
        Vec3 const normal = normal_of(tangent);
        double const half = 6.4;
        GridProblem grid{.eos = line.eos, .lower = {-half, -half, 0}, .upper = {half, half, 1}, .t_end = line.t_end};
        grid.sides.fill(inflow_side([=](Vec3 const& x, double t) -> GasPoint {
          GasState<> const q = shu_osher_outside(along(normal, x), t);
          return {q.rho, {q.u * normal[0], q.u * normal[1], 0}, q.p};
        }));
        grid.initial = plane_mean(2, normal, line.initial);
        grid.reference = plane_mean(2, normal, shu_osher_reference());
        grid.compared = [=](Vec3 const& x) {
          double const across = normal[0] * x[1] - normal[1] * x[0];
          return std::fabs(along(normal, x)) < 4.8 && std::fabs(across) < 0.4;
        };
        return run_problem(name, 256, grid, options);
      });
}

}  // namespace g27
