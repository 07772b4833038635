#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/early_end.hpp"
#include "studies/driver/figure_needs.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/provenance.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/scene_cache.hpp"
#include "studies/driver/scene_reader.hpp"

namespace g27 {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

void add_hdf5_files(fs::path const& from, Strings& files) {
  if (fs::is_regular_file(from)) {
    if (!is_hdf5(from)) {
      throw InputError("g27 figure", "--from", fmt::format("{} is no HDF5 file", from.string()),
                       "name a folder of results, or files of it that end with .h5");
    }
    files.push_back(from.string());
  } else if (fs::exists(from / "study.h5")) {
    files.push_back((from / "study.h5").string());  // beside what it was made of
  } else if (fs::is_directory(from)) {
    Strings found;
    for (auto const& entry : fs::directory_iterator(from)) {
      if (entry.path().extension() == ".h5") found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
}

Strings hdf5_files(Strings const& from) {
  Strings files;
  for (std::string const& place : from) {
    std::size_t const before = files.size();
    add_hdf5_files(place, files);
    if (files.size() == before) {
      throw InputError("g27 figure", "--from", fmt::format("there are no results in {}", place),
                       "name a folder or file of results");
    }
  }
  return files;
}

std::vector<FigureNeed> needs_of(fs::path const& script) {
  std::ifstream in(script, std::ios::binary);
  return parse_needs(std::string(std::istreambuf_iterator<char>(in), {}), script.string());
}

CacheOptions cache_options(FigureArguments const& arguments) {
  CacheOptions options;
  options.threads = threads_or_all(arguments.threads);
  options.any_program = arguments.cached;
  return options;
}

bool has_bodies(Scene const& scene) { return scene.runs[0].grid && !scene.runs[0].grid->bodies.empty(); }

/// The scenes that a figure needs, on every grid asked for.
std::vector<Scene> scenes_of(std::vector<FigureNeed> const& needs, FigureArguments const& arguments) {
  std::vector<Scene> scenes;
  auto const grids = arguments.grids.empty() ? std::vector{1.0} : arguments.grids;
  for (FigureNeed const& need : needs) {
    fs::path const file = find_scene(arguments.scene.empty() ? need.scene : arguments.scene);
    for (double const factor : grids) {
      Strings set = need.set;
      auto const add = [&](Strings const& more) { set.insert(set.end(), more.begin(), more.end()); };
      add(coarser(read_overridden(file, set), factor));
      if (!arguments.set.empty()) {
        add(arguments.set);
        add(quick_look(read_overridden(file, set)));
      }
      scenes.push_back(read_scene(file, set));
      if (!has_bodies(scenes.back()) && has_bodies(read_scene(find_scene(need.scene), need.set))) {
        throw InputError("g27 figure", "--scene", fmt::format("{} has no bodies", scenes.back().name),
                         fmt::format("name a scene with bodies, as {} has", need.scene));
      }
    }
  }
  return scenes;
}

bool computed(Scene const& scene, CacheOptions const& options) {
  CacheState const state = cache_state(scene, options);
  return state == CacheState::finished || (options.any_program && state == CacheState::of_other_program);
}

/// The file of the figure; nothing when its script failed.
std::optional<std::string> drawn(FigureArguments const& arguments, std::string const& name, Strings files) {
  make_output_folder(arguments.out);
  std::string const figure = (fs::path(arguments.out) / (name + ".png")).string();
  files.push_back(figure);
  return draw(name, files) ? std::optional(figure) : std::nullopt;
}

void draw_into(FigureArguments const& arguments, std::string const& name, Strings const& files) {
  auto const figure = drawn(arguments, name, files);
  if (!figure) throw OutputError(fmt::format("figure {} was not drawn", name));
  fmt::print("{}\n", *figure);
}

/// Of a study or a scene, from where they write their results.
Strings usual_files(std::string const& name) {
  // a scene for each of the figures of runs
  std::map<std::string, std::string> const scenes{
      {"scene", "tnt-rdx-sphere"}, {"scene-nd", "charge-3d"}, {"scene-bodies", "three-cubes-quick"}};
  auto const scene = scenes.find(name);
  fs::path const from =
      scene != scenes.end() ? fs::path("results") / scene->second : fs::path("results/studies") / name / "study.h5";
  Strings files;
  add_hdf5_files(from, files);
  if (files.empty()) {
    throw InputError("g27 figure", "--from", fmt::format("there are no results in {}", from.string()),
                     scene != scenes.end()
                         ? fmt::format("name another folder, or run a scene first: g27 run {}", scene->second)
                         : fmt::format("run the study first: g27 study {}", name));
  }
  return files;
}

/// HDF5 files of a figure whose results are there, else none: why is said on stderr.
Strings files_there(std::string const& name, FigureArguments const& arguments, CacheOptions const& options) {
  auto const needs = needs_of(figure_script(name));
  Strings files;
  if (needs.empty()) {
    add_hdf5_files(fs::path("results/studies") / name / "study.h5", files);
    return files;
  }
  if (!arguments.scene.empty() && needs.size() > 1) return files;
  try {
    for (Scene const& scene : scenes_of(needs, arguments)) {
      if (!computed(scene, options)) {
        fmt::print(stderr, "{}: left out, {} is not computed\n", name, scene.name);
        return {};
      }
      auto const more = cached_files(scene, options);
      files.insert(files.end(), more.begin(), more.end());
    }
  } catch (InputError const& error) {
    fmt::print(stderr, "{}: left out, {}: {}\n", name, error.key, error.problem);
    return {};
  }
  return files;
}

/// One page of every figure whose results are there; status 1 when one of them could not be drawn.
int gallery(FigureArguments const& arguments) {
  CacheOptions const options = cache_options(arguments);
  Strings words{"results", build_facts().version + " " + build_facts().commit};
  bool complete = true;
  for (std::string const& name : figure_names()) {
    Strings const files = files_there(name, arguments, options);
    if (files.empty()) continue;
    if (auto const figure = drawn(arguments, name, files)) {
      words.push_back(*figure);
    } else {
      complete = false;
    }
  }
  make_output_folder(arguments.out);
  fs::path const page = fs::path(arguments.out) / "gallery.html";
  words.push_back(page.string());
  if (!run_script(fs::path(build_facts().source_dir) / "studies/figures/_gallery.py", words)) {
    throw OutputError("the gallery was not written");
  }
  fmt::print("{}\n", page.string());
  return complete ? 0 : 1;
}

}  // namespace

int command_figure(FigureArguments const& arguments) {
  if (fs::path(arguments.out).extension() == ".png") {
    throw InputError("g27 figure", "--out", fmt::format("'{}' is a file's name; it takes a folder", arguments.out),
                     fmt::format("leave the file out: {}.png is written there", arguments.name));
  }
  if (arguments.name == "gallery") return gallery(arguments);
  auto const needs = needs_of(figure_script(arguments.name));
  bool const of_scenes = !arguments.set.empty() || !arguments.scene.empty() || !arguments.grids.empty();
  if (of_scenes && (needs.empty() || !arguments.from.empty())) {
    throw InputError("g27 figure", "--set", "and --scene and --grids are for figures that compute scenes",
                     "leave them out here");
  }
  if (!arguments.scene.empty() && needs.size() > 1) {
    throw InputError("g27 figure", "--scene", fmt::format("{} needs {} scenes", arguments.name, needs.size()),
                     "give their results by --from");
  }
  if (!arguments.from.empty()) {
    auto const figure = drawn(arguments, arguments.name, hdf5_files(arguments.from));
    if (!figure) {
      throw InputError("g27 figure", "--from", fmt::format("{} was not drawn from these results", arguments.name),
                       "name results of the study or scene that it is of");
    }
    fmt::print("{}\n", *figure);
    return 0;
  }
  if (needs.empty()) {
    draw_into(arguments, arguments.name, usual_files(arguments.name));
    return 0;
  }
  Strings files;
  CacheOptions const options = cache_options(arguments);
  for (Scene const& scene : scenes_of(needs, arguments)) {
    if (int const status = ensure_cached(scene, options); status != 0) return status;
    auto const more = cached_files(scene, options);
    files.insert(files.end(), more.begin(), more.end());
  }
  draw_into(arguments, arguments.name, files);
  return 0;
}

}  // namespace g27
