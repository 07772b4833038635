/// [[body]]: deforming bodies in the gas.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fsi/surface/gap.hpp"
#include "fsi/surface/polygon_mesh.hpp"
#include "studies/driver/scene_grid_parts.hpp"
#include "studies/driver/scene_surface.hpp"

namespace g27 {
namespace {

constexpr double fewest_across = 4;  ///< of its own grid across a body: two layers of cores from either side

std::vector<std::string> const body_keys{"name", "surface",  "scale", "center", "rotate",  "velocity",
                                         "spin", "material", "cell",  "extent", "pressure"};

double width_of(GridBox const& box) { return (box.upper[0] - box.lower[0]) / box.cells[0]; }

std::string read_name(Section const& body, std::vector<SceneBody> const& others) {
  std::string const name = body.text("name");
  // it names groups of HDF5 files and grids of XDMF ones
  bool const plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == ' ' || c == '-' || c == '_';
  });
  if (name.empty() || !plain) {
    throw body.error("name",
                     fmt::format("'{}' is empty or has other characters than letters, digits, ' ', - and _", name),
                     "give a short name");
  }
  for (SceneBody const& other : others) {
    if (other.name == name) {
      throw body.error("name", fmt::format("'{}' is taken", name), "give each body its own name");
    }
  }
  return name;
}

/// Bodies keep a few cells from the domain's sides.
BoundingBox room_in(GridBox const& box) {
  double const gap = side_gap_cells * width_of(box);
  return {box.lower + Vec3{gap, gap, gap}, box.upper - Vec3{gap, gap, gap}};
}

void check_inside(Section const& body, std::string const& key, BoundingBox const& what, GridBox const& box,
                  std::string const& remedy) {
  BoundingBox const room = room_in(box);
  for (std::size_t a = 0; a < 3; ++a) {
    bool const low = what.lower[a] < room.lower[a] - 1e-9 * width_of(box);
    if (low || what.upper[a] > room.upper[a] + 1e-9 * width_of(box)) {
      throw body.error(
          key,
          fmt::format("reaches {}{} = {:.6g} m, beside the domain or within {} cells of its side",
                      low ? "down to " : "up to ", ray_names()[a], low ? what.lower[a] : what.upper[a], side_gap_cells),
          fmt::format("{} from {:.6g} m to {:.6g} m", remedy, room.lower[a], room.upper[a]));
    }
  }
}

/// The box that the body stays in: as given, or on each side by the cube root of its box's volume more.
void set_extent(Section const& body, GridBox const& box, BodySetup& setup) {
  BoundingBox const own = bounding_box(setup.surface);
  Vec3 const size = own.upper - own.lower;
  if (body.has("extent")) {
    auto const extent = body.intervals("extent", dimension::length);
    if (extent.size() != 3) {
      throw body.error("extent", fmt::format("has {} intervals", extent.size()), "give 3, one an axis");
    }
    for (std::size_t a = 0; a < 3; ++a) {
      setup.lower[a] = extent[a][0], setup.upper[a] = extent[a][1];
      if (setup.lower[a] > own.lower[a] || setup.upper[a] < own.upper[a]) {
        throw body.error("extent",
                         fmt::format("does not hold the body, which reaches from {:.6g} m to {:.6g} m along {}",
                                     own.lower[a], own.upper[a], ray_names()[a]),
                         "enlarge it to where the body may go");
      }
    }
    check_inside(body, "extent", {setup.lower, setup.upper}, box, "keep it");
    return;
  }
  double const way = std::cbrt(size[0] * size[1] * size[2]);
  BoundingBox const room = room_in(box);
  for (std::size_t a = 0; a < 3; ++a) {
    setup.lower[a] = std::max(own.lower[a] - way, room.lower[a]);
    setup.upper[a] = std::min(own.upper[a] + way, room.upper[a]);
  }
}

