/// Whether regions, obstacles and blocks lie where the grid sees them: what lies beside it, or between the centres of
/// its cells, is a slip in a unit or in a place.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/surface/vec3.hpp"
#include "scheme/grid/cell_place.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

/// Of the cells [first, last), by halves; shapes that are farther than the outermost centres leave them out.
bool holds_centre(Distance const& shape, GridBox const& box, Int3 const& first, Int3 const& last) {
  Vec3 const h = cell_widths(box.lower, box.upper, box.cells);
  Vec3 middle = box.lower;
  double reach = 0;
  std::size_t longest = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) {
    middle[d] += 0.5 * h[d] * (first[d] + last[d]);
    reach = std::hypot(reach, 0.5 * h[d] * (last[d] - first[d] - 1));
    if (last[d] - first[d] > last[longest] - first[longest]) longest = d;
  }
  double const distance = shape(middle);
  if (last[longest] - first[longest] == 1) return distance <= 0;
  if (distance > reach * (1 + 1e-12)) return false;
  Int3 end = last, begin = first;
  end[longest] = begin[longest] = (first[longest] + last[longest]) / 2;
  return holds_centre(shape, box, first, end) || holds_centre(shape, box, begin, last);
}

bool holds_centre(Distance const& shape, GridBox const& box) { return holds_centre(shape, box, {0, 0, 0}, box.cells); }

Distance ball(Vec3 const& centre, double radius) {
  return [=](Vec3 const& x) { return length(x - centre) - radius; };
}

/// What both hold.
Distance common(Distance a, Distance b) {
  return [a = std::move(a), b = std::move(b)](Vec3 const& x) { return std::max(a(x), b(x)); };
}

/// An obstacle may be thinner than a cell, and still be in the way of a front.
void check_obstacles(Charge const& charge, GridBox const& box) {
  constexpr int parts = 8;  // of a cell
  GridBox fine = box;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) fine.cells[d] *= parts;
  for (std::size_t n = 0; n < charge.obstacles.size(); ++n) {
    if (!holds_centre(common(ball(charge.centre, charge.radius), charge.obstacles[n]), fine)) {
      throw charge.section.error(fmt::format("obstacle.{}", n), "touches nothing of the charge in the domain",
                                 "move it into the charge, or remove it; a bare number is in SI units");
    }
  }
}

}  // namespace

void check_covers(GridRegions const& regions, std::vector<SolidBlock> const& blocks, GridBox const& box) {
  for (GridRegion const& region : regions.list) {
    bool const charge = region.kind == "charge";
    if (!holds_centre(charge ? ball(region.centre, region.radius) : region.distance, box)) {
      throw region.section.error(charge ? "radius" : "shape",
                                 "covers no centre of a cell: it lies outside the domain, or is too small",
                                 "move it into the domain, or take smaller cells; a bare number is in SI units");
    }
  }
  if (regions.charge) check_obstacles(*regions.charge, box);
  Distance gas = [](Vec3 const&) { return -1e300; };
  for (SolidBlock const& block : blocks) {
    gas = common(gas, [inside = distance_to_box(extent_of(block, box))](Vec3 const& x) { return -inside(x); });
  }
  if (!holds_centre(gas, box)) {
    throw regions.list[0].section.error("", "has no cell left: blocks cover the domain", "make the blocks smaller");
  }
}

}  // namespace g27
