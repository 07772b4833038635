/// [[body]] clamped: walls that a body is bonded to.
#include <fmt/format.h>

#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {

Clamps read_clamps(Section const& body, Mirrors const& cut, bool rigid) {
  Clamps out;
  if (!body.has("clamped")) return out;
  auto const* list = std::get_if<Node::Array>(&body.need("clamped", R"(["y_low"])").value);
  if (list == nullptr || list->empty()) {
    throw body.error("clamped", "is not a list of sides", R"(write clamped = ["y_low"])");
  }
  if (rigid) {
    throw body.error("clamped", "is for bodies that deform", R"(write motion = "given" and a velocity of 0 m/s)");
  }
  for (Node const& entry : *list) {
    auto const* name = std::get_if<std::string>(&entry.value);
    if (name == nullptr) throw body.error("clamped", "holds what is no text", R"(write clamped = ["y_low"])");
    std::size_t const side = index_of_choice(body, "clamped", *name, side_names());
    std::size_t const axis = side / 2;
    bool const low = side % 2 == 0;
    if (!(low ? cut.low : cut.high)[axis]) {
      throw body.error(
          "clamped", fmt::format("names {}, which is no wall all over, or does not cut the body", *name),
          fmt::format(R"(set {} = "wall" in domain.boundary and let the body reach across it, or leave it out)",
                      *name));
    }
    (low ? out.low : out.high)[axis] = true;
  }
  return out;
}

}  // namespace g27
