/// [start]: data that are symmetric about a centre run on a line first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/surface/gap.hpp"
#include "scheme/grid/line.hpp"
#include "scheme/step/gauss.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

constexpr double finest_over_grid = 3;  ///< line cells a grid cell, unless told

/// The regions above the ambient are balls about one centre, at rest or a charge. Returns the centre.
Vec3 common_centre(Section const& section, std::vector<GridRegion> const& regions) {
  auto const refuse = [&](std::string const& what) {
    return section.error("", "needs initial data that are symmetric about one centre: " + what,
                         "remove [start], or use spheres and a charge of one center, at rest");
  };
  if (regions.size() < 2) {
    throw refuse("there is nothing beside [ambient]");
  }
  for (GridRegion const& region : regions) {
    if (!region.radial) {
      throw refuse(region.section.path() +
                   (region.kind == "charge" ? " is not lit at its center alone and at once, or has obstacles"
                    : region.kind == "sphere" || region.kind == "ambient" ? " moves"
                                                                          : fmt::format(" is a {}", region.kind)));
    }
    if (&region != &regions[0] && region.kind != "sphere" && region.kind != "charge") {
      throw refuse(fmt::format("{} is a {}", region.section.path(), region.kind));
    }
    if (&region != &regions[0] && region.centre != regions[1].centre) {
      throw refuse(region.section.path() + " has another center");
    }
  }
  return regions[1].centre;
}

/// Distance to the nearest body; bodies wait at rest for the wave.
double distance_to_bodies(Section const& section, std::vector<SceneBody> const& bodies, Vec3 const& centre) {
  double nearest = 1e300;
  for (SceneBody const& body : bodies) {
    TriangleSurface const& surface = body.whole;
    bool const moves = std::any_of(surface.vertices.begin(), surface.vertices.end(), [&](Vec3 const& x) {
      return dot(body.setup.initial(x).u, body.setup.initial(x).u) > 0;
    });
    if (moves) {
      throw section.error("", fmt::format("needs bodies at rest, but '{}' moves", body.name),
                          "remove [start], or the body's velocity and spin");
    }
    nearest = std::min(nearest, distance_to_body(centre, surface));
  }
  return nearest;
}

/// Distance to the nearest block, or side that the centre does not lie on; those it lies on must be walls.
double clearance(Section const& section, GasGridSetup const& grid, GridBox const& box, Vec3 const& centre) {
  double nearest = 1e300;
  for (std::size_t side = 0; side < 2 * static_cast<std::size_t>(dimensions_of(box)); ++side) {
    std::size_t const d = side / 2;
    double const gap = side % 2 == 0 ? centre[d] - box.lower[d] : box.upper[d] - centre[d];
    double const slack = 1e-9 * (box.upper[d] - box.lower[d]);
    if (gap < -slack) {
      throw section.error("", "has its centre outside the domain", "move the center, or remove [start]");
    }
    if (gap > slack) {
      nearest = std::min(nearest, gap);
      continue;
    }
    bool const patched = std::any_of(grid.patches.begin(), grid.patches.end(),
                                     [&](BoundaryPatch const& p) { return static_cast<std::size_t>(p.side) == side; });
    if (grid.sides[side].kind != GridBoundary::Kind::wall || patched) {
      throw section.error(
          "", fmt::format("has its centre on {}, which is not a plane of symmetry", side_names()[side]),
          fmt::format("write {} = \"symmetry\" without patches, or remove [start]", side_names()[side]));
    }
  }
  for (SolidBlock const& block : grid.blocks) {
    nearest = std::min(nearest, distance_to_block(block, box, centre));
  }
  return nearest;
}

/// Averages of shells, split where the data jump.
std::vector<GasConserved<>> line_averages(GasLineSetup const& line, std::vector<GridRegion> const& regions) {
  std::vector<double> jumps;
  for (GridRegion const& region : regions) {
    jumps.push_back(region.radius);
  }
  std::sort(jumps.begin(), jumps.end());
  auto const at = [&](double r) -> GasConserved<> {
    std::size_t top = regions.size() - 1;
    while (top > 0 && r > regions[top].radius) {
      --top;
    }
    GasState<> const s = regions[top].radial(r);
    double const e = std::visit([&](auto const& law) { return law.energy(s.rho, s.p); }, line.eos);
    return {s.rho, s.rho * s.u, s.rho * (e + 0.5 * s.u * s.u)};
  };
  std::vector<GasConserved<>> out;
  for (std::size_t i = 0; i + 1 < line.faces.size(); ++i) {
    std::vector<double> ends{line.faces[i]};
    std::copy_if(jumps.begin(), jumps.end(), std::back_inserter(ends),
                 [&](double r) { return r > line.faces[i] && r < line.faces[i + 1]; });
    ends.push_back(line.faces[i + 1]);
    GasConserved<> sum{0, 0, 0};
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      double const m = ends.size() == 2 ? 1.0 : measure_between(line.symmetry, ends[k], ends[k + 1]);
      GasConserved<> const q = cell_average(line.symmetry, ends[k], ends[k + 1], 5, at);
      sum = {sum.mass + m * q.mass, sum.momentum + m * q.momentum, sum.energy + m * q.energy};
    }
    double const whole = ends.size() == 2 ? 1.0 : measure_between(line.symmetry, ends.front(), ends.back());
    bool const outside = ends.front() >= jumps.back();  // bit by bit the ambient
    out.push_back(outside ? at(ends.back())
                          : GasConserved<>{sum.mass / whole, sum.momentum / whole, sum.energy / whole});
  }
  return out;
}

}  // namespace

