/// Cell updates of the three-dimensional solid scheme, all of it, and what one costs over a gas update with the same
/// predictor on the same grid, measured in turn. Fractions of the machine's rates as in euler3d.
#include <algorithm>
#include <array>
#include <string>
#include <thread>

#include "scheme/kernel/solid_kernels.hpp"
#include "studies/bench/box_waves.hpp"
#include "studies/bench/operations.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/benchmark.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

constexpr int rounds = 8;  ///< the first of which warms up

struct Material {
  char const *medium, *eos;
  bool yields;
};
constexpr std::array materials{Material{"steel", "linear", false}, Material{"steel", "linear", true},
                               Material{"aluminium", "mie-gruneisen", false},
                               Material{"aluminium", "mie-gruneisen", true}};

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
                          {"flops_per_cell_update", "1"},
                          {"fma_gflops_per_core", "1e9/s"},
                          {"fma_fraction", "1"},
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
      // step by step in turn, so that what else the machine does falls on all of them alike
      GasGrid gas = gas_wave(IdealGas{}, {1.2, 0.0, 1e5}, cells, scheme.predictor, RiemannSolver::fast, threads[k]);
      std::vector<SolidGrid> grids;
      for (Material const& m : materials) {
        SolidMedium const medium = solid_medium(m.medium, m.yields);
        grids.push_back(solid_wave(medium.scheme, medium.rho0, cells, scheme.predictor, threads[k]));
      }
      double gas_best = 1e300;
      std::array<double, materials.size()> best;
      best.fill(1e300);
      for (int round = 0; round < rounds; ++round) {
        double const one = step_time(gas);
        if (round > 0) gas_best = std::min(gas_best, one);
        for (std::size_t i = 0; i < grids.size(); ++i) {
          double const time = step_time(grids[i]);
          if (round > 0) best[i] = std::min(best[i], time);
        }
      }
      for (std::size_t i = 0; i < grids.size(); ++i) {
        double const count = static_cast<double>(grids[i].cell_count()), updates = count / best[i];
        // at least: twelve conserved averages read, twelve written, each also fetched before it is written
        constexpr double bytes = 3 * 12 * sizeof(double);
        double const flops = solid_operations(scheme.name, materials[i].eos, materials[i].yields);
        SolidCounters const& n = grids[i].counters();
        table.rows.push_back({std::string{scheme.name}, std::string{materials[i].eos},
                              std::string{materials[i].yields ? "yielding" : "elastic"}, static_cast<long>(threads[k]),
                              updates, updates / threads[k], updates / threads[k] / fma, best[i] / gas_best, bytes,
                              static_cast<double>(grids[i].bytes()) / count, triad[k],
                              1e-9 * bytes * updates / triad[k], flops, fma, 1e-9 * flops * updates / threads[k] / fma,
                              static_cast<double>(n.tangent) / static_cast<double>(n.faces)});
      }
      options.progress(part_done(table, schemes.size() * threads.size() * materials.size()));
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
          120, run};
}

}  // namespace g27
