#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "studies/driver/command.hpp"
#include "studies/driver/earlier_results.hpp"
#include "studies/driver/early_end.hpp"
#include "studies/driver/folder_lock.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/run_report.hpp"
#include "studies/driver/scene_check.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"

namespace g27 {
namespace {

/// The default figure of every variant: profiles, x-t map and history of its runs together.
/// One figure a variant; false when one could not be drawn.
bool draw_variants(Scene const& scene, SceneResult const& result, std::filesystem::path const& out) {
  bool drawn = true;
  std::vector<std::string> variants;
  for (SceneRun const& run : scene.runs) {
    if (variants.empty() || variants.back() != run.variant) {
      variants.push_back(run.variant);
    }
  }
  for (std::string const& variant : variants) {
    std::vector<std::string> files;
    std::string name;
    for (SceneRun const& run : scene.runs) {
      if (run.variant == variant && result.records.contains(run.name)) {
        files.push_back((out / (run.name + ".h5")).string());
        name = run.name.substr(0, run.name.size() - run.scheme.size() - 1);
      }
    }
    if (!files.empty()) {
      files.push_back((out / (name + ".png")).string());
      auto const& grid = scene.runs[0].grid;
      drawn = draw(!grid ? "scene" : grid->bodies.empty() ? "scene-nd" : "scene-bodies", files) && drawn;
    }
  }
  return drawn;
}

std::string quoted(std::string const& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%") ==
      std::string::npos) {
    return word;
  }
  std::string out = "'";
  for (char const c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The command that goes on from the checkpoints in `out`.
std::string resume_command(RunArguments const& arguments, std::filesystem::path const& out) {
  char const* const launcher = std::getenv("G27_LAUNCHER");  // as the user called it
  std::string command = (launcher != nullptr ? quoted(launcher) : "g27") + " run " + quoted(arguments.scene);
  for (std::string const& assignment : arguments.set) command += " --set " + quoted(assignment);
  if (arguments.threads > 0) command += fmt::format(" --threads {}", arguments.threads);
  if (arguments.checkpoint_s != RunArguments{}.checkpoint_s) {
    command += fmt::format(" --checkpoint {}", arguments.checkpoint_s);
  }
  if (!arguments.figures) command += " --no-figures";
  return command + " --out " + quoted(out.string()) + " --resume";
}

bool has_checkpoint(Scene const& scene, std::filesystem::path const& out) {
  return std::any_of(scene.runs.begin(), scene.runs.end(),
                     [&](SceneRun const& run) { return std::filesystem::exists(out / (run.name + ".h5")); });
}

}  // namespace

int command_run(RunArguments const& arguments) {
  std::filesystem::path const file = find_scene(arguments.scene);
  Scene const scene = read_scene(file, without_what_is_beyond(file, arguments.set));
  std::filesystem::path const out = arguments.out.empty() ? "results/" + scene.name : arguments.out;
  if (arguments.resume && !has_checkpoint(scene, out)) {
    throw InputError("g27 run", "--resume", fmt::format("there is no checkpoint of this scene in {}", out.string()),
                     "leave --resume out to start anew, or name the folder of the run by --out");
  }
  require_memory(scene);
  for (std::string const& remark : remarks_on(scene)) fmt::print(stderr, "{}\n", remark);
  FolderLock const lock(out, "g27 run");
  fmt::print(stderr, "{}: {} run{} into {}\n", scene.title, scene.runs.size(), scene.runs.size() == 1 ? "" : "s",
             out.string());
  EarlierResults const earlier(out);
  if (!arguments.resume) earlier.set_aside();
  SceneResult const result = run_scene(scene, {.out = out,
                                               .threads = threads_or_all(arguments.threads),
                                               .resume = arguments.resume,
                                               .checkpoint_s = arguments.checkpoint_s});
  if (result.interrupted != 0) {
    bool const saved = has_checkpoint(scene, out);
    fmt::print(stderr, "interrupted; {}\n",
               saved ? "to continue: " + resume_command(arguments, out) : "nothing was saved yet");
    return 128 + result.interrupted;
  }
  RunReport const report = write_report(scene, result, out);
  if (result.failures.empty()) earlier.remove();
  for (auto const& [name, message] : result.failures) {
    fmt::print(stderr, "failed: {}\n  see {}/{}.failure.json\n", message, out.string(), name);
  }
  bool drawn = true;
  if (arguments.figures) {
    drawn = draw_variants(scene, result, out);
    if (!drawn) fmt::print(stderr, "a figure could not be drawn; the results themselves are complete\n");
  }
  fmt::print(stderr, "results, tables{} are in {}\n", arguments.figures && drawn ? " and figures" : "", out.string());
  if (arguments.json) {
    fmt::print("{}\n", report.summary);
  } else {
    for (Table const& table : report.tables) {
      fmt::print("{}\n", to_text(table));
    }
    if (!result.judgements.empty()) {
      fmt::print("{}\n", result.holds() ? "Every judged figure holds." : "A JUDGED FIGURE FAILS.");
    }
  }
  return result.holds() && drawn ? 0 : 1;
}

}  // namespace g27
