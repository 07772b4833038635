#include "studies/driver/figure_needs.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "studies/driver/input_error.hpp"

namespace g27 {
namespace {

constexpr char const* marker = "# needs:";

InputError unreadable(std::string const& file, int line, std::string const& problem) {
  return {fmt::format("{}:{}", file, line), "needs", problem, "write # needs: SCENE [--set key=value ...]"};
}

/// Words as a shell parts them; nullopt when a quote is open.
std::optional<std::vector<std::string>> words_of(std::string const& line) {
  std::vector<std::string> words;
  std::string word;
  bool begun = false;
  char quote = 0;
  for (char const c : line) {
    if (quote != 0) {
      if (c == quote) {
        quote = 0;
      } else {
        word += c;
      }
    } else if (c == '\'' || c == '"') {
      quote = c, begun = true;
    } else if (c == ' ' || c == '\t' || c == '\r') {
      if (begun) words.push_back(std::move(word));
      word.clear(), begun = false;
    } else {
      word += c, begun = true;
    }
  }
  if (begun) words.push_back(std::move(word));
  return quote != 0 ? std::nullopt : std::optional(words);
}

/// "3 mm" for "1.5 mm" and 2.
std::string scaled(std::string const& key, Node const& node, double factor) {
  auto const* text = std::get_if<std::string>(&node.value);
  std::size_t end = 0;
  double number = 0;
  try {
    number = text != nullptr ? std::stod(*text, &end) : 0;
  } catch (std::exception const&) {
  }
  if (end == 0) {
    throw InputError("g27 figure", "--grids", fmt::format("{} of the scene is no length with a unit", key),
                     "write it as \"1.5 mm\"");
  }
  return fmt::format("{}=\"{:.15g}{}\"", key, number * factor, text->substr(end));
}

}  // namespace

std::vector<FigureNeed> parse_needs(std::string const& script, std::string const& file) {
  std::vector<FigureNeed> needs;
  std::istringstream lines(script);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.starts_with(marker)) continue;
    auto const words = words_of(line.substr(std::string_view(marker).size()));
    if (!words) throw unreadable(file, number, "has an open quote");
    if (words->empty()) throw unreadable(file, number, "names no scene");
    FigureNeed need{.scene = words->front(), .set = {}};
    for (std::size_t i = 1; i < words->size(); i += 2) {
      if ((*words)[i] != "--set" || i + 1 == words->size() || (*words)[i + 1].find('=') == std::string::npos) {
        throw unreadable(file, number, fmt::format("has '{}' where --set key=value belongs", (*words)[i]));
      }
      need.set.push_back((*words)[i + 1]);
    }
    needs.push_back(std::move(need));
  }
  return needs;
}

std::string figure_title(std::filesystem::path const& script) {
  std::ifstream in(script);
  std::string line;
  while (std::getline(in, line)) {
    if (line.starts_with(R"(""")")) {
      line.erase(0, 3);
      return line.substr(0, line.find(R"(""")"));
    }
  }
  return "";
}

std::vector<std::string> coarser(Document const& scene, double factor) {
  std::vector<std::string> out;
  if (factor == 1) return out;
  Node const* domain = scene.root.find("domain");
  Node const* cell = domain != nullptr ? domain->find("cell") : nullptr;
  if (cell == nullptr) {
    throw InputError("g27 figure", "--grids", fmt::format("{} has no domain.cell", scene.file), "give it one");
  }
  out.push_back(scaled("domain.cell", *cell, factor));
  auto const add_bodies = [&](Node const& owner, std::string const& prefix) {
    auto const* list = owner.list("body");
    for (std::size_t n = 0; list != nullptr && n < list->size(); ++n) {
      std::string const key = fmt::format("{}body.{}.cell", prefix, n);
      if (Node const* own = (*list)[n].find("cell")) out.push_back(scaled(key, *own, factor));
    }
  };
  add_bodies(scene.root, "");
  auto const* variants = scene.root.list("variant");
  for (std::size_t n = 0; variants != nullptr && n < variants->size(); ++n) {
    add_bodies((*variants)[n], fmt::format("variant.{}.", n));
  }
  return out;
}

}  // namespace g27
