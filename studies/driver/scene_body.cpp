/// [[body]]: bodies in the gas.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fsi/surface/clip.hpp"
#include "fsi/surface/gap.hpp"
#include "fsi/surface/polygon_mesh.hpp"
#include "studies/driver/scene_grid_parts.hpp"
#include "studies/driver/scene_surface.hpp"
#include "studies/driver/time_table.hpp"

namespace g27 {
namespace {

constexpr double fewest_across = 3;     ///< of its own grid across a body: what a plate needs (study fsi-slab)
constexpr double most_triangles = 1e6;  ///< of a body
constexpr double lightest = 0.03;       ///< rigid body that is stable in a shock, over the gas's density

std::vector<std::string> const body_keys{"name",     "surface", "scale",  "center",   "rotate", "velocity", "spin",
                                         "material", "cell",    "extent", "pressure", "motion", "clamped"};

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

/// But on those that cut the body.
void check_inside(Section const& body, std::string const& key, BoundingBox const& what, GridBox const& box,
                  Mirrors const& cut, std::string const& remedy) {
  BoundingBox const room = room_in(box);
  for (std::size_t a = 0; a < 3; ++a) {
    bool const low = !cut.low[a] && what.lower[a] < room.lower[a] - 1e-9 * width_of(box);
    if (low || (!cut.high[a] && what.upper[a] > room.upper[a] + 1e-9 * width_of(box))) {
      throw body.error(
          key,
          fmt::format("reaches {}{} = {:.6g} m, beside the domain or within {} cells of its side",
                      low ? "down to " : "up to ", ray_names()[a], low ? what.lower[a] : what.upper[a], side_gap_cells),
          fmt::format("{} from {:.6g} m to {:.6g} m", remedy, room.lower[a], room.upper[a]));
    }
  }
}

/// The box that the body stays in: as given, or on each side by the cube root of its box's volume more.
void set_extent(Section const& body, GridBox const& box, Mirrors const& cut, BodySetup& setup) {
  BoundingBox const own = bounding_box(setup.surface);
  if (body.has("extent")) {
    auto const extent = body.intervals("extent", dimension::length);
    if (extent.size() != 3) {
      throw body.error("extent", fmt::format("has {} intervals", extent.size()), "give 3, one an axis");
    }
    for (std::size_t a = 0; a < 3; ++a) setup.lower[a] = extent[a][0], setup.upper[a] = extent[a][1];
    setup = bounded(std::move(setup), cut);
    for (std::size_t a = 0; a < 3; ++a) {
      if (setup.lower[a] > own.lower[a] || setup.upper[a] < own.upper[a]) {
        throw body.error("extent",
                         fmt::format("does not hold the body, which reaches from {:.6g} m to {:.6g} m along {}",
                                     own.lower[a], own.upper[a], ray_names()[a]),
                         "enlarge it to where the body may go");
      }
    }
    check_inside(body, "extent", {setup.lower, setup.upper}, box, cut, "keep it");
    return;
  }
  Vec3 const size = own.upper - own.lower;
  double const way = std::cbrt(size[0] * size[1] * size[2]);
  BoundingBox const room = room_in(box);
  for (std::size_t a = 0; a < 3; ++a) {
    setup.lower[a] = std::max(own.lower[a] - way, room.lower[a]);
    setup.upper[a] = std::min(own.upper[a] + way, room.upper[a]);
  }
  setup = bounded(std::move(setup), cut);
}

/// The planes among `walls` that a body with this box reaches across.
Mirrors planes_that_cut(BoundingBox const& own, Mirrors walls) {
  for (std::size_t a = 0; a < 3; ++a) {
    walls.low[a] = walls.low[a] && own.lower[a] < walls.lower[a];
    walls.high[a] = walls.high[a] && own.upper[a] > walls.upper[a];
  }
  return walls;
}

/// The part of the body within the domain; the plane it is a mirror image at keeps its vertices.
void cut_at(Section const& section, Mirrors const& cut, double cell, TriangleSurface& surface) {
  constexpr double snap = 0.3;  // cells
  try {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cut.low[a]) surface = clip_surface(std::move(surface), a, cut.lower[a], true, snap * cell);
      if (cut.high[a]) surface = clip_surface(std::move(surface), a, cut.upper[a], false, snap * cell);
    }
    find_cut(surface, cut, 1e-3 * cell);
  } catch (SurfaceError const& error) {
    throw section.error("center", error.problem, error.remedy);
  }
}