std::optional<LineStart> read_line_start(Section const& root, GridRegions const& regions, GridRun const& grid,
                                         double start, double end) {
  if (!root.has("start")) {
    return std::nullopt;
  }
  Section const section = root.table("start", {"one_dimensional_until", "one_dimensional_radius", "cell"});
  GridBox const box{grid.setup.lower, grid.setup.upper, grid.setup.cells};
  LineStart out;
  out.centre = common_centre(section, regions.list);
  out.clearance =
      std::min(clearance(section, grid.setup, box, out.centre), distance_to_bodies(section, grid.bodies, out.centre));
  bool const lit = regions.charge && regions.charge->burn.there();
  double largest = 0;
  for (GridRegion const& region : regions.list) {
    largest = std::max(largest, region.radius);
  }
  if (!(largest < out.clearance)) {
    throw section.error(
        "",
        fmt::format("has data that reach {} m, but the nearest side, block or body is at {} m", largest, out.clearance),
        "remove [start]: the flow is never symmetric");
  }
  if (!section.has("one_dimensional_until") && !section.has("one_dimensional_radius")) {
    throw section.error("one_dimensional_until", "is missing",
                        "add one_dimensional_until = \"12 us\" or one_dimensional_radius = \"8 cm\"");
  }
  if (section.has("one_dimensional_until")) {
    out.until = section.positive("one_dimensional_until", dimension::time);
    if (!(out.until > start && out.until < end)) {
      throw section.error("one_dimensional_until", fmt::format("{} s is not within the run", out.until),
                          fmt::format("choose it from {} s to {} s", start, end));
    }
  }
  if (section.has("one_dimensional_radius")) {
    out.radius = section.positive("one_dimensional_radius", dimension::length);
    if (!(out.radius > largest && out.radius < out.clearance)) {
      throw section.error(
          "one_dimensional_radius", fmt::format("{} m is out of range", out.radius),
          fmt::format("choose it from {} m, where the data end, to {} m, the nearest side, block or body", largest,
                      out.clearance));
    }
  }

  double finest = 1e300, farthest = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) {
    finest = std::min(finest, (box.upper[d] - box.lower[d]) / box.cells[d]);
    double const reach = std::max(box.upper[d] - out.centre[d], out.centre[d] - box.lower[d]);
    farthest += reach * reach;
  }
  double const length = std::sqrt(farthest);
  double width = section.has("cell") ? section.positive("cell", dimension::length) : finest / finest_over_grid;
  if (lit) width = regions.charge->radius / std::ceil(regions.charge->radius / width * (1 - 1e-9));  // ends at a face
  double const count = std::ceil(length / width);
  if (!(count >= 8 && count <= 1e6)) {
    throw section.error("cell", fmt::format("makes {} cells on the line", count), "choose it for 8 to 1000000 cells");
  }
  out.setup.eos = grid.setup.eos;
  out.setup.symmetry = dimensions_of(box) == 3 ? Symmetry::spherical : Symmetry::cylindrical;
  for (double i = 0; i <= count; ++i) {
    out.setup.faces.push_back(lit ? width * i : length * i / count);
  }
  out.setup.left.kind = GasBoundary::Kind::wall;
  if (lit) {
    out.setup.burn = regions.charge->burn;
    out.earliest = (regions.charge->radius + width) / out.setup.burn.speed;
    if (out.until < out.earliest) {
      throw section.error("one_dimensional_until", fmt::format("{} s is before the charge has burnt", out.until),
                          fmt::format("choose it from {} s", out.earliest));
    }
    out.setup.burn.lighting = [lighting = out.setup.burn.lighting, centre = out.centre](Vec3 const& x) {
      return lighting({centre[0] + x[0], centre[1], centre[2]});
    };
  }
  out.averages = line_averages(out.setup, regions.list);
  return out;
}

}  // namespace g27
