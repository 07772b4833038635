#include "studies/driver/python.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "studies/driver/provenance.hpp"

namespace g27 {
namespace {

std::filesystem::path figure_folder() { return std::filesystem::path(build_facts().source_dir) / "studies/figures"; }

int run(std::vector<std::string> const& command, bool quiet) {
  std::vector<char*> argv;
  for (auto const& word : command) {
    argv.push_back(const_cast<char*>(word.c_str()));
  }
  argv.push_back(nullptr);
  pid_t const child = fork();
  if (child == 0) {
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
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
    return -1;
  }
  return WEXITSTATUS(status);
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
  if (std::filesystem::is_directory(figure_folder())) {
    for (auto const& entry : std::filesystem::directory_iterator(figure_folder())) {
      // A leading underscore marks what scripts share.
      if (entry.path().extension() == ".py" && entry.path().filename().string().front() != '_') {
        names.push_back(entry.path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool draw(std::string const& name, std::vector<std::string> const& arguments) {
  std::string const python = find_python();
  if (python.empty()) {
    fmt::print(stderr, "figure {}: no python3 with h5py and matplotlib (apt install python3-h5py python3-matplotlib)\n",
               name);
    return false;
  }
  // -B: no __pycache__ in the source tree
  std::vector<std::string> command{python, "-B", (figure_folder() / (name + ".py")).string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  // written aside and renamed: an interrupted script leaves the old figure or none
  std::filesystem::path const figure = arguments.back();
  auto const aside = std::filesystem::path(figure).replace_filename(figure.stem().string() + ".part.png");
  command.back() = aside.string();
  int const status = run_process(command);
  std::error_code error;
  if (status == 0) {
    std::filesystem::rename(aside, figure, error);
  } else {
    std::filesystem::remove(aside, error);
    fmt::print(stderr, "figure {}: the script failed with status {}\n", name, status);
  }
  return status == 0 && !error;
}

}  // namespace g27
