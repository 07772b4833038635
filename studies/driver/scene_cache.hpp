#pragma once
/// Results of scenes that are kept for figures: computed once, resumed where they were stopped, reused after that.
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/scene.hpp"

namespace g27 {

struct CacheOptions {
  std::filesystem::path folder = "results/cache";
  int threads = 1;
  bool any_program = false;  ///< takes results of another program's sources as well
};

enum class CacheState {
  absent,
  unfinished,  ///< a checkpoint of this program
  finished,    ///< of this program
  of_other_program
};

/// FOLDER/SCENE-DIGEST
std::filesystem::path cache_folder(Scene const& scene, CacheOptions const& options);
CacheState cache_state(Scene const& scene, CacheOptions const& options);
/// Of the runs, in their order.
std::vector<std::string> cached_files(Scene const& scene, CacheOptions const& options);

/// Makes the results of `scene` and says on stderr how. Returns 0, 1 when a run failed, or 128 + the signal that
/// stopped it. Throws InputError, OutputError.
int ensure_cached(Scene const& scene, CacheOptions const& options);

}  // namespace g27
