#pragma once
/// Runs of scenes through the program's own path, in one piece or in many.
#include "studies/driver/grid_output.hpp"
#include "studies/driver/output.hpp"
#include "studies/driver/simulate.hpp"
#include "tests/catch.hpp"

namespace g27 {

/// Runs to the end, stopping after every `steps` steps (0: never) to go through the file. The line of a grid's first
/// phase is never stopped, since it would start over.
inline RunRecord run_in_pieces(Scene const& scene, std::filesystem::path const& file, int steps,
                               std::size_t which = 0) {
  SceneRun const& run = scene.runs.at(which);
  RunRecord record(run);
  for (int pieces = 0; !record.complete; ++pieces) {
    REQUIRE(pieces < 1000);
    int left = steps;
    // Asked twice a step once it says so: when it decides and when it leaves.
    RunHooks const hooks{
        .progress = [](double) {},
        .checkpoint = [](RunRecord const&) {},
        .checkpoint_s = 1e9,
        .snapshot = [&](std::size_t i, GridSnapshot const& s) { write_grid_state(file, run, i, s); },
        .interrupted = [&] { return steps > 0 && (!record.grid || record.grid->begun) && --left <= 0; }};
    simulate(run, record, hooks);
    write_run(file, scene, run, record, 1);
    record = read_run(file, scene, run);
  }
  return record;
}

}  // namespace g27
