#pragma once
/// What a figure of a paper is drawn from, as its script declares in lines of comment:
///
///   # needs: three-cubes --set 'material.steel.strength={ type = "elastic", shear = "80.77 GPa" }'
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/document.hpp"

namespace g27 {

/// A scene with some of its keys replaced.
struct FigureNeed {
  std::string scene;
  std::vector<std::string> set;  ///< "dotted.key=value"
};

/// Of a script's text; words as in a shell, with '...' and "..." around spaces. Throws InputError.
std::vector<FigureNeed> parse_needs(std::string const& script, std::string const& file);

/// The first line of the script's docstring.
std::string figure_title(std::filesystem::path const& script);

/// Settings that make the cells of the gas and of all bodies `factor` times as wide. Throws InputError.
std::vector<std::string> coarser(Document const& scene, double factor);

}  // namespace g27
