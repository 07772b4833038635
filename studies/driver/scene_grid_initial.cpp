/// Initial data of a grid: regions of simple shapes, later ones over earlier ones, and their cell averages.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/surface/vec3.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

void set_box(GridRegion& region, Section const& section, int dimensions) {
  auto const extent = section.intervals("extent", dimension::length);
  if (static_cast<int>(extent.size()) != dimensions) {
    throw section.error("extent", fmt::format("has {} intervals", extent.size()),
                        fmt::format("give {}, one an axis", dimensions));
  }
  region.distance = distance_to_box(extent);
}

void set_sphere(GridRegion& region, Section const& section, int dimensions) {
  region.centre = section.point("center", dimension::length, dimensions);
  region.radius = section.positive("radius", dimension::length);
  region.distance = [c = region.centre, r = region.radius](Vec3 const& x) { return length(x - c) - r; };
}

void set_cylinder(GridRegion& region, Section const& section, int dimensions) {
  if (dimensions != 3) {
    throw section.error("shape", "'cylinder' needs three dimensions", "write shape = \"sphere\": a disc in the plane");
  }
  std::size_t const axis = index_of_choice(section, "axis", section.text("axis"), {"x", "y", "z"});
  Vec3 const centre = section.point("center", dimension::length, dimensions);
  double const radius = section.positive("radius", dimension::length);
  double const half = section.has("length") ? section.positive("length", dimension::length) / 2 : 1e300;
  region.distance = [=](Vec3 const& x) {
    Vec3 from = x - centre;
    double const along = std::fabs(from[axis]);
    from[axis] = 0;
    return std::max(length(from) - radius, along - half);
  };
}

void set_half_space(GridRegion& region, Section const& section, int dimensions) {
  Vec3 const point = section.point("point", dimension::length, dimensions), n = read_normal(section, dimensions);
  region.distance = [=](Vec3 const& x) {
    Vec3 const from = x - point;
    return from[0] * n[0] + from[1] * n[1] + from[2] * n[2];
  };
}

struct Shape {
  std::string name;
  std::vector<std::string> keys;
  void (*set)(GridRegion&, Section const&, int dimensions);
};
std::vector<Shape> const shapes{{"box", {"shape", "extent"}, set_box},
                                {"sphere", {"shape", "center", "radius"}, set_sphere},
                                {"cylinder", {"shape", "axis", "center", "radius", "length"}, set_cylinder},
                                {"half-space", {"shape", "point", "normal"}, set_half_space}};

Shape const& shape_of(Section const& any) {
  std::vector<std::string> names;
  std::transform(shapes.begin(), shapes.end(), std::back_inserter(names), [](Shape const& s) { return s.name; });
  return shapes[index_of_choice(any, "shape", any.text("shape"), names)];
}

GridRegion read_region(Section const& any, AnyEos const& eos, int dimensions) {
  Shape const& shape = shape_of(any);
  Section const section = any.reopened(with_state_keys(shape.keys));
  GasPoint const state = read_point_state(section, eos, dimensions);
  GridRegion region{
      .kind = shape.name, .distance = {}, .state = [state](Vec3 const&) { return state; }, .section = section};
  shape.set(region, section, dimensions);
  if (length(state.u) == 0) {
    region.radial = [state](double) { return GasState<>{state.rho, 0, state.p}; };
  }
  return region;
}

/// The wave over the radius from a table, since a cell asks for it at many points: nodes where r = radius (1 - s^2)
/// with s uniform, in which the wave is smooth (at the front the velocity falls as a square root).
InitialState tabulated(Charge const& charge) {
  constexpr int intervals = 4000;
  std::vector<GasState<>> nodes;
  for (int i = 0; i <= intervals; ++i) {
    double const s = static_cast<double>(i) / intervals;
    nodes.push_back(charge.state(charge.radius * (1 - s * s)));
  }
  return [nodes, radius = charge.radius](double r) -> GasState<> {
    double const s = std::sqrt(std::max(0.0, 1 - r / radius)) * intervals;
    auto const i = std::min(static_cast<std::size_t>(s), nodes.size() - 2);
    double const f = s - static_cast<double>(i);
    GasState<> const &a = nodes[i], &b = nodes[i + 1];
    return {(1 - f) * a.rho + f * b.rho, (1 - f) * a.u + f * b.u, (1 - f) * a.p + f * b.p};
  };
}

GridRegion charge_region(Charge const& charge) {
  InitialState const wave = tabulated(charge);
  return {.kind = "charge",
          .distance =
              [c = charge.centre, r = charge.radius, holes = charge.obstacles](Vec3 const& x) {
                double most = length(x - c) - r;
                for (Obstacle const& hole : holes) most = std::max(most, -hole(x));
                return most;
              },
          .state =
              [wave, centre = charge.centre](Vec3 const& x) {
                Vec3 const from = x - centre;
                double const r = length(from);
                GasState<> const s = wave(r);
                double const over_r = r > 0 ? s.u / r : 0.0;
                return GasPoint{s.rho, {over_r * from[0], over_r * from[1], over_r * from[2]}, s.p};
              },
          .uniform = charge.burn.there(),
          .whole_cells = charge.burn.there(),
          .centre = charge.centre,
          .radius = charge.radius,
          .radial = charge.central ? charge.state : InitialState{},
          .section = charge.section};
}

}  // namespace

