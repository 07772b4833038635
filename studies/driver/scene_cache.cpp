#include "studies/driver/scene_cache.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/driver/earlier_results.hpp"
#include "studies/driver/folder_lock.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/output.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/provenance.hpp"
#include "studies/driver/run_report.hpp"
#include "studies/driver/scene_check.hpp"

namespace g27 {
namespace {

namespace fs = std::filesystem;

fs::path file_of(Scene const& scene, SceneRun const& run, CacheOptions const& options) {
  return cache_folder(scene, options) / (run.name + ".h5");
}

std::string text_of(Hdf5Reader const& in, std::string const& path) { return in.has(path) ? in.read_text(path) : ""; }

CacheState state_of(fs::path const& file, Scene const& scene, SceneRun const& run) {
  if (!fs::exists(file)) return CacheState::absent;
  try {
    Hdf5Reader const in(file);
    bool const complete = in.number_attribute("/run", "complete") != 0;
    BuildFacts const facts = build_facts();
    bool const ours = text_of(in, "/provenance/sources") == facts.sources &&
                      text_of(in, "/provenance/compiler") == facts.compiler &&
                      text_of(in, "/provenance/flags") == facts.flags;
    if (complete) {
      in.verify();
      return ours ? CacheState::finished : CacheState::of_other_program;
    }
    if (!ours) return CacheState::absent;
    check_resumable(file, scene, run);
    return CacheState::unfinished;
  } catch (InputError const&) {  // of another run
    return CacheState::absent;
  } catch (OutputError const&) {  // damaged
    return CacheState::absent;
  }
}

/// "2026-11-28T20:01:11Z in 212 s by 6af381449a1e"
std::string origin_of(Scene const& scene, CacheOptions const& options) {
  double wall = 0;
  std::string date, commit;
  for (std::string const& file : cached_files(scene, options)) {
    Hdf5Reader const in(file);
    wall += in.number_attribute("/run", "wall_s");
    date = in.read_text("/provenance/date"), commit = in.read_text("/provenance/commit");
  }
  return fmt::format("{} in {} by {}", date, duration_text(wall), commit);
}

}  // namespace

fs::path cache_folder(Scene const& scene, CacheOptions const& options) {
  return options.folder / (scene.name + "-" + scene.digest);
}

CacheState cache_state(Scene const& scene, CacheOptions const& options) {
  std::vector<CacheState> states;
  for (SceneRun const& run : scene.runs) states.push_back(state_of(file_of(scene, run, options), scene, run));
  auto const all = [&](CacheState s) {
    return std::all_of(states.begin(), states.end(), [s](auto x) { return x == s; });
  };
  auto const any = [&](CacheState s) { return std::find(states.begin(), states.end(), s) != states.end(); };
  if (all(CacheState::finished)) return CacheState::finished;
  if (any(CacheState::absent) && !any(CacheState::finished) && !any(CacheState::unfinished)) return CacheState::absent;
  return any(CacheState::of_other_program) ? CacheState::of_other_program : CacheState::unfinished;
}

std::vector<std::string> cached_files(Scene const& scene, CacheOptions const& options) {
  std::vector<std::string> files;
  for (SceneRun const& run : scene.runs) files.push_back(file_of(scene, run, options).string());
  return files;
}

int ensure_cached(Scene const& scene, CacheOptions const& options) {
  fs::path const out = cache_folder(scene, options);
  CacheState const state = cache_state(scene, options);
  bool const other = state == CacheState::of_other_program;
  if (state == CacheState::finished || (other && options.any_program)) {
    fmt::print(stderr, "{}: computed {}, reused from {}\n", scene.name, origin_of(scene, options), out.string());
    return 0;
  }
  if (other) {
    fmt::print(stderr, "{}: computed {}, whose sources are not this program's: again (--cached takes it as it is)\n",
               scene.name, origin_of(scene, options));
  }
  bool const resume = state == CacheState::unfinished;
  require_memory(scene);
  for (std::string const& remark : remarks_on(scene)) fmt::print(stderr, "{}\n", remark);
  fmt::print(stderr, "{}: {} {}\n", scene.name, resume ? "goes on in" : "into", out.string());
  FolderLock const lock(out, "g27 figure");
  EarlierResults const earlier(out);
  if (!resume) earlier.set_aside();
  SceneResult const result = run_scene(scene, {.out = out, .threads = options.threads, .resume = resume});
  if (result.interrupted != 0) {
    fmt::print(stderr, "interrupted; the same command goes on from the last checkpoint\n");
    return 128 + result.interrupted;
  }
  write_report(scene, result, out);
  for (auto const& [name, message] : result.failures) fmt::print(stderr, "{} {}: {}\n", scene.name, name, message);
  if (!result.failures.empty()) {
    fmt::print(stderr, "{}: see {}; --from there draws what was reached\n", scene.name, out.string());
    return 1;
  }
  earlier.remove();
  fmt::print(stderr, "{}: computed in {} ({:.0f} s of CPU), {:.0f} MB of memory at most\n", scene.name,
             duration_text(result.wall_s), result.cpu_s, 1e-6 * result.peak_bytes);
  return 0;
}

}  // namespace g27
