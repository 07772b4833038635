/// Cell updates of the three-dimensional gas scheme, all of it: exact Riemann solver, switches, cure, repairs, ledger.
/// The yardsticks of the machine are measured in the same run, so that rates of two machines can be compared.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>

#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/gas_grid.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/benchmark.hpp"

namespace g27 {

namespace {

/// An oblique wave of 1 % over the whole box.
GasGrid smooth_flow(AnyEos const& eos, GasState<> const& base, int cells, Predictor predictor, RiemannSolver riemann,
                    int threads) {
  GasGridSetup setup{.eos = eos, .cells = {cells, cells, cells}};
  for (GridBoundary& b : setup.sides) b.kind = GridBoundary::Kind::periodic;
  setup.options.predictor = predictor, setup.options.riemann = riemann, setup.options.threads = threads;
  GasGrid grid(std::move(setup));
  double const K = std::visit([&](auto const& e) { return e.bulk_modulus(base.rho, base.p); }, eos);
  double const c = std::sqrt(K / base.rho);
  grid.set_state(
      [&](Vec3 const& x) {
        double const wave = 0.01 * std::sin(2.0 * std::numbers::pi * (x[0] + x[1] + 2.0 * x[2]));
        return GasPoint{base.rho * (1.0 + wave), {0.3 * c * (1.0 + wave), 0.2 * c, 0.1 * c}, base.p + K * wave};
      },
      1);
  return grid;
}

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
                  {"fma_gflops_per_core", "1e9/s"},
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
        GasGrid grid = smooth_flow(medium.eos, medium.base, cells, scheme.predictor, scheme.riemann, threads[k]);
        double best = 1e300;
        for (int step = 0; step < 6; ++step) {
          auto const start = std::chrono::steady_clock::now();
          if (grid.step(1e300).status != StepStatus::ok) throw std::runtime_error("euler3d: a step failed");
          double const one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
          if (step > 0) best = std::min(best, one);
        }
        double const updates = static_cast<double>(grid.cell_count()) / best;
        // at least: five conserved averages read, five written, each also fetched before it is written
        constexpr double bytes = 3 * 5 * sizeof(double);
        GridCounters const& n = grid.counters();
        table.rows.push_back({std::string{scheme.name}, std::string{medium.name}, static_cast<long>(threads[k]),
                              updates, updates / threads[k], updates / threads[k] / fma, bytes,
                              static_cast<double>(grid.bytes()) / static_cast<double>(grid.cell_count()), triad[k],
                              1e-9 * bytes * updates / triad[k], fma,
                              static_cast<double>(n.linear_star) / static_cast<double>(n.faces)});
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
          "cell updates of the 3D gas scheme by predictor and equation of state, over the machine's own rates", run};
}

}  // namespace g27