Distance distance_to_box(std::vector<std::array<double, 2>> const& extent) {
  return [extent](Vec3 const& x) {
    double most = -1e300;
    for (std::size_t d = 0; d < extent.size(); ++d) {
      most = std::max({most, extent[d][0] - x[d], x[d] - extent[d][1]});
    }
    return most;
  };
}

Distance read_shape(Section const& any, int dimensions) {
  Shape const& shape = shape_of(any);
  GridRegion region{.kind = shape.name, .section = any.reopened(shape.keys)};
  shape.set(region, region.section, dimensions);
  return region.distance;
}

std::vector<std::string> shape_keys() {
  std::vector<std::string> keys;
  for (Shape const& shape : shapes) keys.insert(keys.end(), shape.keys.begin(), shape.keys.end());
  return keys;
}

GasPoint read_point_state(Section const& section, AnyEos const& eos, int dimensions) {
  GasPoint state;
  state.rho = section.quantity("density", dimension::density);
  if (section.has("velocity")) {
    state.u = section.point("velocity", dimension::velocity, dimensions);
  }
  state.p = section.quantity("pressure", dimension::pressure);
  check_admissible(section, eos, {state.rho, 0, state.p});
  return state;
}

GasDensities densities(AnyEos const& eos, GasPoint const& s) {
  double const e = std::visit([&](auto const& law) { return law.energy(s.rho, s.p); }, eos);
  return {s.rho,
          {s.rho * s.u[0], s.rho * s.u[1], s.rho * s.u[2]},
          s.rho * (e + 0.5 * (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]))};
}

GridRegions read_regions(Section const& root, AnyEos const& eos, int dimensions) {
  if (root.has("initial")) {
    throw root.error("initial", "is for one dimension", "use [ambient], [[region]] and [[charge]]");
  }
  if (!root.has("ambient")) {
    throw root.error("ambient", "is missing", "add [ambient] with density and pressure: regions lie over it");
  }
  Section const ambient = root.table("ambient", with_state_keys({}));
  GasPoint const outer = read_point_state(ambient, eos, dimensions);
  GridRegions out;
  out.list.push_back({.kind = "ambient",
                      .distance = [](Vec3 const&) { return -1e300; },
                      .state = [outer](Vec3 const&) { return outer; },
                      .section = ambient});
  if (length(outer.u) == 0) {
    out.list[0].radial = [outer](double) { return GasState<>{outer.rho, 0, outer.p}; };
  }
  for (Section const& section : root.tables("region", with_state_keys(shape_keys()))) {
    out.list.push_back(read_region(section, eos, dimensions));
  }
  Symmetry const symmetry = dimensions == 3 ? Symmetry::spherical : Symmetry::cylindrical;
  for (Charge const& charge : read_charges(root, eos, symmetry, dimensions)) {
    out.list.push_back(charge_region(charge));
    out.charge = charge;
  }
  return out;
}

std::function<GasPoint(Vec3 const&)> make_point_initial(std::vector<GridRegion> regions) {
  return [regions = std::move(regions)](Vec3 const& x) {
    std::size_t top = regions.size() - 1;
    while (top > 0 && regions[top].distance(x) > 0) {
      --top;
    }
    return regions[top].state(x);
  };
}

GridInitial make_initial(std::vector<GridRegion> regions, AnyEos const& eos, int dimensions) {
  return [regions = std::move(regions), eos, dimensions](Vec3 const& centre, Vec3 const& widths) -> GasDensities {
    Vec3 half{0, 0, 0};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
      half[d] = widths[d] / 2;
    }
    double const reach = length(half);
    // The topmost region that holds the whole cell; those above it that may hold a part of it.
    std::size_t base = regions.size() - 1;
    bool mixed = false;
    for (;; --base) {
      double const distance = regions[base].distance(centre), margin = regions[base].whole_cells ? 0 : reach;
      if (distance <= -margin || base == 0) {
        break;
      }
      mixed = mixed || distance < margin;
    }
    if (!mixed && regions[base].uniform) {
      return densities(eos, regions[base].state(centre));
    }
    int const points = !mixed ? 4 : dimensions == 3 ? 8 : 16, planes = dimensions == 3 ? points : 1;
    GasDensities sum;
    std::size_t lowest = regions.size(), highest = 0;
    for (int k = 0; k < planes; ++k) {
      for (int j = 0; j < points; ++j) {
        for (int i = 0; i < points; ++i) {
          Vec3 const x{centre[0] + half[0] * ((2 * i + 1.0) / points - 1),
                       centre[1] + half[1] * ((2 * j + 1.0) / points - 1),
                       centre[2] + half[2] * ((2 * k + 1.0) / planes - 1)};
          std::size_t top = regions.size() - 1;
          while (top > base && regions[top].distance(regions[top].whole_cells ? centre : x) > 0) {
            --top;
          }
          lowest = std::min(lowest, top), highest = std::max(highest, top);
          GasDensities const q = densities(eos, regions[top].state(x));
          sum.mass += q.mass, sum.energy += q.energy;
          for (std::size_t d = 0; d < 3; ++d) {
            sum.momentum[d] += q.momentum[d];
          }
        }
      }
    }
    if (lowest == highest && regions[lowest].uniform) {
      return densities(eos, regions[lowest].state(centre));  // without the round-off of the sum
    }
    double const share = 1.0 / (planes * points * points);
    return {sum.mass * share,
            {sum.momentum[0] * share, sum.momentum[1] * share, sum.momentum[2] * share},
            sum.energy * share};
  };
}

}  // namespace g27
