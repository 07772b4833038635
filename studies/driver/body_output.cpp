#include "studies/driver/body_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/overset/gas_integrals.hpp"
#include "scheme/grid/cell_place.hpp"

namespace g27 {
namespace {

constexpr char const* restart_group = "/restart/overset";

struct SolidColumn {
  char const *name, *unit;
};
constexpr SolidColumn solid_columns[] = {{"density", "kg/m3"},    {"velocity_x", "m/s"}, {"velocity_y", "m/s"},
                                         {"velocity_z", "m/s"},   {"pressure", "Pa"},    {"von_mises", "Pa"},
                                         {"plastic_strain", "1"}, {"kind", "1"}};
constexpr std::size_t kind_column = std::size(solid_columns) - 1;  // of CellKind; the others are fields of the solid

std::array<double, kind_column> values_of(SolidFields const& q) {
  namespace f = solid_field_of;
  double squares = 0;
  for (std::size_t c = 0; c < 6; ++c) squares += (c < 3 ? 1 : 2) * q[f::S + c] * q[f::S + c];
  return {q[f::rho], q[f::u], q[f::u + 1], q[f::u + 2], q[f::p], std::sqrt(1.5 * squares), q[f::ep]};
}

BodySnapshot snapshot_of(std::string const& name, Body const& body) {
  BodySnapshot out{.name = name, .vertices = {}, .triangles = {}, .velocity = {}, .pressure = {}, .fields = {}};
  for (Vec3 const& x : body.surface.vertices) out.vertices.insert(out.vertices.end(), x.begin(), x.end());
  for (Triangle const& t : body.surface.triangles) out.triangles.insert(out.triangles.end(), t.begin(), t.end());
  for (TriangleState const& t : body.triangles) {
    out.velocity.insert(out.velocity.end(), t.velocity.begin(), t.velocity.end());
    out.pressure.push_back(t.pressure);
  }
  if (body.rigid) return out;
  CellKinds const& kinds = body.solid.kinds;
  for (auto const& [column, unit] : solid_columns) {
    out.fields.push_back({column, unit, std::vector<double>(kinds.count())});
  }
  for (std::size_t i = 0; i < kinds.count(); ++i) {
    out.fields[kind_column].values[i] = static_cast<double>(kinds.kind(i));
    if (!kinds.valid(i)) continue;
    auto const values = values_of(body.solid.states[i]);
    for (std::size_t f = 0; f < values.size(); ++f) out.fields[f].values[i] = values[f];
  }
  return out;
}

void mask(OversetSolver const& solver, GridSnapshot& shot) {
  Int3 const n = solver.gas().cells();
  for (auto const& body : solver.bodies()) {
    CellKinds const& kinds = body->gas.kinds;
    for (std::size_t i = 0; i < kinds.count(); ++i) {
      if (kinds.valid(i) || kinds.is_image(i) || kinds.in_medium(kinds.centre(kinds.cell(i)))) continue;
      std::size_t const at = cell_number(n, kinds.in_grid(kinds.cell(i)));
      for (HistoryColumn& field : shot.fields) field.values[at] = 0;
    }
  }
}

std::string item(std::string const& data, std::string const& dimensions, bool whole = false) {
  return fmt::format("<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"{}\" Dimensions=\"{}\">{}</DataItem>\n",
                     whole ? "Int" : "Float", whole ? 4 : 8, dimensions, data);
}

std::string attribute(std::string const& name, char const* type, std::string const& content) {
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Cell\">\n{}</Attribute>\n", name, type,
                     content);
}

}  // namespace

void add_bodies(SceneRun const& run, OversetSolver const& solver, GridSnapshot& shot) {
  mask(solver, shot);
  shot.fields.push_back({"gas_fraction", "1", gas_share(solver)});
  for (std::size_t n = 0; n < solver.bodies().size(); ++n) {
    shot.bodies.push_back(snapshot_of(run.grid->bodies[n].name, *solver.bodies()[n]));
  }
}

double bytes_of(Body const& body) {
  constexpr double kinds = 3;  // bytes a cell of a window, beside its state
  auto const cells = [](CellKinds const& k) { return static_cast<double>(k.count()); };
  return static_cast<double>(body.grid.bytes()) + cells(body.solid.kinds) * (sizeof(SolidFields) + kinds) +
         cells(body.gas.kinds) * (sizeof(GasFields) + kinds) +
         static_cast<double>(body.triangles.size()) *
             (sizeof(TriangleState) + 2 * (sizeof(CloudPoint<GasFields>) + sizeof(CloudPoint<SolidFields>)) +
              sizeof(ModelResult));
}

