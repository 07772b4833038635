#include "fsi/surface/adjacency.hpp"

#include <algorithm>
#include <tuple>

namespace g27 {

std::vector<TriangleSide> sides_by_edge(TriangleSurface const& surface) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * surface.size());
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      int const from = surface.triangles[t][e], to = surface.triangles[t][(e + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), static_cast<int>(e), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](TriangleSide const& a, TriangleSide const& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
  return sides;
}

Adjacency adjacency(TriangleSurface const& surface) {
  Adjacency out;
  out.beside.assign(surface.size(), {Adjacency::open, Adjacency::open, Adjacency::open});
  auto beside = [&](TriangleSide const& s) -> int& {
    return out.beside[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>(s.side)];
  };
  for_each_edge(sides_by_edge(surface), [&](std::span<TriangleSide const> edge) {
    if (edge.size() == 2) {
      beside(edge[0]) = edge[1].triangle;
      beside(edge[1]) = edge[0].triangle;
    } else if (edge.size() > 2) {
      for (TriangleSide const& s : edge) beside(s) = Adjacency::non_manifold;
    }
  });

  out.first.assign(surface.vertices.size() + 1, 0);
  for (Triangle const& t : surface.triangles) {
    for (int const v : t) ++out.first[static_cast<std::size_t>(v) + 1];
  }
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) out.first[v + 1] += out.first[v];
  out.stars.resize(3 * surface.size());
  auto next = out.first;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (int const v : surface.triangles[t]) {
      out.stars[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<int>(t);
    }
  }

  out.shell.assign(surface.size(), -1);
  std::vector<std::size_t> waiting;
  for (std::size_t seed = 0; seed < surface.size(); ++seed) {
    if (out.shell[seed] >= 0) continue;
    out.shell[seed] = out.shells++;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      std::size_t const t = waiting.back();
      waiting.pop_back();
      for (int const n : out.beside[t]) {
        if (n < 0 || out.shell[static_cast<std::size_t>(n)] >= 0) continue;
        out.shell[static_cast<std::size_t>(n)] = out.shell[t];
        waiting.push_back(static_cast<std::size_t>(n));
      }
    }
  }
  return out;
}

}  // namespace g27
