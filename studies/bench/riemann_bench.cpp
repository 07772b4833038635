/// Time of one Riemann problem with its flux, by equation of state, solver and strength of the jump. The yardstick is
/// HLLC of an ideal gas in the same run: a handful of square roots and divisions, no iteration.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "scheme/kernel/gas_kernels.hpp"
#include "studies/driver/benchmark.hpp"

namespace g27 {

namespace {

struct Faces {
  std::vector<GasState<>> l, r;
};

/// Sides that differ by up to `size` of density, pressure and sound speed; `size` > 1: ratios up to that.
template <class E>
void draw(E const& eos, GasState<> const& base, double size, std::size_t count, std::mt19937_64& random, Faces& out) {
  auto const in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  auto const isentrope = [&](GasState<> const& k, double rho) {  // to first order in ln rho: good enough for data
    double const g = eos.bulk_modulus(k.rho, k.p) / std::max(k.p, 1e-3 * eos.bulk_modulus(k.rho, k.p));
    return k.p * std::pow(rho / k.rho, g);
  };
  for (std::size_t i = 0; i < count; ++i) {
    GasState<> l = base;
    l.rho *= 1 + in(-0.1, 0.1);
    l.p = isentrope(base, l.rho);
    GasState<> r = l;
    double const c = std::sqrt(eos.bulk_modulus(l.rho, l.p) / l.rho);
    l.u = in(-1.5, 1.5) * c;
    if (size <= 1) {
      r.rho *= 1 + in(-size, size);
      r.p = isentrope(l, r.rho) * (1 + in(-size, size));
      r.u = l.u + in(-size, size) * c;
    } else {
      r.p *= std::exp(in(-1, 0) * std::log(size));
      r.rho *= std::pow(r.p / l.p, 0.5);
      r.u = l.u + in(-1, 1) * c;
      if (i % 2 == 1) std::swap(l, r);
    }
    if (eos.pressure_margin(r.rho, r.p) <= 0 || eos.pressure_margin(l.rho, l.p) <= 0) r = l;
    out.l.push_back(l), out.r.push_back(r);
  }
}

/// CPU nanoseconds a face: the least of several repetitions.
double time_faces(EosKernels::Solve solve, void const* eos, Faces const& faces, std::size_t& failures) {
  std::size_t const n = faces.l.size(), padded = n + 16;
  std::vector<std::vector<double>> fields(24, std::vector<double>(padded, 0.0));
  auto field = [&, next = std::size_t{0}]() mutable { return fields[next++].data(); };
  SolveArguments g{};
  g.faces = n, g.eos = eos;
  // no cell to fall back to: its state is below any side's
  g.rho = field(), g.u = field(), g.p = field(), g.margin = field(), g.w = field();
  g.l_rho = field(), g.l_u = field(), g.l_p = field(), g.r_rho = field(), g.r_u = field(), g.r_p = field();
  g.s_rho = field(), g.s_u = field(), g.s_p = field(), g.strong = field();
  g.f_mass = field(), g.f_momentum = field(), g.f_energy = field(), g.face_p = field(), g.face_u = field();
  for (std::size_t i = 0; i < padded; ++i) {
    std::size_t const j = std::min(i, n - 1);  // the padding repeats the last face
    g.l_rho[i] = faces.l[j].rho, g.l_u[i] = faces.l[j].u, g.l_p[i] = faces.l[j].p;
    g.r_rho[i] = faces.r[j].rho, g.r_u[i] = faces.r[j].u, g.r_p[i] = faces.r[j].p;
    g.strong[i] = i < n ? 1.0 : 0.0;
  }
  double best = 1e300;
  std::clock_t const start = std::clock();
  for (int i = 0; i < 200 && (i < 3 || std::clock() - start < CLOCKS_PER_SEC / 20); ++i) {
    std::timespec a{}, b{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
    solve(g);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
    double const ns = 1e9 * static_cast<double>(b.tv_sec - a.tv_sec) + static_cast<double>(b.tv_nsec - a.tv_nsec);
    best = std::min(best, ns / static_cast<double>(n));
  }
  failures = g.failures;
  return best;
}

struct Medium {
  AnyEos eos;
  GasState<> base;
};

Table run(BenchmarkOptions const& options) {
  std::size_t const n = options.cells > 0 ? static_cast<std::size_t>(options.cells) : 4096;
  GasKernels const& kernels = gas_kernels();
  Table table{
      .name = "riemann",
      .title = "time of one Riemann problem with its flux",
      .columns = {{"eos", "1"}, {"jump", "1"}, {"solver", "1"}, {"time", "ns"}, {"over_hllc", "1"}, {"failed", "1"}},
      .rows = {},
      .facts = {{"isa", std::string{kernels.isa}},
                {"lanes", static_cast<long>(kernels.predict->width)},
                {"faces", static_cast<long>(n)}}};
  Medium const media[] = {{IdealGas{}, {1.2, 0, 1e5}}, {StiffenedGas{}, {1000, 0, 1e9}}, {Jwl{}, {1650, 0, 1.1e10}}};
  struct Data {
    char const* name;
    double size;
  };
  std::array const jumps{Data{"1 %", 0.01}, Data{"10 %", 0.1}, Data{"ratio 1000", 1000}, Data{"mixed", 0}};
  for (Medium const& medium : media) {
    std::visit(
        [&]<class E>(E const& eos) {
          std::size_t const law = medium.eos.index();
          for (Data const& data : jumps) {
            std::mt19937_64 random(1);
            Faces faces;
            if (data.size > 0) {
              draw(eos, medium.base, data.size, n, random, faces);
            } else {
              // as around a shock: most faces are smooth, and neighbours are alike
              for (std::size_t done = 0; done < n; done += 64) {
                std::size_t const block = std::min<std::size_t>(64, n - done), strong = block / 16;
                draw(eos, medium.base, 0.01, block - 2 * strong, random, faces);
                draw(eos, medium.base, 0.1, strong, random, faces);
                draw(eos, medium.base, 1000, strong, random, faces);
              }
            }
            auto const time = [&](RiemannSolver solver, std::size_t& failures) {
              return time_faces(kernels.eos[law]->solve[static_cast<std::size_t>(solver)], &eos, faces, failures);
            };
            std::size_t failures = 0;
            double const hllc = time(RiemannSolver::hllc, failures);
            auto const row = [&](char const* solver, double ns) {
              table.rows.push_back({std::string{E::name}, std::string{data.name}, std::string{solver}, ns, ns / hllc,
                                    static_cast<long>(failures)});
            };
            row("hllc", hllc);
            double const fast = time(RiemannSolver::fast, failures);
            row("fast", fast);
            double const exact = time(RiemannSolver::exact, failures);
            row("exact", exact);
            options.progress(part_done(table, std::size(media) * jumps.size() * 3));
          }
        },
        medium.eos);
  }
  return table;
}

}  // namespace

Benchmark riemann_bench() {
  return {"riemann", "one Riemann problem: fast, exact and HLLC solvers by equation of state and jump", 2, run};
}

}  // namespace g27
