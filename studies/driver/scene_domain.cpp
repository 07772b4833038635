/// [domain]: mesh, its motion and the two boundaries.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/driver/scene_parts.hpp"
#include "studies/driver/time_table.hpp"

namespace g27 {
namespace {

constexpr long most_cells = 50'000'000;

long read_cell_count(Section const& domain, double length) {
  if (domain.has("cells") == domain.has("cell")) {
    throw domain.error("cells", domain.has("cells") ? "and cell are both given" : "is missing",
                       "give either cells = 400 or cell = \"1 mm\"");
  }
  if (domain.has("cells")) {
    return domain.integer("cells", 4, most_cells);
  }
  double const count = std::round(length / domain.positive("cell", dimension::length));
  if (!(count >= 4 && count <= static_cast<double>(most_cells))) {
    throw domain.error("cell", fmt::format("makes {} cells in the extent", count),
                       fmt::format("choose it for 4 to {} cells", most_cells));
  }
  return static_cast<long>(count);
}

}  // namespace

std::vector<double> read_faces(Section const& domain) {
  std::size_t kind = 0;
  std::optional<Section> mesh;
  std::vector<std::string> const kinds{"uniform", "graded", "faces"};
  if (domain.has("mesh")) {
    if (std::holds_alternative<std::string>(domain.need("mesh", "").value)) {
      kind = domain.choice("mesh", kinds, 0);
      if (kind != 0) {
        throw domain.error("mesh", fmt::format("'{}' needs its parameters", kinds[kind]),
                           "write mesh = { type = \"graded\", ratio = 4 } or { type = \"faces\", faces = [...] }");
      }
    } else {
      mesh = domain.table("mesh", {"type", "ratio", "faces"});
      kind = index_of_choice(*mesh, "type", mesh->text("type"), kinds);
    }
  }
  std::vector<double> faces;
  if (kind == 2) {
    for (char const* key : {"extent", "cells", "cell"}) {
      if (domain.has(key)) {
        throw domain.error(key, "is given beside a table of faces", "remove it: the faces say it all");
      }
    }
    faces = mesh->reopened({"type", "faces"}).quantities("faces", dimension::length);
    if (faces.size() < 5) {
      throw mesh->error("faces", fmt::format("makes {} cells", faces.empty() ? 0 : faces.size() - 1),
                        "give at least 5 faces (4 cells)");
    }
    for (std::size_t i = 1; i < faces.size(); ++i) {
      if (!(faces[i] > faces[i - 1])) {
        throw mesh->error("faces", fmt::format("does not increase at entry {}", i), "sort the positions");
      }
    }
    return faces;
  }
  auto const [a, b] = domain.interval("extent", dimension::length);
  long const n = read_cell_count(domain, b - a);
  double ratio = 1;
  if (kind == 1) {
    ratio = mesh->reopened({"type", "ratio"}).positive("ratio", dimension::number);
    if (ratio < 1e-3 || ratio > 1e3) {
      throw mesh->error("ratio", fmt::format("{} is out of range", ratio),
                        "give last cell over first cell, from 0.001 to 1000");
    }
  }
  // Cells in geometric progression: face i at (q^i - 1)/(q^n - 1).
  double const q = std::pow(ratio, 1.0 / static_cast<double>(n - 1));
  faces.resize(static_cast<std::size_t>(n) + 1);
  for (long i = 0; i <= n; ++i) {
    auto const k = static_cast<double>(i), m = static_cast<double>(n);
    double const s = std::fabs(q - 1) < 1e-12 ? k / m : std::expm1(k * std::log(q)) / std::expm1(m * std::log(q));
    faces[static_cast<std::size_t>(i)] = a + (b - a) * s;
  }
  faces.back() = b;
  return faces;
}

MeshMotion read_motion(Section const& domain, double left, double right) {
  std::vector<std::string> const kinds{"fixed", "prescribed", "stretched", "lagrangian"};
  MeshMotion motion;
  if (!domain.has("motion")) {
    return motion;
  }
  if (std::holds_alternative<std::string>(domain.need("motion", "").value)) {
    motion.kind = static_cast<MeshMotion::Kind>(domain.choice("motion", kinds, 0));
    if (motion.kind == MeshMotion::Kind::prescribed) {
      throw domain.error("motion", "'prescribed' needs its parameters",
                         "write motion = { type = \"prescribed\", amplitude = \"1 mm\", period = \"10 us\" }");
    }
    return motion;
  }
  Section const section = domain.table("motion", {"type", "amplitude", "period"});
  motion.kind = static_cast<MeshMotion::Kind>(index_of_choice(section, "type", section.text("type"), kinds));
  if (motion.kind != MeshMotion::Kind::prescribed) {
    (void)section.reopened({"type"});
    return motion;
  }
  double const amplitude = section.quantity("amplitude", dimension::length);
  double const period = section.positive("period", dimension::time), length = right - left;
  if (std::fabs(amplitude) * std::numbers::pi >= length) {
    throw section.error("amplitude", "would make the faces cross", "keep it below a third of the extent");
  }
  // Half a sine over the extent keeps the ends at rest; dx/dx0 = 1 + amplitude pi/length cos(...) stays > 0.
  motion.position = [=](double x0, double t) {
    return x0 +
           amplitude * std::sin(2 * std::numbers::pi * t / period) * std::sin(std::numbers::pi * (x0 - left) / length);
  };
  return motion;
}

GasBoundary read_boundary(Section const& domain, std::string const& side, AnyEos const& eos) {
  std::vector<std::string> const kinds{"periodic", "wall", "outflow", "inflow", "piston"};
  Section const boundary = domain.table("boundary", {"left", "right"});
  GasBoundary out;
  if (std::holds_alternative<std::string>(boundary.need(side, "\"wall\"").value)) {
    out.kind = static_cast<GasBoundary::Kind>(boundary.choice(side, kinds, 0));
    if (out.kind == GasBoundary::Kind::inflow || out.kind == GasBoundary::Kind::piston) {
      throw boundary.error(side, "needs its state",
                           "write { type = \"piston\", velocity = \"100 m/s\" } or { type = \"inflow\", density = ..., "
                           "velocity = ..., pressure = ... }");
    }
    return out;
  }
  Section const section = boundary.table(side, {"type", "density", "velocity", "pressure"});
  out.kind = static_cast<GasBoundary::Kind>(index_of_choice(section, "type", section.text("type"), kinds));
  if (out.kind == GasBoundary::Kind::piston) {
    out.velocity = read_time_table(section.reopened({"type", "velocity"}), "velocity", dimension::velocity);
  } else if (out.kind == GasBoundary::Kind::inflow) {
    auto const rho = read_time_table(section, "density", dimension::density);
    auto const u = read_time_table(section, "velocity", dimension::velocity);
    auto const p = read_time_table(section, "pressure", dimension::pressure);
    for (TimeTable const* table : {&rho, &u, &p}) {
      for (double const t : table->t) {
        check_admissible(section, eos, {rho(t), u(t), p(t)});
      }
    }
    out.state = [=](double, double t) { return GasState<>{rho(t), u(t), p(t)}; };
  } else {
    (void)section.reopened({"type"});
  }
  return out;
}

}  // namespace g27
