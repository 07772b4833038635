#include "studies/driver/python.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "studies/driver/input_error.hpp"
#include "studies/driver/nearest_key.hpp"
#include "studies/driver/provenance.hpp"

namespace g27 {
namespace {

/// Those of the studies and scenes, and those of the paper.
std::vector<std::filesystem::path> figure_folders() {
  std::filesystem::path const source = build_facts().source_dir;
  return {source / "studies/figures", source / "papers/overset_fsi"};
}

std::sig_atomic_t volatile stopped_by = 0;

/// While a script runs, Ctrl-C and SIGTERM are ours: an interpreter would answer with a traceback.
class ChildGuard {
 public:
  ChildGuard() {
    stopped_by = 0;
    struct sigaction action {};
    action.sa_handler = [](int signal) { stopped_by = signal; };  // no SA_RESTART: waitpid returns
    sigaction(SIGINT, &action, &interrupt_);
    sigaction(SIGTERM, &action, &terminate_);
  }
  ~ChildGuard() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
  }
  ChildGuard(ChildGuard const&) = delete;
  ChildGuard& operator=(ChildGuard const&) = delete;

 private:
  struct sigaction interrupt_ {
  }, terminate_{};
};

int run(std::vector<std::string> const& command, bool quiet) {
  std::vector<char*> argv;
  for (auto const& word : command) {
    argv.push_back(const_cast<char*>(word.c_str()));
  }
  argv.push_back(nullptr);
  ChildGuard const guard;
  pid_t const child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_DFL);
    if (quiet) {
      int const null = open("/dev/null", O_WRONLY);
      dup2(null, STDOUT_FILENO);
      dup2(null, STDERR_FILENO);
    } else {
      dup2(STDERR_FILENO, STDOUT_FILENO);
    }
    execvp(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  pid_t ended = child < 0 ? child : waitpid(child, &status, 0);
  while (ended < 0 && child > 0 && errno == EINTR) {
    if (stopped_by != 0) kill(child, SIGTERM);
    ended = waitpid(child, &status, 0);
  }
  if (stopped_by != 0) throw Interrupted{stopped_by};
  return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

int run_process(std::vector<std::string> const& command) { return run(command, false); }

std::string find_python() {
  static std::string const found = [] {
    for (char const* candidate : {"/usr/bin/python3", "python3", "python"}) {
      if (run({candidate, "-c",
               "import importlib.util as u, sys; sys.exit(not all(map(u.find_spec, ('h5py', "
               "'matplotlib'))))"},
              true) == 0) {
        return std::string(candidate);
      }
    }
    return std::string();
  }();
  return found;
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (auto const& folder : figure_folders()) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (auto const& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".py" && entry.path().filename().string().front() != '_') {
        names.push_back(entry.path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::filesystem::path figure_script(std::string const& name) {
  auto const names = figure_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError("g27 figure", name, "there is no figure of that name", suggestion(name, names));
  }
  auto const folders = figure_folders();
  auto const of_studies = folders[0] / (name + ".py");
  return std::filesystem::exists(of_studies) ? of_studies : folders[1] / (name + ".py");
}

bool draw(std::string const& name, std::vector<std::string> const& arguments) {
  return run_script(figure_script(name), arguments);
}

bool run_script(std::filesystem::path const& script, std::vector<std::string> const& arguments) {
  std::string const name = script.stem().string(), python = find_python();
  if (python.empty()) {
    fmt::print(stderr, "figure {}: no python3 with h5py and matplotlib (apt install python3-h5py python3-matplotlib)\n",
               name);
    return false;
  }
  // -B: no __pycache__ in the source tree
  auto const runner = std::filesystem::path(build_facts().source_dir) / "studies/figures/_run.py";
  std::vector<std::string> command{python, "-B", runner.string(), script.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  // drawn in a folder aside, with all of its pages, and moved: an interrupted script leaves the old figure or none
  namespace fs = std::filesystem;
  fs::path const figure = arguments.back(), folder = figure.parent_path();
  fs::path const aside = folder / (figure.stem().string() + ".part");
  std::error_code error;
  fs::create_directory(aside, error);
  if (error) {
    fmt::print(stderr, "figure {}: cannot write to {}: {}\n", name, aside.string(), error.message());
    return false;
  }
  command.back() = (aside / figure.filename()).string();
  int status = -1;
  try {
    status = run_process(command);
  } catch (Interrupted const&) {
    fs::remove_all(aside, error);
    throw;
  }
  if (status == 0) {
    std::vector<fs::path> const pages(fs::directory_iterator(aside), fs::directory_iterator{});
    for (fs::path const& page : pages) {
      if (!error) fs::rename(page, folder / page.filename(), error);
    }
  } else {
    fmt::print(stderr, "figure {}: the script failed with status {}\n", name, status);
  }
  std::error_code ignored;
  fs::remove_all(aside, ignored);
  return status == 0 && !error;
}

}  // namespace g27
