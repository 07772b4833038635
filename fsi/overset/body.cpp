#include "fsi/overset/body.hpp"

#include <algorithm>
#include <cmath>

#include "fsi/overset/normal_motion.hpp"

namespace g27 {

namespace {

constexpr int margin = 4;  ///< cells of a window beyond the box that the body stays in
constexpr Int3 smallest_grid{4, 4, 4};
constexpr Int3 body_tile{16, 8, 8};  ///< of a body's grid: small, since only tiles with cells of the body are computed

}  // namespace

Mirrors walls_of(GasGridSetup const& gas) {
  Mirrors m{.lower = gas.lower, .upper = gas.upper};
  auto const wall = [&](std::size_t side) {
    for (BoundaryPatch const& p : gas.patches) {
      if (static_cast<std::size_t>(p.side) == side) return false;
    }
    return gas.sides[side].kind == GridBoundary::Kind::wall;
  };
  for (std::size_t a = 0; a < 3; ++a) m.low[a] = wall(2 * a), m.high[a] = wall(2 * a + 1);
  return m;
}

BodySetup bounded(BodySetup s, Mirrors const& cut) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (cut.low[a]) s.lower[a] = cut.lower[a];
    if (cut.high[a]) s.upper[a] = cut.upper[a];
  }
  return s;
}

WindowBox solid_window(BodySetup const& s, Mirrors const& cut) {
  if (s.rigid) return {.lower = s.lower, .h = s.cell, .grid = smallest_grid, .size = smallest_grid};
  WindowBox box{.lower = {}, .h = s.cell, .grid = {}, .first = {0, 0, 0}, .size = {}, .mirrors = cut};
  for (std::size_t a = 0; a < 3; ++a) {
    double const cells = (s.upper[a] - s.lower[a]) / s.cell;
    bool const low = cut.low[a], high = cut.high[a];
    int const n = static_cast<int>(std::ceil(cells - 1e-9)) + (low ? 0 : margin) + (high ? 0 : margin);
    if (low && high && (std::fabs(cells - std::round(cells)) > 1e-6 || n < margin)) {
      throw SurfaceError("walls on both sides cut a body whose cells do not divide their distance, or are fewer than 4",
                         "choose another width of its cells");
    }
    box.grid[a] = n, box.size[a] = n + (low ? margin : 0) + (high ? margin : 0);
    box.first[a] = low ? -margin : 0;
    double const from_middle = 0.5 * (s.lower[a] + s.upper[a]) - 0.5 * n * s.cell;
    box.lower[a] = low ? s.lower[a] : high ? s.upper[a] - n * s.cell : from_middle;
  }
  return box;
}

namespace {

WindowBox gas_box(BodySetup const& s, GasGrid const& gas) {
  WindowBox box{.lower = gas.setup().lower,
                .h = gas.widths()[0],
                .grid = gas.cells(),
                .first = {},
                .size = {},
                .mirrors = walls_of(gas.setup())};
  for (std::size_t a = 0; a < 3; ++a) {
    int const from = static_cast<int>(std::floor((s.lower[a] - box.lower[a]) / box.h)) - margin;
    int const to = static_cast<int>(std::ceil((s.upper[a] - box.lower[a]) / box.h)) + margin;
    int const beyond = std::min(margin, box.grid[a]), first = box.mirrors.low[a] ? -beyond : 0;
    int const last = box.grid[a] + (box.mirrors.high[a] ? beyond : 0);
    box.first[a] = std::clamp(from, first, box.grid[a] - 1);
    box.size[a] = std::clamp(to, box.first[a] + 1, last) - box.first[a];
  }
  return box;
}

SolidGridSetup grid_setup(BodySetup const& s, Mirrors const& cut, SolidSchemeOptions const& options) {
  WindowBox const box = solid_window(s, cut);
  SolidGridSetup setup{.material = s.material,
                       .lower = box.lower,
                       .upper = {},
                       .cells = box.grid,
                       .sides = {},
                       .source = {},
                       .options = options};
  if (setup.options.tile[0] <= 0) setup.options.tile = body_tile;
  for (std::size_t a = 0; a < 3; ++a) {
    setup.upper[a] = box.lower[a] + box.grid[a] * box.h;
    auto const kind = [&](int side) {
      return cut.clamps.at(a, side) ? SolidBoundary::Kind::fixed : SolidBoundary::Kind::symmetry;
    };
    if (cut.low[a]) setup.sides[2 * a].kind = kind(-1);
    if (cut.high[a]) setup.sides[2 * a + 1].kind = kind(1);
  }
  return setup;
}

Mirrors planes_of(BodySetup const& s, GasGrid const& gas) {
  if (s.rigid && s.clamps.any()) throw SurfaceError("a rigid body is clamped", "give it a motion of its own instead");
  Mirrors planes = walls_of(gas.setup());
  planes.clamps = s.clamps;
  return planes;
}

}  // namespace

