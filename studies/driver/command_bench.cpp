#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/driver/benchmark.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/table_json.hpp"

namespace g27 {

int command_bench(BenchArguments const& arguments) {
  auto benchmarks = all_benchmarks();
  if (!arguments.name.empty()) {
    benchmarks = {find_by_name(benchmarks, arguments.name, "g27 bench")};
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (Benchmark const& benchmark : benchmarks) {
    fmt::print(stderr, "{}: {}\n", benchmark.name, benchmark.what);
    Table const table = benchmark.run({.cells = arguments.cells, .threads = arguments.threads});
    if (arguments.json) {
      nlohmann::ordered_json of_table = to_json(table);
      // a benchmark that was asked for by name is the object itself, with its yardsticks as keys
      if (!arguments.name.empty()) {
        json = {{"benchmark", benchmark.name}};
        json.update(of_table["facts"]);
        json.update(of_table);
      } else {
        json[benchmark.name] = std::move(of_table);
      }
    } else {
      fmt::print("{}\n", to_text(table));
    }
  }
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  }
  return 0;
}

}  // namespace g27