/// What is mirrored at a plane does not move across it.
void check_symmetric(Section const& section, Mirrors const& cut, Vec3 const& velocity, Vec3 const& spin) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (!cut.across(a)) continue;
    bool const turns = spin[(a + 1) % 3] != 0 || spin[(a + 2) % 3] != 0;
    if (velocity[a] != 0 || turns) {
      throw section.error(
          turns ? "spin" : "velocity",
          fmt::format("moves the body across the plane of symmetry that cuts it along {}", ray_names()[a]),
          "leave it out, or compute the whole body");
    }
  }
}

/// Velocity in time, each component a table or a number.
std::array<TimeTable, 3> read_given_velocity(Section const& section) {
  constexpr char const* example = R"([[["0 us", "0 m/s"], ["1 us", "100 m/s"]], "0 m/s", "0 m/s"])";
  auto const* list = std::get_if<Node::Array>(&section.need("velocity", example).value);
  if (list == nullptr || list->size() != 3) {
    throw section.error("velocity", list == nullptr ? "is not a list" : fmt::format("has {} entries", list->size()),
                        "give 3, one an axis");
  }
  std::array<TimeTable, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    out[a] = read_time_table(section, (*list)[a], fmt::format("velocity.{}", a), dimension::velocity);
  }
  return out;
}

struct Motion {
  Vec3 velocity{0, 0, 0}, spin{0, 0, 0};
};

Motion motion_at_start(Section const& section, Mirrors const& cut) {
  Motion m;
  if (section.has("velocity")) m.velocity = section.point("velocity", dimension::velocity, 3);
  if (section.has("spin")) m.spin = section.point("spin", dimension::angular_velocity, 3);
  check_symmetric(section, cut, m.velocity, m.spin);
  return m;
}

RigidSetup read_rigid(Section const& section, Mirrors const& cut, double density) {
  if (section.has("pressure")) {
    throw section.error("pressure", "is nothing that a rigid body has", "remove it, or choose another material");
  }
  RigidSetup out{.density = density};
  if (section.choice("motion", {"free", "given"}, 0) == 0) {
    Motion const m = motion_at_start(section, cut);
    out.velocity = m.velocity, out.spin = m.spin;
    return out;
  }
  std::array<TimeTable, 3> const u = read_given_velocity(section);
  if (section.has("spin")) out.spin = section.point("spin", dimension::angular_velocity, 3);
  for (std::size_t a = 0; a < 3; ++a) {
    for (double v : u[a].v) check_symmetric(section, cut, {a == 0 ? v : 0, a == 1 ? v : 0, a == 2 ? v : 0}, out.spin);
  }
  out.given = [u](double t) { return Vec3{u[0](t), u[1](t), u[2](t)}; };
  out.velocity = out.given(0);
  return out;
}