Body::Body(BodySetup s, GasGrid const& gas_grid, SolidSchemeOptions const& options, Literal const& readings)
    : surface(s.surface),
      cut(find_cut(surface, planes_of(s, gas_grid), 1e-3 * s.cell)),
      setup(bounded(std::move(s), cut.mirrors)),
      literal(readings),
      triangles(surface.size()),
      grid(grid_setup(setup, cut.mirrors, options)),
      solid(solid_window(setup, cut.mirrors), true, setup.material, literal),
      gas(gas_box(setup, gas_grid), false, gas_grid.setup().eos, literal) {
  connect(), place_triangles();
  for (TriangleState& t : triangles) t.at_start = t.frame.n;
  if (setup.rigid) {
    rigid.emplace(surface, cut, *setup.rigid);
    setup.initial = [motion = rigid->motion(), centre = rigid->state.centre,
                     rho = setup.rigid->density](Vec3 const& x) {
      return SolidPoint{.rho = rho, .u = motion.velocity + cross(motion.spin, x - centre)};
    };
  }
}

void Body::connect() {
  around.assign(surface.vertices.size(), {});
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (int v : surface.triangles[t]) around[static_cast<std::size_t>(v)].push_back(static_cast<int>(t));
  }
}

void Body::place_triangles() {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    TriangleState& s = triangles[t];
    auto const [a, b, c] = surface.corners(t);
    Vec3 const n = surface.area_vector(t), edge = b - a;
    s.centre = surface.centre(t), s.area = length(n);
    s.frame.n = (1 / s.area) * n, s.frame.a = (1 / length(edge)) * edge;
    s.frame.b = cross(s.frame.n, s.frame.a);
  }
}

void Body::move_vertices(double dt, double growth) {
  std::vector<Vec3> way(surface.vertices.size());
  for (std::size_t v = 0; v < way.size(); ++v) {
    double sum = 0;
    Vec3 total{0, 0, 0}, normal{0, 0, 0};
    for (int n : around[v]) {
      TriangleState const& t = triangles[static_cast<std::size_t>(n)];
      Vec3 const r = surface.vertices[v] - t.centre;
      double const w = t.area / dot(r, r);
      Vec3 u = t.velocity;
      if (!literal.level_motion) u = u + dot(r, t.frame.a) * t.gradient[0] + dot(r, t.frame.b) * t.gradient[1];
      total = total + w * u, sum += w, normal = normal + t.area * t.frame.n;
    }
    way[v] = literal.normal_motion ? dt * along_normals(*this, v) : (dt / sum) * total;
    for (std::size_t a = 0; a < 3; ++a) {
      if (cut.on_planes[v][a]) normal[a] = 0;  // as that of the whole body
    }
    if (double const size = length(normal); size > 0) way[v] = way[v] + (growth / size) * normal;
  }
  for (std::size_t v = 0; v < way.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (!cut.on_planes[v][a]) surface.vertices[v][a] += way[v][a];
    }
  }
}

std::array<Vec3, 2> Body::velocity_gradient(std::size_t triangle, ModelStencil const& s) const {
  Frame const& f = triangles[triangle].frame;
  auto const& layer = s.solid_smooth[0];
  double const inverse = 0.5 / setup.cell;
  return {inverse * f.out_of(velocity_of(layer[2][1]) - velocity_of(layer[0][1])),
          inverse * f.out_of(velocity_of(layer[1][2]) - velocity_of(layer[1][0]))};
}

std::vector<std::size_t> Body::neighbours_in_turn() const {
  constexpr int width = 3;  // of blocks of cells, which are gone through in rows
  std::vector<std::pair<std::array<int, 6>, std::size_t>> keyed(triangles.size());
  for (std::size_t n = 0; n < keyed.size(); ++n) {
    Int3 const c = rigid ? gas.kinds.cell_of(triangles[n].centre) : solid.kinds.cell_of(triangles[n].centre);
    keyed[n] = {{c[2] / width, c[1] / width, c[0] / width, c[2], c[1], c[0]}, n};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::size_t> order;
  order.reserve(keyed.size());
  for (auto const& one : keyed) order.push_back(one.second);
  return order;
}

}  // namespace g27
