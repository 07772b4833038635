/// Cell updates of the three-dimensional gas scheme, all of it: exact Riemann solver, switches, cure, repairs, ledger.
/// The yardsticks of the machine are measured in the same run, so that rates of two machines can be compared: the
/// fraction of the memory's rate that the least traffic takes, and of the rate of fused multiply-adds that the counted
/// operations take (operations.hpp).
#include <algorithm>
#include <array>
#include <string>
#include <thread>

#include "scheme/kernel/gas_kernels.hpp"
#include "studies/bench/box_waves.hpp"
#include "studies/bench/operations.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/benchmark.hpp"

namespace g27 {

namespace {

Table run(BenchmarkOptions const& options) {
  int const cells = options.cells > 0 ? options.cells : 128;
  int const cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  double const fma = fma_gflops_per_core();
  Table table{
      .name = "euler3d",
      .title = "cell updates of the 3D gas scheme by wall clock; per GFLOP: over the rate of fused multiply-adds",
      .columns = {{"scheme", "1"},
                  {"eos", "1"},
                  {"threads", "1"},
                  {"cell_updates_per_s", "1/s"},
                  {"cell_updates_per_s_per_core", "1/s"},
                  {"cell_updates_per_gflop", "1"},
                  {"bytes_per_cell_update", "B"},
                  {"bytes_per_cell", "B"},
                  {"triad_gb_s", "GB/s"},
                  {"triad_fraction", "1"},
                  {"flops_per_cell_update", "1"},
                  {"fma_gflops_per_core", "1e9/s"},
                  {"fma_fraction", "1"},
                  {"weak_faces", "1"}},
      .rows = {},
      .facts = {}};
  struct Medium {
    char const* name;
    AnyEos eos;
    GasState<> base;
  };
  std::array const media{Medium{"ideal", IdealGas{}, {1.2, 0.0, 1e5}}, Medium{"jwl", Jwl{}, {1300.0, 0.0, 5e9}}};
  struct Scheme {
    char const* name;
    Predictor predictor;
    RiemannSolver riemann;
  };
  std::array const schemes{Scheme{"godunov", Predictor::godunov, RiemannSolver::fast},
                           Scheme{"modified", Predictor::linear, RiemannSolver::fast},
                           Scheme{"parabolic", Predictor::parabolic, RiemannSolver::fast},
                           Scheme{"muscl-hllc", Predictor::muscl, RiemannSolver::hllc}};
  std::vector<int> threads{1};
  if (cores > 1) threads.push_back(std::max(2, options.threads));
  std::vector<double> const triad{triad_gb_per_s(1), cores > 1 ? triad_gb_per_s(threads.back()) : 0.0};
  for (Medium const& medium : media) {
    for (Scheme const& scheme : schemes) {
      for (std::size_t k = 0; k < threads.size(); ++k) {
        GasGrid grid = gas_wave(medium.eos, medium.base, cells, scheme.predictor, scheme.riemann, threads[k]);
        double const updates = cell_updates_per_s(grid);
        // at least: five conserved averages read, five written, each also fetched before it is written
        constexpr double bytes = 3 * 5 * sizeof(double);
        double const flops = gas_operations(scheme.name, medium.name);
        GridCounters const& n = grid.counters();
        table.rows.push_back({std::string{scheme.name}, std::string{medium.name}, static_cast<long>(threads[k]),
                              updates, updates / threads[k], updates / threads[k] / fma, bytes,
                              static_cast<double>(grid.bytes()) / static_cast<double>(grid.cell_count()), triad[k],
                              1e-9 * bytes * updates / triad[k], flops, fma, 1e-9 * flops * updates / threads[k] / fma,
                              static_cast<double>(n.linear_star) / static_cast<double>(n.faces)});
        options.progress(part_done(table, media.size() * schemes.size() * threads.size()));
      }
    }
  }
  table.facts = {{"isa", std::string{gas_kernels().isa}},
                 {"cells", static_cast<long>(cells)},
                 {"triad_gb_s", triad[0]},
                 {"triad_gb_s_all_threads", triad[1]},
                 {"fma_gflops_per_core", fma}};
  return table;
}

}  // namespace

Benchmark euler3d_bench() {
  return {"euler3d",
          "cell updates of the 3D gas scheme by predictor and equation of state, over the machine's own rates", 40,
          run};
}

}  // namespace g27
