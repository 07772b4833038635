#pragma once
/// Runs every run of a scene, writes its results and judges them.
#include <filesystem>
#include <map>
#include <vector>

#include "studies/driver/verdict.hpp"

namespace g27 {

struct SceneRunOptions {
  std::filesystem::path out;
  int threads = 1;
  bool resume = false;
  double checkpoint_s = 30;
};

struct SceneResult {
  std::map<std::string, RunRecord> records;     ///< by run name
  std::map<std::string, std::string> failures;  ///< message by run name
  std::vector<Judgement> judgements;
  bool interrupted = false;
  /// every run ended and every judged expectation holds
  [[nodiscard]] bool holds() const;
};

/// Runs side by side on `threads`, each with one thread (a scene with a single run gets them all). Every run writes
/// OUT/NAME.h5 and .xdmf at checkpoints and at its end; a failed one OUT/NAME.failure.json. Throws OutputError.
SceneResult run_scene(Scene const& scene, SceneRunOptions const& options);

/// One row a run: steps, cell updates per second, share of switched faces, ledger residuals.
Table run_table(Scene const& scene, SceneResult const& result);

}  // namespace g27
