/// Conditions on the sides of a grid, and on parts of them.
#include <fmt/format.h>

#include <cmath>

#include "studies/driver/scene_grid_parts.hpp"
#include "studies/driver/time_table.hpp"

namespace g27 {
namespace {

std::vector<std::string> const kinds{"periodic", "wall", "outflow", "inflow", "symmetry", "moving-shock"};
std::vector<std::string> const state_keys{"density", "velocity", "pressure"};

/// A state that may change in time, the same at every point.
GridBoundary read_inflow(Section const& section, AnyEos const& eos, int dimensions) {
  auto const rho = read_time_table(section, "density", dimension::density);
  auto const p = read_time_table(section, "pressure", dimension::pressure);
  auto const* list = std::get_if<Node::Array>(&section.need("velocity", "[\"10 m/s\", \"0 m/s\"]").value);
  if (list == nullptr || static_cast<int>(list->size()) != dimensions) {
    throw section.error("velocity", list == nullptr ? "is not a list" : fmt::format("has {} entries", list->size()),
                        fmt::format("give {}, one an axis; each may be a table in time", dimensions));
  }
  std::array<TimeTable, 3> u{TimeTable{{0.0}, {0.0}}, {{0.0}, {0.0}}, {{0.0}, {0.0}}};
  for (std::size_t d = 0; d < list->size(); ++d) {
    u[d] = read_time_table(section, (*list)[d], fmt::format("velocity.{}", d), dimension::velocity);
  }
  for (TimeTable const* table : {&rho, &p}) {
    for (double const t : table->t) {
      check_admissible(section, eos, {rho(t), 0, p(t)});
    }
  }
  return {.kind = GridBoundary::Kind::inflow, .state = [=](Vec3 const&, double t) -> GasPoint {
            return {rho(t), {u[0](t), u[1](t), u[2](t)}, p(t)};
          }};
}

/// The state of a plane shock that passes along the side: behind it where (x - point) . normal < speed t.
GridBoundary read_moving_shock(Section const& section, AnyEos const& eos, int dimensions) {
  GasPoint const behind = read_point_state(section.table("behind", state_keys), eos, dimensions);
  GasPoint const ahead = read_point_state(section.table("ahead", state_keys), eos, dimensions);
  Vec3 const point = section.point("point", dimension::length, dimensions), normal = read_normal(section, dimensions);
  double const speed = section.quantity("speed", dimension::velocity);
  return {.kind = GridBoundary::Kind::inflow, .state = [=](Vec3 const& x, double t) {
            double along = 0;
            for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
              along += (x[d] - point[d]) * normal[d];
            }
            return along < speed * t ? behind : ahead;
          }};
}

GridBoundary read_condition(Section const& owner, std::string const& key, AnyEos const& eos, int dimensions) {
  bool const plain = std::holds_alternative<std::string>(owner.need(key, "\"wall\"").value);
  std::vector<std::string> keys{"type", "behind", "ahead", "point", "normal", "speed"};
  keys.insert(keys.end(), state_keys.begin(), state_keys.end());
  std::string kind;
  if (plain) {
    kind = kinds[owner.choice(key, kinds, 0)];
  } else {
    Section const section = owner.table(key, keys);
    kind = kinds[index_of_choice(section, "type", section.text("type"), kinds)];
    if (kind == "inflow") {
      return read_inflow(section.reopened({"type", "density", "velocity", "pressure"}), eos, dimensions);
    }
    if (kind == "moving-shock") {
      return read_moving_shock(section.reopened({"type", "behind", "ahead", "point", "normal", "speed"}), eos,
                               dimensions);
    }
    (void)section.reopened({"type"});
  }
  if (kind == "inflow" || kind == "moving-shock") {
    throw owner.error(key, "needs its state",
                      "write { type = \"inflow\", density = ..., velocity = [...], pressure = ... } or "
                      "{ type = \"moving-shock\", behind = {...}, ahead = {...}, point, normal, speed }");
  }
  return {.kind = kind == "periodic"  ? GridBoundary::Kind::periodic
                  : kind == "outflow" ? GridBoundary::Kind::outflow
                                      : GridBoundary::Kind::wall,
          .state = {}};
}

}  // namespace

Vec3 read_normal(Section const& section, int dimensions) {
  Vec3 n = section.point("normal", dimension::number, dimensions);
  double const length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) {
    throw section.error("normal", "has no length", "give a direction such as [1, 0, 0]");
  }
  for (double& component : n) {
    component /= length;
  }
  return n;
}

std::array<GridBoundary, 6> read_sides(Section const& domain, AnyEos const& eos, int dimensions) {
  std::vector<std::string> keys(side_names().begin(), side_names().begin() + 2 * dimensions);
  keys.push_back("others");
  Section const boundary = domain.table("boundary", keys);
  std::array<GridBoundary, 6> out{};
  for (std::size_t s = 0; s < keys.size() - 1; ++s) {
    if (!boundary.has(keys[s]) && !boundary.has("others")) {
      throw boundary.error(keys[s], "is missing",
                           fmt::format("add {} = \"wall\", or others = \"outflow\" for all sides not named", keys[s]));
    }
    out[s] = read_condition(boundary, boundary.has(keys[s]) ? keys[s] : "others", eos, dimensions);
  }
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
    using Kind = GridBoundary::Kind;
    if ((out[2 * d].kind == Kind::periodic) != (out[2 * d + 1].kind == Kind::periodic)) {
      throw domain.error("boundary", fmt::format("is periodic on one side of {} only", ray_names()[d]),
                         fmt::format("make {} and {} both \"periodic\"", keys[2 * d], keys[2 * d + 1]));
    }
  }
  // Along the axis that a plane has not: whatever the sides of one cell are.
  for (std::size_t s = keys.size() - 1; s < 6; ++s) {
    out[s].kind = GridBoundary::Kind::outflow;
  }
  return out;
}

std::vector<BoundaryPatch> read_patches(Section const& domain, AnyEos const& eos, GridBox const& box) {
  int const dimensions = dimensions_of(box);
  std::vector<std::string> const sides(side_names().begin(), side_names().begin() + 2 * dimensions);
  std::vector<BoundaryPatch> out;
  for (Section const& section : domain.tables("patch", {"side", "extent", "condition"})) {
    BoundaryPatch patch;
    std::size_t const side = index_of_choice(section, "side", section.text("side"), sides);
    patch.side = static_cast<Side>(side);
    auto const extent = section.intervals("extent", dimension::length);
    if (static_cast<int>(extent.size()) != dimensions - 1) {
      throw section.error("extent", fmt::format("has {} intervals", extent.size()),
                          fmt::format("give {}: along the axes that span the side, in their order", dimensions - 1));
    }
    std::size_t next = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
      if (d != side / 2) {
        patch.lower[d] = extent[next][0], patch.upper[d] = extent[next][1];
        ++next;
        if (patch.upper[d] <= box.lower[d] || patch.lower[d] >= box.upper[d]) {
          throw section.error("extent", fmt::format("lies beside the domain along {}", ray_names()[d]),
                              fmt::format("the side goes from {} m to {} m", box.lower[d], box.upper[d]));
        }
      }
    }
    patch.condition = read_condition(section, "condition", eos, dimensions);
    if (patch.condition.kind == GridBoundary::Kind::periodic) {
      throw section.error("condition", "cannot be periodic on a part of a side", "make both whole sides \"periodic\"");
    }
    out.push_back(std::move(patch));
  }
  return out;
}

}  // namespace g27
