/// Cell updates of the three-dimensional solid scheme, all of it, and what one costs over a gas update with the same
/// predictor on the same grid, measured in turn.
#include <algorithm>
#include <array>
#include <string>
#include <thread>

#include "scheme/kernel/solid_kernels.hpp"
#include "studies/bench/box_waves.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/benchmark.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

Table run(BenchmarkOptions const& options) {
  int const cells = options.cells > 0 ? options.cells : 96;
  int const cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  double const fma = fma_gflops_per_core();
  Table table{.name = "solid3d",
              .title = "cell updates of the 3D solid scheme by wall clock; over_gas: time over that of a gas update",
              .columns = {{"scheme", "1"},
                          {"eos", "1"},
                          {"strength", "1"},
                          {"threads", "1"},
                          {"cell_updates_per_s", "1/s"},
                          {"cell_updates_per_s_per_core", "1/s"},
                          {"cell_updates_per_gflop", "1"},
                          {"over_gas", "1"},
                          {"bytes_per_cell_update", "B"},
                          {"bytes_per_cell", "B"},
                          {"triad_gb_s", "GB/s"},
                          {"triad_fraction", "1"},
                          {"fma_gflops_per_core", "1e9/s"},
                          {"tangent_faces", "1"}},
              .rows = {},
              .facts = {}};
  struct Scheme {
    char const* name;
    Predictor predictor;
  };
  std::array const schemes{Scheme{"godunov", Predictor::godunov}, Scheme{"modified", Predictor::linear},
                           Scheme{"parabolic", Predictor::parabolic}};
  std::vector<int> threads{1};
  if (cores > 1) threads.push_back(std::max(2, options.threads));
  std::vector<double> const triad{triad_gb_per_s(1), cores > 1 ? triad_gb_per_s(threads.back()) : 0.0};
  for (Scheme const& scheme : schemes) {
    for (std::size_t k = 0; k < threads.size(); ++k) {
      GasGrid gas = gas_wave(IdealGas{}, {1.2, 0.0, 1e5}, cells, scheme.predictor, RiemannSolver::fast, threads[k]);
      double const gas_rate = cell_updates_per_s(gas);
      for (auto const& [medium, eos] : {std::pair{"steel", "linear"}, std::pair{"aluminium", "mie-gruneisen"}}) {
        for (bool yields : {false, true}) {
          SolidMedium const m = solid_medium(medium, yields);
          SolidGrid grid = solid_wave(m.scheme, m.rho0, cells, scheme.predictor, threads[k]);
          double const updates = cell_updates_per_s(grid);
          // at least: twelve conserved averages read, twelve written, each also fetched before it is written
          constexpr double bytes = 3 * 12 * sizeof(double);
          SolidCounters const& n = grid.counters();
          table.rows.push_back({std::string{scheme.name}, std::string{eos},
                                std::string{yields ? "yielding" : "elastic"}, static_cast<long>(threads[k]), updates,
                                updates / threads[k], updates / threads[k] / fma, gas_rate / updates, bytes,
                                static_cast<double>(grid.bytes()) / static_cast<double>(grid.cell_count()), triad[k],
                                1e-9 * bytes * updates / triad[k], fma,
                                static_cast<double>(n.tangent) / static_cast<double>(n.faces)});
        }
      }
    }
  }
  table.facts = {{"isa", std::string{solid_kernels().isa}},
                 {"cells", static_cast<long>(cells)},
                 {"triad_gb_s", triad[0]},
                 {"triad_gb_s_all_threads", triad[1]},
                 {"fma_gflops_per_core", fma}};
  return table;
}

}  // namespace

Benchmark solid3d_bench() {
  return {"solid3d", "cell updates of the 3D solid scheme by predictor and material, and their cost over the gas's",
          run};
}

}  // namespace g27
