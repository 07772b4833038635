#include "fsi/overset/untangle.hpp"

#include <algorithm>

#include "fsi/surface/polygon_mesh.hpp"

namespace g27 {

namespace {

constexpr int passes = 20;
constexpr double step = 0.5;  ///< of the way to the middle of the neighbours

using Marks = std::vector<char>;

/// Vertices that have run beyond a plane.
Marks beyond_planes(TriangleSurface const& s, Cut const& cut) {
  Marks out(s.vertices.size(), 0);
  for (std::size_t v = 0; v < out.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cut.on_planes[v][a]) continue;
      double const x = s.vertices[v][a];
      if (cut.mirrors.low[a] && x <= cut.mirrors.lower[a]) out[v] = 1;
      if (cut.mirrors.high[a] && x >= cut.mirrors.upper[a]) out[v] = 1;
    }
  }
  return out;
}

/// Vertices of triangles that meet others, or that have a corner beyond a plane.
Marks tangled(TriangleSurface const& s, Cut const& cut) {
  Marks out = beyond_planes(s, cut);
  for (auto const& pair : self_intersections(s)) {
    for (int t : pair) {
      for (int v : s.triangles[static_cast<std::size_t>(t)]) out[static_cast<std::size_t>(v)] = 1;
    }
  }
  return out;
}

/// Those marked and their neighbours.
Marks with_neighbours(TriangleSurface const& s, Marks const& marks) {
  Marks out = marks;
  for (Triangle const& t : s.triangles) {
    bool const any = std::any_of(t.begin(), t.end(), [&](int v) { return marks[static_cast<std::size_t>(v)] != 0; });
    for (int v : t) out[static_cast<std::size_t>(v)] |= static_cast<char>(any);
  }
  return out;
}

/// Half of the way from each marked vertex to the middle of its neighbours. At a plane only neighbours on it count,
/// and in a corner of planes none.
void smooth(TriangleSurface& s, Cut const& cut, Marks const& marks) {
  std::vector<Vec3> sum(s.vertices.size(), {0, 0, 0});
  std::vector<double> count(s.vertices.size(), 0);
  auto const add = [&](std::size_t v, std::size_t from) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cut.on_planes[v][a] && !cut.on_planes[from][a]) return;
    }
    sum[v] = sum[v] + s.vertices[from], count[v] += 1;
  };
  for (Triangle const& t : s.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::size_t const v = static_cast<std::size_t>(t[c]), w = static_cast<std::size_t>(t[(c + 1) % 3]);
      add(v, w), add(w, v);
    }
  }
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    if (marks[v] == 0 || count[v] == 0) continue;
    Vec3 const way = step * ((1 / count[v]) * sum[v] - s.vertices[v]);
    for (std::size_t a = 0; a < 3; ++a) {
      if (!cut.on_planes[v][a]) s.vertices[v][a] += way[a];
    }
  }
}

bool any(Marks const& m) {
  return std::any_of(m.begin(), m.end(), [](char c) { return c != 0; });
}

}  // namespace

Untangled untangle(TriangleSurface& surface, Cut const& cut) {
  Untangled out;
  for (int n = 0; n < passes; ++n) {
    Marks const at_fault = tangled(surface, cut);
    if (!any(at_fault)) return out;
    Marks const marks = with_neighbours(surface, at_fault);
    smooth(surface, cut, marks);
    out.moved += static_cast<std::uint64_t>(std::count(marks.begin(), marks.end(), 1));
  }
  out.clear = !any(tangled(surface, cut));
  return out;
}

}  // namespace g27