SceneBody read_body(Section const& root, Section const& section, GridBox const& box, Mirrors const& walls,
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
  body.cut = planes_that_cut(own, walls);
  setup.clamps = body.cut.clamps = read_clamps(section, body.cut, solid.rigid);
  check_inside(section, "center", own, box, body.cut, "place the body");
  Vec3 const size = own.upper - own.lower;
  MassProperties const mass = mass_properties(loaded.surface);
  // 6 V/A is the edge of a cube and three times the thickness of a plate
  double const across = std::min({size[0], size[1], size[2], 6 * mass.volume / mass.area});
  if (across < (1 - 1e-6) * fewest_across * setup.cell) {
    throw section.error("cell", fmt::format("makes the body {:.2g} cells thin", across / setup.cell),
                        fmt::format("choose it below {:.3g} m, or check scale", across / fewest_across));
  }
  if (double const triangles = 2 * mass.area / (setup.cell * setup.cell); triangles > most_triangles) {
    throw section.error(
        "cell", fmt::format("makes about {:.2g} triangles", triangles),
        fmt::format("choose it above {:.3g} m, or check scale", std::sqrt(2 * mass.area / most_triangles)));
  }
  mesh_surface(section, setup.cell, loaded);
  body.whole = setup.surface = std::move(loaded.surface);
  cut_at(section, body.cut, setup.cell, setup.surface);
  body.fingerprint = loaded.fingerprint, body.remarks = std::move(loaded.remarks);
  set_extent(section, box, body.cut, setup);

  Vec3 const centre = mass_properties(body.whole).centroid;
  if (solid.rigid) {
    setup.rigid = read_rigid(section, body.cut, solid.density);
    double const least = lightest * point(centre).rho;
    if (!setup.rigid->given && solid.density < least) {
      throw section.error(
          "material",
          fmt::format("is of {:.3g} kg/m3, so light beside the gas that its motion would be unstable", solid.density),
          fmt::format("take one of {:.3g} kg/m3 at least", least));
    }
    return body;
  }
  if (section.has("motion")) {
    throw section.error("motion", "is for rigid bodies", "remove it, or choose a material with strength.type rigid");
  }
  auto const [u, spin] = motion_at_start(section, body.cut);
  if (setup.clamps.any() && (length(u) > 0 || length(spin) > 0)) {
    throw section.error(length(u) > 0 ? "velocity" : "spin", "moves a body that is clamped", "remove it, or clamped");
  }
  double const pressure = section.has("pressure") ? section.quantity("pressure", dimension::pressure) : point(centre).p;
  SolidPoint const rest = solid_at_rest(solid, pressure);
  if (!(rest.rho > 0 &&
        std::visit([&](auto const& eos) { return eos.bulk_modulus(rest.rho, rest.p); }, solid.law.eos) > 0)) {
    throw section.error("pressure", fmt::format("{} Pa leaves the body no density or stiffness", pressure),
                        "give a higher one");
  }
  setup.initial = [rest, centre, u = u, spin = spin](Vec3 const& x) {
    SolidPoint s = rest;
    s.u = u + cross(spin, x - centre);
    return s;
  };
  return body;
}

void check_apart(Section const& section, SceneBody const& a, SceneBody const& b, double least) {
  TriangleSurface both = a.whole;
  int const shift = static_cast<int>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), b.whole.vertices.begin(), b.whole.vertices.end());
  for (Triangle const& t : b.whole.triangles) both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  bool const overlap = !self_intersections(both, 1).empty() || within(a.whole.vertices[0], b.whole) ||
                       within(b.whole.vertices[0], a.whole);
  if (overlap) {
    throw section.error("center", fmt::format("makes '{}' overlap '{}'", b.name, a.name), "move one of the two");
  }
  double const gap = gap_between(a.whole, b.whole, least);
  if (gap < least) {
    throw section.error("center", fmt::format("leaves {:.3g} m between '{}' and '{}'", gap, a.name, b.name),
                        fmt::format("leave {:.3g} m, a cell of the gas, or take smaller cells", least));
  }
}

}  // namespace

std::vector<SceneBody> read_bodies(Section const& root, GasGridSetup const& gas,
                                   std::function<GasPoint(Vec3 const&)> const& point) {
  GridBox const box{gas.lower, gas.upper, gas.cells};
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
    SceneBody body = read_body(root, section, box, walls_of(gas), point, out);
    for (SceneBody const& other : out) check_apart(section, other, body, body_gap_cells * h);
    out.push_back(std::move(body));
  }
  return out;
}

}  // namespace g27
