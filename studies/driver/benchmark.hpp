#pragma once
/// A benchmark (`g27 bench NAME`): rates measured beside a yardstick of the machine in the same run.
/// One file a benchmark: `studies/bench/NAME_bench.cpp` defines `Benchmark NAME_bench()`.
#include <functional>
#include <string>
#include <vector>

#include "studies/driver/table.hpp"

namespace g27 {

struct BenchmarkOptions {
  int cells = 0;  ///< 0: the benchmark's own choice
  int threads = 1;
};

struct Benchmark {
  std::string name, what;
  std::function<Table(BenchmarkOptions const&)> run;
};

std::vector<Benchmark> all_benchmarks();

}  // namespace g27
