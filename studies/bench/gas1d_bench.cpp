/// Cell updates of the one-dimensional gas scheme by predictor, flux and equation of state. The yardstick is a copy of
/// the bytes that an update must at least move, in arrays of the same size and in the same run.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/gas_line.hpp"
#include "studies/driver/benchmark.hpp"

namespace g27 {

namespace {

/// Per cell: mass, momentum, energy, rho, u, p, K and pressure margin, each read and written once.
constexpr std::size_t fields = 8, bytes_per_update = 2 * fields * sizeof(double);

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// CPU time of one call of `work`: the least of `rounds` means over `calls` [s].
template <class Work>
double least_time(int rounds, int calls, Work const& work) {
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    double const start = cpu_seconds();
    for (int k = 0; k < calls; ++k) work();
    best = std::min(best, (cpu_seconds() - start) / calls);
  }
  return best;
}

double copy_seconds(std::size_t cells) {
  std::vector<double> from(fields * cells, 1.0), to(fields * cells, 0.0);
  return least_time(20, 20, [&] {
    std::memcpy(to.data(), from.data(), from.size() * sizeof(double));
    from[0] = to[cells / 2] + 1.0;  // each copy differs
  });
}

/// Three quarters of smooth waves of 5 %, one quarter with a pressure jump of 5:1 every 64 cells.
GasLine make_line(AnyEos const& eos, GasState<> const& base, std::size_t cells, Predictor predictor,
                  RiemannSolver riemann, int threads) {
  GasLineSetup setup{.eos = eos,
                     .faces = {},
                     .symmetry = Symmetry::planar,
                     .left = {},
                     .right = {},
                     .motion = {},
                     .source = {},
                     .options = {}};
  for (std::size_t f = 0; f <= cells; ++f) setup.faces.push_back(static_cast<double>(f) / static_cast<double>(cells));
  setup.left.kind = setup.right.kind = GasBoundary::Kind::periodic;
  setup.options.predictor = predictor, setup.options.riemann = riemann, setup.options.threads = threads;
  GasLine line(std::move(setup));
  double const c =
      std::visit([&](auto const& e) { return std::sqrt(e.bulk_modulus(base.rho, base.p) / base.rho); }, eos);
  double const period = static_cast<double>(cells) / 128.0;
  line.set_state(
      [&](double x) -> GasState<> {
        double const wave = 0.05 * std::sin(8.0 * std::numbers::pi * x), phase = x * period - std::floor(x * period);
        double const p = x < 0.25 && phase < 0.5 ? 5.0 * base.p : base.p * (1.0 + wave);
        return {base.rho * (1.0 + wave), 0.3 * c * (1.0 + wave), p};
      },
      1);
  return line;
}

Table run(BenchmarkOptions const& options) {
  std::size_t const cells = options.cells > 0 ? static_cast<std::size_t>(options.cells) : 4096;
  double const copy = copy_seconds(cells);
  Table table{
      .name = "gas1d",
      .title = "cell updates of the 1D gas scheme, least CPU time; copy: the same bytes in arrays of the same size",
      .columns = {{"scheme", "1"},
                  {"flux", "1"},
                  {"eos", "1"},
                  {"cell_updates_per_s", "1/s"},
                  {"time", "ns"},
                  {"over_copy", "1"},
                  {"weak_faces", "1"}},
      .rows = {},
      .facts = {{"isa", std::string{gas_kernels().isa}},
                {"cells", static_cast<long>(cells)},
                {"threads", static_cast<long>(options.threads)},
                {"bytes per cell update", static_cast<long>(bytes_per_update)},
                {"copy, GB/s", 1e-9 * static_cast<double>(bytes_per_update * cells) / copy}}};
  struct Medium {
    char const* name;
    AnyEos eos;
    GasState<> base;
  };
  std::array const media{Medium{"ideal", IdealGas{}, {1.2, 0.0, 1e5}}, Medium{"jwl", Jwl{}, {1650.0, 0.0, 1.1e10}}};
  std::array const schemes{std::pair{"godunov", Predictor::godunov}, std::pair{"linear", Predictor::linear},
                           std::pair{"parabolic", Predictor::parabolic}, std::pair{"muscl", Predictor::muscl}};
  std::array const fluxes{std::pair{"fast", RiemannSolver::fast}, std::pair{"exact", RiemannSolver::exact},
                          std::pair{"hllc", RiemannSolver::hllc}};
  for (Medium const& medium : media) {
    for (auto const& [flux, riemann] : fluxes) {
      for (auto const& [scheme, predictor] : schemes) {
        GasLine line = make_line(medium.eos, medium.base, cells, predictor, riemann, options.threads);
        double const step = least_time(12, 8, [&] {
          if (line.step(1e300).status != StepStatus::ok) throw std::runtime_error("gas1d: a step failed");
        });
        GasCounters const& n = line.counters();
        table.rows.push_back({std::string{scheme}, std::string{flux}, std::string{medium.name},
                              static_cast<double>(cells) / step, 1e9 * step / static_cast<double>(cells), step / copy,
                              static_cast<double>(n.linear_star) / static_cast<double>(n.faces)});
        options.progress(part_done(table, media.size() * fluxes.size() * schemes.size()));
      }
    }
  }
  return table;
}

}  // namespace

Benchmark gas1d_bench() {
  return {"gas1d", "cell updates of the 1D gas scheme by predictor, flux and equation of state", 1, run};
}

}  // namespace g27
