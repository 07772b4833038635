#include "fsi/surface/clip.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace g27 {

namespace {

/// Vertices that something refers to, in their order.
void drop_unused(TriangleSurface& s) {
  std::vector<int> number(s.vertices.size(), -1);
  for (Triangle const& t : s.triangles) {
    for (int v : t) number[static_cast<std::size_t>(v)] = 0;
  }
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) number[v] = static_cast<int>(kept.size()), kept.push_back(s.vertices[v]);
  }
  for (Triangle& t : s.triangles) {
    for (int& v : t) v = number[static_cast<std::size_t>(v)];
  }
  s.vertices = std::move(kept);
}

}  // namespace

TriangleSurface clip_surface(TriangleSurface s, std::size_t axis, double at, bool above, double snap) {
  for (Vec3& x : s.vertices) {
    if (std::fabs(x[axis] - at) < snap) x[axis] = at;
  }
  // distance on the side that is kept
  auto const depth = [&](int v) { return above ? s.at(v)[axis] - at : at - s.at(v)[axis]; };
  std::map<std::pair<int, int>, int> cuts;
  auto const cut = [&](int a, int b) {
    auto const [found, fresh] = cuts.emplace(std::minmax(a, b), static_cast<int>(s.vertices.size()));
    if (fresh) {
      auto const [low, high] = found->first;
      double const part = depth(low) / (depth(low) - depth(high));
      Vec3 x = s.at(low) + part * (s.at(high) - s.at(low));
      x[axis] = at;
      s.vertices.push_back(x);
    }
    return found->second;
  };
  std::vector<Triangle> kept;
  for (Triangle const t : s.triangles) {
    // the part of the triangle as a polygon
    std::vector<int> polygon;
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      int const v = t[c], next = t[(c + 1) % 3];
      double const here = depth(v), there = depth(next);
      most = std::max(most, here);
      if (here >= 0) polygon.push_back(v);
      if ((here > 0 && there < 0) || (here < 0 && there > 0)) polygon.push_back(cut(v, next));
    }
    if (!(most > 0)) continue;  // beyond the plane, or on it
    if (polygon.size() == 4 &&
        length(s.at(polygon[0]) - s.at(polygon[2])) > length(s.at(polygon[1]) - s.at(polygon[3])))
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    for (std::size_t c = 2; c < polygon.size(); ++c) kept.push_back({polygon[0], polygon[c - 1], polygon[c]});
  }
  if (kept.empty()) throw SurfaceError("no part of the surface is left", "clip it at a plane that cuts it");
  s.triangles = std::move(kept);
  drop_unused(s);
  return s;
}

TriangleSurface unfolded(TriangleSurface s, std::size_t axis, double at) {
  std::size_t const triangles = s.size(), vertices = s.vertices.size();
  std::vector<int> image(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    Vec3 x = s.vertices[v];
    image[v] = static_cast<int>(x[axis] == at ? v : s.vertices.size());
    if (x[axis] == at) continue;
    x[axis] = 2 * at - x[axis];
    s.vertices.push_back(x);
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    auto const [a, b, c] = s.triangles[t];
    // turned, and so that the first side stays the first one
    s.triangles.push_back(
        {image[static_cast<std::size_t>(b)], image[static_cast<std::size_t>(a)], image[static_cast<std::size_t>(c)]});
  }
  return s;
}

}  // namespace g27
