#include "fsi/overset/body.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

namespace {

constexpr int margin = 4;  ///< cells of a window beyond the box that the body stays in

}  // namespace

WindowBox solid_window(BodySetup const& s) {
  WindowBox box{.lower = {}, .h = s.cell, .grid = {}, .first = {0, 0, 0}, .size = {}};
  for (std::size_t a = 0; a < 3; ++a) {
    int const n = static_cast<int>(std::ceil((s.upper[a] - s.lower[a]) / s.cell - 1e-9)) + 2 * margin;
    box.grid[a] = box.size[a] = n;
    box.lower[a] = 0.5 * (s.lower[a] + s.upper[a]) - 0.5 * n * s.cell;
  }
  return box;
}

namespace {

WindowBox gas_box(BodySetup const& s, GasGrid const& gas) {
  WindowBox box{.lower = gas.setup().lower, .h = gas.widths()[0], .grid = gas.cells(), .first = {}, .size = {}};
  for (std::size_t a = 0; a < 3; ++a) {
    int const from = static_cast<int>(std::floor((s.lower[a] - box.lower[a]) / box.h)) - margin;
    int const to = static_cast<int>(std::ceil((s.upper[a] - box.lower[a]) / box.h)) + margin;
    box.first[a] = std::clamp(from, 0, box.grid[a] - 1);
    box.size[a] = std::clamp(to, box.first[a] + 1, box.grid[a]) - box.first[a];
  }
  return box;
}

SolidGridSetup grid_setup(BodySetup const& s, SolidSchemeOptions const& options) {
  WindowBox const box = solid_window(s);
  SolidGridSetup setup{.material = s.material,
                       .lower = box.lower,
                       .upper = {},
                       .cells = box.grid,
                       .sides = {},
                       .source = {},
                       .options = options};
  for (std::size_t a = 0; a < 3; ++a) setup.upper[a] = box.lower[a] + box.grid[a] * box.h;
  return setup;
}

}  // namespace

Body::Body(BodySetup s, GasGrid const& gas_grid, SolidSchemeOptions const& options)
    : setup(std::move(s)),
      surface(setup.surface),
      around(surface.vertices.size()),
      triangles(surface.size()),
      grid(grid_setup(setup, options)),
      solid(solid_window(setup), true),
      gas(gas_box(setup, gas_grid), false) {
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (int v : surface.triangles[t]) around[static_cast<std::size_t>(v)].push_back(static_cast<int>(t));
  }
  place_triangles();
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

void Body::move_vertices(double dt) {
  std::vector<Vec3> velocity(surface.vertices.size());
  for (std::size_t v = 0; v < velocity.size(); ++v) {
    double sum = 0;
    Vec3 total{0, 0, 0};
    for (int n : around[v]) {
      TriangleState const& t = triangles[static_cast<std::size_t>(n)];
      Vec3 const r = surface.vertices[v] - t.centre;
      double const w = t.area / dot(r, r);
      Vec3 const u = t.velocity + dot(r, t.frame.a) * t.gradient[0] + dot(r, t.frame.b) * t.gradient[1];
      total = total + w * u, sum += w;
    }
    velocity[v] = (1 / sum) * total;
  }
  for (std::size_t v = 0; v < velocity.size(); ++v) surface.vertices[v] = surface.vertices[v] + dt * velocity[v];
}

std::array<Vec3, 2> Body::velocity_gradient(std::size_t triangle, ModelStencil const& s) const {
  Frame const& f = triangles[triangle].frame;
  auto const& layer = s.solid_smooth[0];
  double const inverse = 0.5 / setup.cell;
  return {inverse * f.out_of(velocity_of(layer[2][1]) - velocity_of(layer[0][1])),
          inverse * f.out_of(velocity_of(layer[1][2]) - velocity_of(layer[1][0]))};
}

}  // namespace g27
