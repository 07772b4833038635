#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/nearest_key.hpp"
#include "studies/driver/python.hpp"

namespace g27 {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> hdf5_files(fs::path const& from) {
  if (!fs::is_directory(from)) {
    return fs::exists(from) ? std::vector{from.string()} : std::vector<std::string>{};
  }
  std::vector<std::string> files;
  for (auto const& entry : fs::directory_iterator(from)) {
    if (entry.path().extension() == ".h5") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int command_figure(FigureArguments const& arguments) {
  auto const names = figure_names();
  if (std::find(names.begin(), names.end(), arguments.name) == names.end()) {
    throw InputError("g27 figure", arguments.name, "there is no figure of that name",
                     suggestion(arguments.name, names));
  }
  fs::path const from = !arguments.from.empty()     ? fs::path(arguments.from)
                        : arguments.name == "scene" ? fs::path("results/tnt-rdx-sphere")
                                                    : fs::path("results/studies") / arguments.name / "study.h5";
  auto files = hdf5_files(from);
  if (files.empty()) {
    throw InputError("g27 figure", "--from", fmt::format("there are no results in {}", from.string()),
                     arguments.name == "scene" ? "run a scene first: g27 run"
                                               : fmt::format("run the study first: g27 study {}", arguments.name));
  }
  make_output_folder(arguments.out);
  fs::path const figure = fs::path(arguments.out) / (arguments.name + ".png");
  files.push_back(figure.string());
  if (!draw(arguments.name, files)) {
    throw OutputError(fmt::format("figure {} was not drawn", arguments.name));
  }
  fmt::print("{}\n", figure.string());
  return 0;
}

}  // namespace g27
