/// Lighting of a charge around what its front does not pass: rigid blocks, and shapes without explosive.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "fsi/surface/vec3.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

constexpr double overlap = 1e-9;            ///< of obstacles that touch, over the charge's radius
constexpr double overlap_of_blocks = 0.03;  ///< that may share a corner, in cells: rays may miss an edge by .02

Obstacle grown(Distance distance, double by) {
  return [distance = std::move(distance), by](Vec3 const& x) { return distance(x) - by; };
}

struct NamedObstacle {
  std::string name;  ///< "block.0", "charge.0.obstacle.1"
  Obstacle distance;
};

std::vector<NamedObstacle> obstacles_of(Charge const& charge, GasGridSetup const& grid, GridBox const& box) {
  std::vector<NamedObstacle> out;
  for (std::size_t n = 0; n < charge.obstacles.size(); ++n) {
    out.push_back({fmt::format("{}.obstacle.{}", charge.section.path(), n), charge.obstacles[n]});
  }
  for (std::size_t n = 0; n < grid.blocks.size(); ++n) {
    SolidBlock const& block = grid.blocks[n];
    if (distance_to_block(block, box, charge.centre) >= charge.radius) continue;
    double width = 1e300;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) {
      width = std::min(width, (box.upper[d] - box.lower[d]) / box.cells[d]);
    }
    out.push_back({fmt::format("block.{}", n),
                   grown(distance_to_box(extent_of(block, box)),
                         grid.blocks.size() > 1 ? overlap_of_blocks * width : overlap * charge.radius)});
  }
  return out;
}

void check_ignition(Charge const& charge, std::vector<NamedObstacle> const& obstacles, GridBox const& box) {
  Distance const domain =
      distance_to_box({{box.lower[0], box.upper[0]}, {box.lower[1], box.upper[1]}, {box.lower[2], box.upper[2]}});
  for (auto const& [x, time] : charge.ignition) {
    auto const refuse = [&](std::string const& where) {
      return charge.section.error("ignition", fmt::format("({:g}, {:g}, {:g}) m lies {}", x[0], x[1], x[2], where),
                                  "give points of the charge that are in the domain, and in no block or obstacle");
    };
    if (domain(x) > overlap * charge.radius) throw refuse("outside the domain");
    for (NamedObstacle const& o : obstacles) {
      if (o.distance(x) < 0) throw refuse("in " + o.name);
    }
  }
}

/// The grid's cells around the charge.
void set_part(LightingSetup& setup, Charge const& charge, GridBox const& box) {
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) {
    double const h = (box.upper[d] - box.lower[d]) / box.cells[d];
    auto const cell = [&](double x) { return std::clamp((x - box.lower[d]) / h, 0.0, double(box.cells[d])); };
    setup.first[d] = static_cast<int>(std::floor(cell(charge.centre[d] - charge.radius)));
    setup.last[d] = static_cast<int>(std::ceil(cell(charge.centre[d] + charge.radius)));
  }
}

}  // namespace

std::vector<Obstacle> read_obstacles(Section const& charge, double radius, int dimensions) {
  std::vector<Obstacle> out;
  for (Section const& section : charge.tables("obstacle", shape_keys())) {
    out.push_back(grown(read_shape(section, dimensions), overlap * radius));
  }
  return out;
}

ProgrammedBurn burn_around(Charge const& charge, GasGridSetup const& grid) {
  GridBox const box{grid.lower, grid.upper, grid.cells};
  auto const obstacles = obstacles_of(charge, grid, box);
  bool const told = charge.section.has("ignition") || !obstacles.empty();
  if (charge.burn.there() && told) check_ignition(charge, obstacles, box);
  if (obstacles.empty()) {
    return charge.burn;
  }
  if (!charge.burn.there()) {
    throw charge.section.error("radius", fmt::format("reaches into {}", obstacles[0].name),
                               "write start = \"ignition\", whose front goes around blocks, or move the block away");
  }
  LightingSetup setup{.lower = box.lower,
                      .upper = box.upper,
                      .cells = box.cells,
                      .explosive = [c = charge.centre, r = charge.radius](Vec3 const& x) { return length(x - c) <= r; },
                      .ignition = charge.ignition,
                      .speed = charge.burn.speed};
  for (NamedObstacle const& o : obstacles) setup.obstacles.push_back(o.distance);
  set_part(setup, charge, box);
  auto const times = std::make_shared<LightingTimes>(setup);
  auto const dark = std::count_if(times->all().begin(), times->all().end(),
                                  [](double t) { return t == std::numeric_limits<double>::infinity(); });
  if (dark > 0) {
    throw charge.section.error("ignition",
                               fmt::format("leaves {} cells of explosive without a way for the front to them", dark),
                               "light every part that blocks and obstacles close off, or cover it by an obstacle");
  }
  ProgrammedBurn burn = charge.burn;
  burn.lighting = [times](Vec3 const& x) { return (*times)(x); };
  return burn;
}

}  // namespace g27
