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
  int interrupted = 0;           ///< the signal that stopped it
  double cpu_s = 0, wall_s = 0;  ///< of the program since it began or resumed
  double peak_bytes = 0;         ///< of the program's memory
  /// every run ended and every judged expectation holds
  [[nodiscard]] bool holds() const;
};

/// Runs side by side on `threads`, each with one thread (a scene with a single run gets them all). Every run writes
/// OUT/NAME.h5 and .xdmf at checkpoints and at its end; a failed one OUT/NAME.failure.json. Throws OutputError.
SceneResult run_scene(Scene const& scene, SceneRunOptions const& options);

/// The same for studies, on all threads where `threads` is 0: a run that fails throws std::runtime_error, one that a
/// signal stops Interrupted.
SceneResult run_whole(Scene const& scene, std::filesystem::path const& out, int threads = 0);

/// One row a run: steps, cell updates per second, share of switched faces, ledger residuals.
Table run_table(Scene const& scene, SceneResult const& result);

/// One row a run on a grid: what was left out, and what a computation that leaves nothing out would have cost.
Table saved_table(Scene const& scene, SceneResult const& result);
/// The figures of that table for one run.
struct Saved {
  double updates = 0;                            ///< cell updates made on the grid
  double skipped_share = 0, unstored_share = 0;  ///< of cell updates; of the cells, when most were stored
  double weak_share = 0;                         ///< of the faces: acoustic star state, no Riemann solver
  double line_updates = 0;                       ///< cell updates on the grid that the line made unnecessary
  double factor = 1;                             ///< cell updates of the whole over those made
};
Saved saved_by(GridRecord const& grid);

}  // namespace g27
