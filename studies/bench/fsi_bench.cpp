/// What bodies cost: a steel cube of 14 cells an edge in a wind, per triangle and step, and by parts of the step.
#include <algorithm>
#include <stdexcept>
#include <thread>

#include "fsi/surface/shapes.hpp"
#include "scheme/kernel/gas_kernels.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/benchmark.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

namespace {

constexpr int edge_cells = 14, warm_up = 2, steps = 8;

/// A wind of Mach 0.5 past the cube at rest, so that nothing is uniform; `cells` of gas along the box's edge.
OversetSetup windy_cube(int cells, Predictor predictor, int threads) {
  SolidMedium const steel = solid_medium("steel", true);
  double const size = 0.01, h = size / edge_cells, box = h * cells;
  OversetSetup s{.gas = gas_cube(IdealGas{1.4}, box, cells), .bodies = {}};
  Vec3 const middle{0.503 * box, 0.507 * box, 0.493 * box};
  BodySetup b{.surface = placed(make_box({size, size, size}, h), {0.3, 0.5, 1}, 0.6, middle),
              .material = steel.scheme,
              .cell = h,
              .initial = [=](Vec3 const&) {
                return solid_state(steel, steel.rho0 * (1 + 1e9 / 175e9), {0, 0, 0}, 1e9);
              }};
  auto const around = bounding_box(b.surface);
  b.lower = around.lower, b.upper = around.upper;
  s.bodies.push_back(std::move(b));
  s.gas.options.predictor = s.solid_options.predictor = s.local.predictor = predictor;
  s.gas.options.threads = s.solid_options.threads = threads;
  return s;
}

Table run(BenchmarkOptions const& options) {
  int const cells = options.cells > 0 ? options.cells : 64;
  if (cells < 32) throw std::invalid_argument("bench fsi needs 32 cells or more: the cube has 14");
  int const cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Table table{.name = "fsi",
              .title = "time of a step with a steel cube of 14 cells an edge, and its parts, by wall clock",
              .columns = {{"scheme", "1"},
                          {"threads", "1"},
                          {"triangles", "1"},
                          {"us_per_triangle_step", "us"},
                          {"step_ms", "ms"},
                          {"local_ms", "ms"},
                          {"gas_ms", "ms"},
                          {"solid_ms", "ms"},
                          {"geometry_ms", "ms"},
                          {"fill_ms", "ms"},
                          {"share_of_bodies", "1"}},
              .rows = {},
              .facts = {}};
  std::vector<int> threads{1};
  if (cores > 1) threads.push_back(std::max(2, options.threads));
  for (Predictor predictor : {Predictor::godunov, Predictor::linear}) {
    for (int n : threads) {
      OversetSolver solver(windy_cube(cells, predictor, n), [](Vec3 const&) {
        return GasPoint{780, {670, 100, -50}, 1e9};
      });
      OversetCounters before;
      for (int k = 0; k < warm_up + steps; ++k) {
        if (k == warm_up) before = solver.counters();
        if (solver.step(1e300).status != StepStatus::ok) throw std::runtime_error("bench fsi: a step failed");
      }
      OversetCounters const& after = solver.counters();
      auto const ms = [&](double OversetCounters::*part) { return 1e3 * (after.*part - before.*part) / steps; };
      double const local = ms(&OversetCounters::seconds_local), gas = ms(&OversetCounters::seconds_gas),
                   solid = ms(&OversetCounters::seconds_solid), geometry = ms(&OversetCounters::seconds_geometry),
                   fill = ms(&OversetCounters::seconds_fill), all = local + gas + solid + geometry + fill;
      double const problems = static_cast<double>(after.problems - before.problems) / steps;
      table.rows.push_back({std::string{predictor == Predictor::godunov ? "godunov" : "modified"}, static_cast<long>(n),
                            static_cast<long>(problems), 1e3 * n * local / problems, all, local, gas, solid, geometry,
                            fill, 1 - gas / all});
      options.progress(part_done(table, 2 * threads.size()));
    }
  }
  table.facts = {{"isa", std::string{gas_kernels().isa}},
                 {"cells", static_cast<long>(cells)},
                 {"fma_gflops_per_core", fma_gflops_per_core()}};
  return table;
}

}  // namespace

Benchmark fsi_bench() {
  return {"fsi", "what a body costs: time of a triangle's step (threads x wall clock), and its share of the step", 15,
          run};
}

}  // namespace g27