SceneBody read_body(Section const& root, Section const& section, GridBox const& box,
                    std::function<GasPoint(Vec3 const&)> const& point, std::vector<SceneBody> const& others) {
  SceneBody body;
  body.name = read_name(section, others);
  body.key = section.path();
  body.file = section.text("surface");
  BodySetup& setup = body.setup;
  setup.cell = section.has("cell") ? section.positive("cell", dimension::length) : width_of(box);
  Solid const solid = read_solid(root, section);
  setup.material = solid.law, body.density = solid.density;
  LoadedSurface loaded = load_surface(section);
  place_surface(section, loaded.surface);
  BoundingBox const own = bounding_box(loaded.surface);
  check_inside(section, "center", own, box, "place the body");
  Vec3 const size = own.upper - own.lower;
  MassProperties const mass = mass_properties(loaded.surface);
  // 6 V/A is the edge of a cube and three times the thickness of a plate
  double const across = std::min({size[0], size[1], size[2], 6 * mass.volume / mass.area});
  if (across < (1 - 1e-6) * fewest_across * setup.cell) {
    throw section.error("cell", fmt::format("makes the body {:.2g} cells thin", across / setup.cell),
                        fmt::format("choose it below {:.3g} m, or check scale", across / fewest_across));
  }
  mesh_surface(section, setup.cell, loaded);
  setup.surface = std::move(loaded.surface);
  body.fingerprint = loaded.fingerprint, body.remarks = std::move(loaded.remarks);
  set_extent(section, box, setup);

  Vec3 const centre = mass_properties(setup.surface).centroid;
  Vec3 const u = section.has("velocity") ? section.point("velocity", dimension::velocity, 3) : Vec3{0, 0, 0};
  Vec3 const spin = section.has("spin") ? section.point("spin", dimension::angular_velocity, 3) : Vec3{0, 0, 0};
  double const pressure = section.has("pressure") ? section.quantity("pressure", dimension::pressure) : point(centre).p;
  SolidPoint const rest = solid_at_rest(solid, pressure);
  if (!(rest.rho > 0 &&
        std::visit([&](auto const& eos) { return eos.bulk_modulus(rest.rho, rest.p); }, solid.law.eos) > 0)) {
    throw section.error("pressure", fmt::format("{} Pa leaves the body no density or stiffness", pressure),
                        "give a higher one");
  }
  setup.initial = [=](Vec3 const& x) {
    SolidPoint s = rest;
    s.u = u + cross(spin, x - centre);
    return s;
  };
  return body;
}

void check_apart(Section const& section, SceneBody const& a, SceneBody const& b, double least) {
  TriangleSurface both = a.setup.surface;
  int const shift = static_cast<int>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), b.setup.surface.vertices.begin(), b.setup.surface.vertices.end());
  for (Triangle const& t : b.setup.surface.triangles)
    both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  bool const overlap = !self_intersections(both, 1).empty() || within(a.setup.surface.vertices[0], b.setup.surface) ||
                       within(b.setup.surface.vertices[0], a.setup.surface);
  if (overlap) {
    throw section.error("center", fmt::format("makes '{}' overlap '{}'", b.name, a.name), "move one of the two");
  }
  double const gap = gap_between(a.setup.surface, b.setup.surface, least);
  if (gap < least) {
    throw section.error("center", fmt::format("leaves {:.3g} m between '{}' and '{}'", gap, a.name, b.name),
                        fmt::format("leave {:.3g} m, a cell of the gas, or take smaller cells", least));
  }
}

}  // namespace

std::vector<SceneBody> read_bodies(Section const& root, GridBox const& box,
                                   std::function<GasPoint(Vec3 const&)> const& point) {
  std::vector<SceneBody> out;
  auto const sections = root.tables("body", body_keys);
  if (sections.empty()) {
    return out;
  }
  if (dimensions_of(box) != 3) {
    throw root.error("body", "needs three dimensions", "give domain.extent three intervals");
  }
  if (root.has("block")) {
    throw root.error("block", "does not go with [[body]]", "remove it: rigid blocks and bodies are not there together");
  }
  double const h = width_of(box);
  for (std::size_t a = 1; a < 3; ++a) {
    double const other = (box.upper[a] - box.lower[a]) / box.cells[a];
    if (std::fabs(other / h - 1) > 1e-6) {
      throw root.error("domain",
                       fmt::format("has cells of {:.6g} m along x and {:.6g} m along {}", h, other, ray_names()[a]),
                       "choose cells of one width: bodies need them");
    }
  }
  for (Section const& section : sections) {
    SceneBody body = read_body(root, section, box, point, out);
    for (SceneBody const& other : out) check_apart(section, other, body, body_gap_cells * h);
    out.push_back(std::move(body));
  }
  return out;
}

}  // namespace g27
