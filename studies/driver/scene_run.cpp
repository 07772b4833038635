#include "studies/driver/scene_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <exception>
#include <mutex>
#include <thread>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/grid_output.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/output.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/simulate.hpp"

namespace g27 {
namespace {

volatile std::sig_atomic_t stop_requested = 0;  ///< the signal

/// Ctrl-C and SIGTERM end a run at its next step with a checkpoint; a second Ctrl-C kills.
class SignalGuard {
 public:
  SignalGuard() {
    stop_requested = 0;
    old_interrupt_ = std::signal(SIGINT, handle);
    old_terminate_ = std::signal(SIGTERM, handle);
  }
  ~SignalGuard() {
    std::signal(SIGINT, old_interrupt_);
    std::signal(SIGTERM, old_terminate_);
  }
  SignalGuard(SignalGuard const&) = delete;
  SignalGuard& operator=(SignalGuard const&) = delete;

 private:
  static void handle(int signal) {
    stop_requested = signal;
    std::signal(signal, SIG_DFL);
  }
  void (*old_interrupt_)(int);
  void (*old_terminate_)(int);
};

struct Usage {
  double cpu_s, peak_bytes;
};
/// Of this process so far.
Usage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  auto const seconds = [](timeval const& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(used.ru_utime) + seconds(used.ru_stime), 1024.0 * static_cast<double>(used.ru_maxrss)};
}

/// Work of a run up to a factor: cells x steps, the step being in proportion to the smallest cell.
double weight(SceneRun const& run) {
  if (run.grid) {
    double finest = 1e300;
    for (std::size_t d = 0; d < static_cast<std::size_t>(run.dimensions()); ++d) {
      finest = std::min(finest, (run.grid->setup.upper[d] - run.grid->setup.lower[d]) / run.grid->setup.cells[d]);
    }
    return static_cast<double>(run.cells()) * (run.end - run.start) / finest;
  }
  auto const& x = run.setup.faces;
  double smallest = x.back() - x.front();
  for (std::size_t i = 1; i < x.size(); ++i) {
    smallest = std::min(smallest, x[i] - x[i - 1]);
  }
  return static_cast<double>(x.size()) * (run.end - run.start) / smallest;
}

/// What `read` gives of a file to resume from, whose damage the user must mend.
template <class Read>
auto from_checkpoint(std::filesystem::path const& file, Read const& read) {
  try {
    return read();
  } catch (OutputError const& damage) {
    throw InputError(file.string(), "--resume", damage.what(),
                     "restore the file from a copy, or start again without --resume");
  }
}

}  // namespace

bool SceneResult::holds() const {
  return failures.empty() && interrupted == 0 &&
         std::all_of(judgements.begin(), judgements.end(), [](Judgement const& j) { return !j.judged || j.holds(); });
}

