#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "studies/driver/benchmark.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/table_json.hpp"

namespace g27 {

int command_bench(BenchArguments const& arguments) {
  auto benchmarks = all_benchmarks();
  if (!arguments.name.empty()) {
    benchmarks = {find_by_name(benchmarks, arguments.name, "g27 bench")};
  }
  std::vector<double> seconds;
  for (Benchmark const& benchmark : benchmarks) seconds.push_back(benchmark.seconds);
  fmt::print(stderr, "{} benchmark{}, about {}{}\n", benchmarks.size(), benchmarks.size() == 1 ? "" : "s",
             duration_text(std::accumulate(seconds.begin(), seconds.end(), 0.0)),
             benchmarks.size() == 1 ? "" : "; g27 bench NAME runs one of them");
  Progress progress(seconds);
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < benchmarks.size(); ++i) {
    Benchmark const& benchmark = benchmarks[i];
    progress.say(benchmark.name + ": " + benchmark.what);
    Table const table =
        benchmark.run({.cells = arguments.cells, .threads = arguments.threads, .progress = [&](double part) {
                         progress.update(i, part, benchmark.name);
                       }});
    progress.clear();
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