void write_bodies(Hdf5Writer& out, std::string const& path, SceneRun const& run, GridSnapshot const& shot) {
  for (std::size_t n = 0; n < shot.bodies.size(); ++n) {
    BodySnapshot const& body = shot.bodies[n];
    std::string const group = fmt::format("{}/body/{}", path, body.name);
    std::uint64_t const vertices = body.vertices.size() / 3, triangles = body.pressure.size();
    out.write(group + "/vertices", body.vertices, "m", {vertices, 3});
    out.write_integers(group + "/triangles", body.triangles, {triangles, 3});
    out.write(group + "/velocity", body.velocity, "m/s", {triangles, 3});
    out.write(group + "/pressure", body.pressure, "Pa");
    if (body.fields.empty()) continue;
    WindowBox const box = solid_window(run.grid->bodies[n].setup, run.grid->bodies[n].cut);
    std::vector<std::uint64_t> shape;
    for (std::size_t a : {2u, 1u, 0u}) shape.push_back(static_cast<std::uint64_t>(box.size[a]));
    for (HistoryColumn const& field : body.fields) {
      out.write(group + "/grid/" + field.name, field.values, field.unit, shape);
    }
    out.write(group + "/grid/lower", box.corner(), "m");
    out.attribute(group + "/grid", "cell", box.h);
  }
}

std::string body_xdmf(SceneRun const& run, double const* sizes, std::string const& data) {
  std::string out;
  for (std::size_t n = 0; n < run.grid->bodies.size(); ++n) {
    SceneBody const& body = run.grid->bodies[n];
    auto const vertices = static_cast<long>(sizes[2 * n]), triangles = static_cast<long>(sizes[2 * n + 1]);
    std::string const at = fmt::format("{}/body/{}/", data, body.name), three = fmt::format("{} 3", triangles);
    out += fmt::format(
        "<Grid Name=\"{0}\">\n<Topology TopologyType=\"Triangle\" NumberOfElements=\"{1}\">\n{2}</Topology>\n"
        "<Geometry GeometryType=\"XYZ\">\n{3}</Geometry>\n{4}{5}</Grid>\n",
        body.name, triangles, item(at + "triangles", three, true), item(at + "vertices", fmt::format("{} 3", vertices)),
        attribute("velocity", "Vector", item(at + "velocity", three)),
        attribute("pressure", "Scalar", item(at + "pressure", std::to_string(triangles))));
    if (body.setup.rigid) continue;
    WindowBox const box = solid_window(body.setup, body.cut);
    Vec3 const corner = box.corner();
    auto const& c = box.size;
    out += fmt::format(
        "<Grid Name=\"{} within\">\n<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
        "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n<DataItem Format=\"XML\" Dimensions=\"3\">{} {} {}</DataItem>\n"
        "<DataItem Format=\"XML\" Dimensions=\"3\">{} {} {}</DataItem>\n</Geometry>\n",
        body.name, c[2] + 1, c[1] + 1, c[0] + 1, corner[2], corner[1], corner[0], box.h, box.h, box.h);
    for (auto const& [column, unit] : solid_columns) {
      out += attribute(column, "Scalar", item(at + "grid/" + column, fmt::format("{} {} {}", c[2], c[1], c[0])));
    }
    out += "</Grid>\n";
  }
  return out;
}

void write_overset(Hdf5Writer& out, GridRestart const& restart) {
  for (auto const& [name, values] : restart.overset) out.write(fmt::format("{}/{}", restart_group, name), values, "SI");
}

void read_overset(Hdf5Reader const& in, GridRestart& restart) {
  restart.overset.clear();
  if (!in.has(restart_group)) return;
  auto const read_group = [&](auto const& self, std::string const& group) -> void {
    for (std::string const& name : in.names(restart_group + group)) {
      std::string const path = group + "/" + name;
      if (in.is_group(restart_group + path)) {
        self(self, path);
      } else {
        restart.overset[path.substr(1)] = in.read(restart_group + path);
      }
    }
  };
  read_group(read_group, "");
}

}  // namespace g27
