#include "studies/driver/scene_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "studies/driver/digest.hpp"
#include "studies/driver/units.hpp"

namespace g27 {
namespace {

/// The same text for trees that differ in the order of keys and the way a number or a quantity is written only.
std::string canonical(Node const& node) {
  struct Writer {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(long number) const { return (*this)(static_cast<double>(number)); }
    // units are powers of ten of SI ones, to round-off: "9 us" is 9e-6
    std::string operator()(double number) const { return fmt::format("{:.15g}", number); }
    std::string operator()(std::string const& text) const {
      auto const quantity = parse_quantity(text);
      if (quantity && quantity->has_unit) return (*this)(quantity->value);
      if (text == "on" || text == "off") return (*this)(text == "on");
      return fmt::format("\"{}:{}\"", text.size(), text);
    }
    std::string operator()(Node::Array const& list) const {
      std::string out = "[";
      for (Node const& entry : list) out += canonical(entry) + ",";
      return out + "]";
    }
    std::string operator()(Node::Table const& table) const {
      std::vector<std::string> entries;
      std::transform(table.begin(), table.end(), std::back_inserter(entries),
                     [](NodeEntry const& e) { return fmt::format("{}={}", e.key, canonical(e.node)); });
      std::sort(entries.begin(), entries.end());
      std::string out = "{";
      for (std::string const& entry : entries) out += entry + ",";
      return out + "}";
    }
  };
  return std::visit(Writer{}, node.value);
}

}  // namespace

std::string scene_digest(Node const& root, std::vector<SceneRun> const& runs) {
  Node tree = root;
  std::erase_if(std::get<Node::Table>(tree.value),
                [](NodeEntry const& e) { return e.key == "title" || e.key == "source"; });
  Digest digest;
  digest.add(canonical(tree));
  for (SceneRun const& run : runs) {
    for (std::size_t n = 0; run.grid && n < run.grid->bodies.size(); ++n) {
      digest.add(fmt::format("{:016x}", run.grid->bodies[n].fingerprint));
    }
  }
  return fmt::format("{:016x}", digest.value()).substr(0, 12);
}

}  // namespace g27
