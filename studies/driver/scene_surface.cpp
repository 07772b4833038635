#include "studies/driver/scene_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "fsi/surface/remesh.hpp"
#include "fsi/surface/repair.hpp"
#include "fsi/surface/stl_file.hpp"
#include "studies/driver/digest.hpp"

namespace g27 {
namespace {

constexpr double shortest_edge = 0.4, longest_edge = 1.7;  ///< cells

std::filesystem::path file_of(Section const& body) {
  return std::filesystem::path(body.reading().file).parent_path() / body.text("surface");
}

std::uint64_t fingerprint_of(std::filesystem::path const& file) {
  std::ifstream in(file, std::ios::binary);
  Digest digest;
  digest.add(std::string(std::istreambuf_iterator<char>(in), {}));
  return digest.value();
}

std::string faults_of(Diagnosis const& diagnosis) {
  std::string out;
  for (SurfaceFinding const& f : diagnosis.findings) {
    out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", fault_name(f.fault), f.count);
  }
  return out;
}

void require_healthy(Section const& body, Diagnosis const& diagnosis) {
  if (diagnosis.healthy()) {
    return;
  }
  throw body.error(
      "surface", fmt::format("{} is not the surface of a body ({})", body.text("surface"), faults_of(diagnosis)),
      fmt::format("{}; see g27 stl {}", fault_remedy(diagnosis.findings[0].fault), file_of(body).string()));
}

}  // namespace

LoadedSurface load_surface(Section const& body) {
  std::filesystem::path const file = file_of(body);
  double const scale = body.positive("scale", dimension::length);
  LoadedSurface out;
  try {
    StlFile const stl = read_stl(file);
    out.surface = weld(stl.facets, scale);
  } catch (SurfaceError const& error) {
    throw body.error("surface", error.problem, fmt::format("{}; see g27 stl {}", error.remedy, file.string()));
  }
  out.fingerprint = fingerprint_of(file);
  Diagnosis diagnosis = diagnose(out.surface);
  if (!diagnosis.healthy()) {
    Repair done = repair(out.surface);
    if (done.surface.size() > 0) {
      require_healthy(body, done.diagnosis);
      for (RepairStep const& step : done.steps) {
        out.remarks.push_back(fmt::format("{}: {}", step.what, step.count));
      }
      out.surface = std::move(done.surface), diagnosis = std::move(done.diagnosis);
    }
    require_healthy(body, diagnosis);
  }
  if (diagnosis.shells != 1) {
    throw body.error("surface", fmt::format("{} holds {} closed surfaces", body.text("surface"), diagnosis.shells),
                     "give each body a file with one: cavities and bodies of several parts are not there");
  }
  return out;
}

void place_surface(Section const& body, TriangleSurface& surface) {
  Vec3 const centre = body.point("center", dimension::length, 3);
  Vec3 axis{0, 0, 1};
  double angle = 0;
  if (body.has("rotate")) {
    Section const rotate = body.table("rotate", {"axis", "angle"});
    axis = rotate.point("axis", dimension::number, 3);
    angle = rotate.quantity("angle", dimension::angle);
    if (!(length(axis) > 0)) {
      throw rotate.error("axis", "has no length", "give a direction, as [0, 0, 1]");
    }
    axis = (1 / length(axis)) * axis;
  }
  Vec3 const from = mass_properties(surface).centroid;
  for (Vec3& x : surface.vertices) {  // Rodrigues' formula
    Vec3 const r = x - from;
    x = std::cos(angle) * r + std::sin(angle) * cross(axis, r) + ((1 - std::cos(angle)) * dot(axis, r)) * axis + centre;
  }
}

void mesh_surface(Section const& body, double cell, LoadedSurface& loaded) {
  EdgeLengths const edges = diagnose(loaded.surface).edges;
  if (edges.smallest >= shortest_edge * cell && edges.largest <= longest_edge * cell) {
    return;
  }
  std::size_t const before = loaded.surface.size();
  double const volume = mass_properties(loaded.surface).volume;
  try {
    loaded.surface = remesh(loaded.surface, {.edge = cell});
  } catch (SurfaceError const& error) {
    throw body.error("cell", error.problem, "give a larger cell");
  }
  require_healthy(body, diagnose(loaded.surface));
  loaded.remarks.push_back(
      fmt::format("{} triangles with edges of {:.2g} to {:.2g} cells meshed anew to {}, volume {:+.2g} %", before,
                  edges.smallest / cell, edges.largest / cell, loaded.surface.size(),
                  100 * (mass_properties(loaded.surface).volume / volume - 1)));
}

}  // namespace g27
