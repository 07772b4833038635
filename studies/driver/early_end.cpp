#include "studies/driver/early_end.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/driver/scene_reader.hpp"
#include "studies/driver/units.hpp"

namespace g27 {
namespace {

double seconds(Node const& node) {
  auto const* text = std::get_if<std::string>(&node.value);
  auto const quantity = text != nullptr ? parse_quantity(*text) : std::nullopt;
  if (quantity) return quantity->value;
  if (auto const* number = std::get_if<double>(&node.value)) return *number;
  auto const* whole = std::get_if<long>(&node.value);
  return whole != nullptr ? static_cast<double>(*whole) : 0;
}

/// time.end [s]; 0 if it cannot be read.
double end_of(Document const& scene) {
  Node const* time = scene.root.find("time");
  Node const* end = time != nullptr ? time->find("end") : nullptr;
  return end != nullptr ? seconds(*end) : 0;
}

}  // namespace

std::vector<std::string> quick_look(Document const& scene) {
  std::vector<std::string> out{"expect=[]"};
  double const end = end_of(scene);
  Node const* output = scene.root.find("output");
  auto const* list = output != nullptr ? output->list("snapshots") : nullptr;
  if (list == nullptr) return out;
  std::vector<std::string> kept;
  for (Node const& at : *list) {
    auto const* text = std::get_if<std::string>(&at.value);
    if (text != nullptr && seconds(at) <= end) kept.push_back('"' + *text + '"');
  }
  if (kept.size() < list->size()) out.push_back(fmt::format("output.snapshots=[{}]", fmt::join(kept, ", ")));
  return out;
}

std::vector<std::string> without_what_is_beyond(std::filesystem::path const& file,
                                                std::vector<std::string> const& set) {
  auto const sets = [&](std::string const& key) {
    return std::any_of(set.begin(), set.end(), [&](std::string const& s) { return s.starts_with(key + "="); });
  };
  std::vector<std::string> all = set;
  if (!sets("time.end")) return all;
  Document const scene = read_overridden(file, set);
  double const end = end_of(scene);
  if (!(end > 0 && end < end_of(read_overridden(file, {})))) return all;  // unreadable: refused where it is read
  for (std::string const& more : quick_look(scene)) {
    if (sets(more.substr(0, more.find('=')))) continue;
    fmt::print(stderr, "the run ends sooner than its scene, so that {}: as by --set {}\n",
               more.starts_with("expect") ? "nothing is judged" : "later snapshots are left out", more);
    all.push_back(more);
  }
  return all;
}

}  // namespace g27
