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
  std::function<void(double)> progress = [](double) {};  ///< called with the part of the rows that is done
};

struct Benchmark {
  std::string name, what;
  double seconds;  ///< that it takes, about, at its own choice of cells
  std::function<Table(BenchmarkOptions const&)> run;
};

/// Of a table that will have `rows` rows.
inline double part_done(Table const& table, std::size_t rows) {
  return static_cast<double>(table.rows.size()) / static_cast<double>(rows);
}

std::vector<Benchmark> all_benchmarks();

}  // namespace g27
