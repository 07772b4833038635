#include "verification/cases/blast_problem.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "scheme/grid/line.hpp"
#include "verification/exact/noh.hpp"
#include "verification/exact/sedov.hpp"

namespace g27 {

namespace {

constexpr double cold = 1e-8;  ///< pressure of the cold gas: the exact solutions have none

constexpr double source_radius = 0.04;  ///< its gas is 6e-5 (spherical) of what the blast has swept at the end

/// The exact mean with the cold gas's energy added.
CellMean with_cold_gas(double gamma, CellMean exact) {
  return [=](double a, double b) {
    GasConserved<> q = exact(a, b);
    q.energy += cold / (gamma - 1.0);
    return q;
  };
}

}  // namespace

Case noh_case(std::string const& name, std::string const& title, Symmetry symmetry) {
  auto const run = [=](CaseOptions const& options) {
    Noh const noh{.symmetry = static_cast<int>(symmetry)};
    LineProblem line{.eos = IdealGas{noh.gamma}, .t_end = 0.6, .symmetry = symmetry};
    line.left.kind = GasBoundary::Kind::wall;
    line.right = {.kind = GasBoundary::Kind::inflow, .state = [=](double r, double t) -> GasState<> {
                    return {noh.rho0 * std::pow(1.0 + noh.speed * t / r, noh.symmetry), -noh.speed, cold};
                  }};
    auto const at = [=](double t) {
      return with_cold_gas(noh.gamma, [=](double a, double b) { return noh.average(a, b, t); });
    };
    line.initial = at(0.0), line.reference = at(line.t_end);
    return run_problem(name, 200, line, options);
  };
  return {.name = name, .title = title, .source = "Noh, J. Comput. Phys. 72 (1987) 78", .run = run};
}

Case sedov_case(std::string const& name, std::string const& title, Symmetry symmetry) {
  auto const run = [=](CaseOptions const& options) {
    double const gamma = 1.4, dimensions = static_cast<double>(symmetry) + 1.0;
    double const alpha = Sedov(gamma, static_cast<int>(symmetry), 1.0, 1.0).alpha();
    // with E = alpha the shock is at r = 1 at t = 1
    auto const sedov = std::make_shared<Sedov>(gamma, static_cast<int>(symmetry), alpha, 1.0);
    double const volume =
        2.0 * std::numbers::pi * (dimensions - 1.0) / dimensions * std::pow(source_radius, dimensions);
    double const hot = alpha / volume;
    LineProblem line{.eos = IdealGas{gamma}, .x1 = 1.2, .t_end = 1.0, .symmetry = symmetry};
    line.left.kind = GasBoundary::Kind::wall;
    line.initial = [=](double a, double b) {
      double const inside =
          std::fmin(b, source_radius) > a ? measure_between(symmetry, a, std::fmin(b, source_radius)) : 0.0;
      return GasConserved<>{1.0, 0.0, hot * inside / measure_between(symmetry, a, b) + cold / (gamma - 1.0)};
    };
    line.reference = with_cold_gas(gamma, [=](double a, double b) { return sedov->average(a, b, 1.0); });
    return run_problem(name, 200, line, options);
  };
  return {
      .name = name, .title = title, .source = "Sedov, Similarity and Dimensional Methods (1959), ch. IV", .run = run};
}

}  // namespace g27
