#pragma once
/// From a TOML file to a checked Scene.
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/document.hpp"
#include "studies/driver/scene.hpp"

namespace g27 {

/// Reads `file`, applies `overrides` ("dotted.key=value"); throws InputError.
Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides);

/// The file with `overrides` applied, as it is read; throws InputError.
Document read_overridden(std::filesystem::path const& file, std::vector<std::string> const& overrides);

/// A path as given, or the scene of that name in studies/scenes; throws InputError naming the nearest.
std::filesystem::path find_scene(std::string const& path_or_name);

/// Names of the scenes in studies/scenes, sorted.
std::vector<std::string> scene_names();

}  // namespace g27
