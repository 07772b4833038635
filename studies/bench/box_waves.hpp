#pragma once
/// Flows for measuring rates of grids: oblique waves of 1 % over a periodic cube.
#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "scheme/step/gas_grid.hpp"
#include "scheme/step/solid_grid.hpp"

namespace g27 {

GasGrid gas_wave(AnyEos const& eos, GasState<> const& base, int cells, Predictor predictor, RiemannSolver riemann,
                 int threads);

/// `rho`: unstressed. The wave's velocity is along x alone: P and S waves. With a yield stress the material is on its
/// surface everywhere, loading in half of the box and unloading in the other half.
SolidGrid solid_wave(AnySolid const& material, double rho, int cells, Predictor predictor, int threads);

/// Wall clock of a step [s]. Throws std::runtime_error when it fails.
template <class Grid>
double step_time(Grid& grid) {
  auto const start = std::chrono::steady_clock::now();
  if (grid.step(1e300).status != StepStatus::ok) throw std::runtime_error("a step of a benchmark failed");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Cell updates over the wall clock of the fastest of five steps, after one that warms up [1/s].
template <class Grid>
double cell_updates_per_s(Grid& grid) {
  step_time(grid);
  double best = 1e300;
  for (int step = 0; step < 5; ++step) best = std::min(best, step_time(grid));
  return static_cast<double>(grid.cell_count()) / best;
}

}  // namespace g27
