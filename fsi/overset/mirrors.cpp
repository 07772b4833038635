#include "fsi/overset/mirrors.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fsi/surface/adjacency.hpp"

namespace g27 {

namespace {

template <class Fields>
void reflect_velocity(Fields& q, Image const& at) noexcept {
  for (std::size_t a = 0; a < 3; ++a) {
    if (at[a] != 0) q[1 + a] = -q[1 + a];
  }
}

/// What is left of an image where clamps do not mirror, and whether they turn the velocity.
struct Parted {
  Image mirrored;
  bool turned;
};

Parted parted(Image at, Clamps const& clamps) noexcept {
  bool turned = false;
  for (std::size_t a = 0; a < 3; ++a) {
    if (clamps.at(a, at[a])) at[a] = 0, turned = !turned;
  }
  return {at, turned};
}

}  // namespace

GasFields reflected(GasFields q, Image const& at) noexcept {
  reflect_velocity(q, at);
  return q;
}

SolidFields reflected(SolidFields q, Image const& at) noexcept {
  reflect_velocity(q, at);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      if ((at[i] != 0) != (at[j] != 0)) {
        double& shear = q[solid_field_of::S + tensor_place[i][j]];
        shear = -shear;
      }
    }
  }
  return q;
}

Vec3 reflected(Vec3 v, Image const& at, Clamps const& clamps) noexcept {
  auto const [mirrored, turned] = parted(at, clamps);
  return (turned ? -1.0 : 1.0) * reflected(v, mirrored);
}

SolidFields reflected(SolidFields q, Image const& at, Clamps const& clamps) noexcept {
  auto const [mirrored, turned] = parted(at, clamps);
  q = reflected(q, mirrored);
  for (std::size_t a = 0; turned && a < 3; ++a) q[solid_field_of::u + a] = -q[solid_field_of::u + a];
  return q;
}

Cut find_cut(TriangleSurface& surface, Mirrors const& planes, double tolerance) {
  Cut cut{.mirrors = {.lower = planes.lower, .upper = planes.upper, .clamps = planes.clamps}, .on_planes = {}};
  cut.on_planes.assign(surface.vertices.size(), {false, false, false});
  for_each_edge(sides_by_edge(surface), [&](std::span<TriangleSide const> edge) {
    if (edge.size() != 1) return;
    auto const ends = {static_cast<std::size_t>(edge[0].low), static_cast<std::size_t>(edge[0].high)};
    bool found = false;
    for (std::size_t a = 0; a < 3; ++a) {
      for (bool high : {false, true}) {
        double const plane = high ? planes.upper[a] : planes.lower[a];
        bool on = high ? planes.high[a] : planes.low[a];
        for (std::size_t v : ends) on = on && std::fabs(surface.vertices[v][a] - plane) <= tolerance;
        if (!on) continue;
        found = true, (high ? cut.mirrors.high : cut.mirrors.low)[a] = true;
        bool const clamp = planes.clamps.at(a, high ? 1 : -1);
        for (std::size_t v : ends) {
          surface.vertices[v][a] = plane, cut.on_planes[v][a] = true;
          if (clamp) cut.on_planes[v] = {true, true, true};
        }
      }
    }
    if (found) return;
    Vec3 const& x = surface.at(edge[0].low);
    throw SurfaceError(fmt::format("the surface of a body is open at ({:g}, {:g}, {:g}) m", x[0], x[1], x[2]),
                       "close it, or clip it at the sides of the domain, which there must be walls");
  });
  if (cut.mirrors.low[0] && cut.mirrors.high[0]) {
    throw SurfaceError("both sides of the domain across x cut a body", "turn the scene so that they are across y or z");
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (int side : {-1, 1}) {
      if (!planes.clamps.at(a, side) || (side < 0 ? cut.mirrors.low : cut.mirrors.high)[a]) continue;
      throw SurfaceError(fmt::format("a body is clamped at the {} side of the domain across {}, which does not cut it",
                                     side < 0 ? "lower" : "upper", "xyz"[a]),
                         "let the body reach across that side, which must be a wall, or do not clamp it there");
    }
  }
  return cut;
}

}  // namespace g27
