#include "verification/cases/shu_osher.hpp"

#include <cmath>

#include "verification/cases/fine_grid.hpp"

namespace g27 {

namespace {

constexpr GasState<> shocked_gas{3.857143, 2.629369, 10.33333};
constexpr double shock_speed = 3.549648;  // 3 sqrt(1.4)

GasState<> upstream_gas(double x) { return {1.0 + 0.2 * std::sin(5.0 * x), 0.0, 1.0}; }

}  // namespace

LineProblem shu_osher_problem() {
  LineProblem line{.eos = IdealGas{1.4}, .x0 = -5.0, .x1 = 5.0, .t_end = 1.8};
  auto const upstream = mean_of(line.eos, Symmetry::planar, upstream_gas);
  auto const shocked = mean_of(line.eos, Symmetry::planar, [](double) { return shocked_gas; });
  line.initial = [=](double a, double b) {
    double const s = std::fmin(std::fmax((-4.0 - a) / (b - a), 0.0), 1.0);
    if (s >= 1.0) return shocked(a, b);
    if (s <= 0.0) return upstream(a, b);
    GasConserved<> const l = shocked(a, -4.0), r = upstream(-4.0, b);
    return GasConserved<>{s * l.mass + (1 - s) * r.mass, s * l.momentum + (1 - s) * r.momentum,
                          s * l.energy + (1 - s) * r.energy};
  };
  return line;
}

CellMean shu_osher_reference() { return fine_grid_reference("shu-osher", shu_osher_problem(), 12800); }

GasState<> shu_osher_outside(double x, double t) { return x < -4.0 + shock_speed * t ? shocked_gas : upstream_gas(x); }

}  // namespace g27