SceneResult run_scene(Scene const& scene, SceneRunOptions const& options) {
  make_output_folder(options.out);
  SignalGuard const signals;
  auto const began = std::chrono::steady_clock::now();
  double const cpu_before = usage().cpu_s;
  SceneResult result;
  std::vector<double> weights;
  std::transform(scene.runs.begin(), scene.runs.end(), std::back_inserter(weights), weight);
  Progress progress(weights);
  std::mutex files;  // the HDF5 library is not safe from several threads
  std::atomic<std::size_t> next = 0;
  std::exception_ptr trouble;

  // what cannot be resumed is refused before anything is written
  for (SceneRun const& run : scene.runs) {
    auto const file = options.out / (run.name + ".h5");
    if (options.resume && std::filesystem::exists(file)) {
      from_checkpoint(file, [&] { check_resumable(file, scene, run); });
    }
  }

  auto const work = [&](int threads) {
    for (std::size_t i; !stop_requested && (i = next++) < scene.runs.size();) {
      SceneRun run = scene.runs[i];
      run.set_threads(threads);
      auto const file = options.out / (run.name + ".h5");
      auto const save = [&](RunRecord const& record) {
        std::lock_guard const lock(files);
        write_run(file, scene, run, record, options.threads);
      };
      try {
        RunRecord record(run);
        if (options.resume && std::filesystem::exists(file)) {
          std::lock_guard const lock(files);
          record = from_checkpoint(file, [&] { return read_run(file, scene, run); });
          progress.say(record.complete ? fmt::format("{} is complete already", run.name)
                                       : fmt::format("{} goes on from {:.6g} s", run.name, record.time()));
        }
        simulate(run, record,
                 {.progress = [&](double fraction) { progress.update(i, fraction, run.name); },
                  .checkpoint = save,
                  .checkpoint_s = options.checkpoint_s,
                  .snapshot =
                      [&](std::size_t index, GridSnapshot const& state) {
                        std::lock_guard const lock(files);
                        write_grid_state(file, run, index, state);
                      },
                  .interrupted = [] { return stop_requested != 0; }});
        if (record.complete) {
          progress.update(i, 1, run.name);
          save(record);
        }
        std::lock_guard const lock(files);
        result.records.emplace(run.name, std::move(record));
      } catch (RunFailure const& failure) {
        std::lock_guard const lock(files);
        result.failures[run.name] = failure.what();
        try {
          write_atomically(options.out / (run.name + ".failure.json"), failure.capsule);
        } catch (...) {
          trouble = std::current_exception();
        }
      } catch (...) {
        std::lock_guard const lock(files);
        trouble = std::current_exception();
        next = scene.runs.size();
      }
    }
  };

  auto const workers = std::clamp<std::size_t>(static_cast<std::size_t>(options.threads), 1, scene.runs.size());
  int const threads_each = std::max(1, options.threads / static_cast<int>(workers));
  std::vector<std::thread> pool;
  for (std::size_t i = 1; i < workers; ++i) {
    pool.emplace_back(work, threads_each);
  }
  work(threads_each);
  for (auto& thread : pool) {
    thread.join();
  }
  if (trouble) {
    std::rethrow_exception(trouble);
  }
  result.interrupted = stop_requested;
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  result.cpu_s = usage().cpu_s - cpu_before, result.peak_bytes = usage().peak_bytes;
  result.judgements = judge(scene, result.records);
  return result;
}

SceneResult run_whole(Scene const& scene, std::filesystem::path const& out, int threads) {
  SceneResult result = run_scene(scene, {.out = out, .threads = threads_or_all(threads)});
  for (auto const& [run, why] : result.failures) throw std::runtime_error(fmt::format("{}: {}", run, why));
  if (result.interrupted != 0) throw Interrupted{result.interrupted};
  return result;
}

Table run_table(Scene const& scene, SceneResult const& result) {
  Table table{.name = "runs",
              .title = "Runs",
              .columns = {{"run", "1"},
                          {"cells", "1"},
                          {"steps", "1"},
                          {"wall", "s"},
                          {"updates", "1/s"},
                          {"switched", "%"},
                          {"repaired", "1"},
                          {"floored", "1"},
                          {"mass", "1"},
                          {"energy", "1"}},
              .rows = {},
              .facts = {}};
  for (SceneRun const& run : scene.runs) {
    auto const found = result.records.find(run.name);
    if (found == result.records.end()) {
      continue;
    }
    RunRecord const& record = found->second;
    GasCounters const& c = record.counters();
    auto const count = [](std::uint64_t n) { return static_cast<long>(n); };
    double const faces = std::max(1.0, static_cast<double>(c.faces));
    table.rows.push_back({run.name, count(run.cells()), count(c.steps), record.wall_s,
                          static_cast<double>(c.cell_updates) / std::max(record.wall_s, 1e-9),
                          100 * static_cast<double>(c.switched) / faces, count(c.repaired), count(c.floored),
                          record.mass().residual(), record.energy().residual()});
  }
  return table;
}

}  // namespace g27
