#include "studies/bench/yardsticks.hpp"

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace g27 {

namespace {

double wall_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

using Vector512 [[gnu::vector_size(64)]] = double;
using Vector256 [[gnu::vector_size(32)]] = double;
using Vector128 [[gnu::vector_size(16)]] = double;

/// Ten independent chains hide the latency of two units; returns a value so that nothing is removed.
template <class Vector>
[[gnu::always_inline]] inline double chains(long rounds) {
  Vector a[10];
  Vector const m = Vector{} + 0.999999, b = Vector{} + 1e-6;
  for (int k = 0; k < 10; ++k) a[k] = Vector{} + 0.1 * k;
  for (long i = 0; i < rounds; ++i) {
#pragma GCC unroll 10
    for (int k = 0; k < 10; ++k) a[k] = a[k] * m + b;
  }
  Vector sum{};
  for (int k = 0; k < 10; ++k) sum += a[k];
  return sum[0];
}

#if defined(__x86_64__)
__attribute__((target("avx512f,fma,prefer-vector-width=512"), noinline)) double chains_512(long rounds) {
  return chains<Vector512>(rounds);
}
__attribute__((target("avx2,fma"), noinline)) double chains_256(long rounds) { return chains<Vector256>(rounds); }
#endif
__attribute__((noinline)) double chains_128(long rounds) { return chains<Vector128>(rounds); }

}  // namespace

double process_cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double triad_gb_per_s(int threads) {
  constexpr std::ptrdiff_t n = 8 << 20;  // 64 MiB an array: beyond the caches
  std::vector<double> a(n), b(n, 1.0), c(n, 2.0);
  double best = 1e300;
  for (int round = 0; round < 6; ++round) {
    double const start = wall_seconds();
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < n; ++i)
      a[static_cast<std::size_t>(i)] = b[static_cast<std::size_t>(i)] + 0.5 * c[static_cast<std::size_t>(i)];
    best = std::min(best, wall_seconds() - start);
    b[static_cast<std::size_t>(round)] = a[static_cast<std::size_t>(n / 2)];
  }
  return 24e-9 * static_cast<double>(n) / best;
}

double fma_gflops_per_core() {
  double (*run)(long) = chains_128;
  double width = 2;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) run = chains_256, width = 4;
  if (__builtin_cpu_supports("avx512f")) run = chains_512, width = 8;
#endif
  constexpr long rounds = 2'000'000;
  double best = 1e300;
  double volatile kept = 0;
  for (int round = 0; round < 12; ++round) {
    double const start = process_cpu_seconds();
    kept = kept + run(rounds);
    best = std::min(best, process_cpu_seconds() - start);
  }
  return 1e-9 * 2.0 * width * 10.0 * static_cast<double>(rounds) / best;
}

}  // namespace g27
