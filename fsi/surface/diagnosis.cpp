#include "fsi/surface/diagnosis.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include "fsi/surface/adjacency.hpp"
#include "fsi/surface/polygon_mesh.hpp"

namespace g27 {
namespace {

constexpr double least_volume = 1e-6;  ///< of a shell, over its area^(3/2): 0.068 of a cube, 1e-6 of a leaf 1 : 350000

struct FaultText {
  char const *name, *remedy;
};

FaultText text_of(Fault fault) {
  switch (fault) {
    case Fault::degenerate:
      return {"degenerate triangles", "--repair removes them"};
    case Fault::duplicate:
      return {"duplicate triangles", "--repair removes them"};
    case Fault::open_edge:
      return {"open edges", "--repair closes gaps and small holes; close large ones where the surface was made"};
    case Fault::non_manifold_edge:
      return {"non-manifold edges", "separate or unite the parts that meet there"};
    case Fault::non_manifold_vertex:
      return {"non-manifold vertices", "separate or unite the parts that meet there"};
    case Fault::inconsistent_orientation:
      return {"edges of inconsistent orientation", "--repair orients the triangles"};
    case Fault::inward:
      return {"inward shells", "--repair turns them"};
    case Fault::no_volume:
      return {"shells without volume", "give the part a thickness or remove it"};
    case Fault::self_intersection:
      return {"self-intersections", "unite or move apart the parts that intersect"};
  }
  return {"", ""};
}

/// Collects the findings of one kind.
class Collector {
 public:
  void add(std::initializer_list<int> triangles) {
    ++count_;
    triangles_.insert(triangles_.end(), triangles);
  }
  void involve(int triangle) { triangles_.push_back(triangle); }
  void report(Fault fault, Diagnosis& diagnosis) {
    if (count_ == 0) return;
    std::sort(triangles_.begin(), triangles_.end());
    triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
    diagnosis.findings.push_back({fault, count_, triangles_});
  }

 private:
  std::size_t count_ = 0;
  std::vector<int> triangles_;
};

void find_degenerate(TriangleSurface const& surface, Diagnosis& out) {
  Collector degenerate, duplicate;
  std::map<Triangle, int> seen;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    int const id = static_cast<int>(t);
    if (!(relative_height(surface, t) >= degenerate_height)) degenerate.add({id});
    Triangle key = surface.triangles[t];
    std::sort(key.begin(), key.end());
    if (auto const [at, fresh] = seen.emplace(key, id); !fresh) duplicate.add({at->second, id});
  }
  degenerate.report(Fault::degenerate, out);
  duplicate.report(Fault::duplicate, out);
}

void find_bad_edges(std::vector<TriangleSide> const& sides, Diagnosis& out) {
  Collector open, non_manifold, inconsistent;
  for_each_edge(sides, [&](std::span<TriangleSide const> edge) {
    if (edge[0].low == edge[0].high) return;  // of a degenerate triangle
    if (edge.size() == 1) open.add({edge[0].triangle});
    if (edge.size() > 2) {
      non_manifold.add({});
      for (TriangleSide const& s : edge) non_manifold.involve(s.triangle);
    }
    if (edge.size() == 2 && edge[0].rising == edge[1].rising) inconsistent.add({edge[0].triangle, edge[1].triangle});
  });
  open.report(Fault::open_edge, out);
  non_manifold.report(Fault::non_manifold_edge, out);
  inconsistent.report(Fault::inconsistent_orientation, out);
}

/// Corners of triangles are joined where they share a vertex and an edge: each vertex should keep one fan of them.
void find_bad_vertices(TriangleSurface const& surface, std::vector<TriangleSide> const& sides, Diagnosis& out) {
  std::vector<std::size_t> parent(3 * surface.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto corner = [&](TriangleSide const& s, int vertex) {
    auto const t = static_cast<std::size_t>(s.triangle), e = static_cast<std::size_t>(s.side);
    return 3 * t + (surface.triangles[t][e] == vertex ? e : (e + 1) % 3);
  };
  for_each_edge(sides, [&](std::span<TriangleSide const> edge) {
    for (TriangleSide const& s : edge) {
      for (int const v : {s.low, s.high}) parent[root(corner(s, v))] = root(corner(edge[0], v));
    }
  });
  std::vector<int> fans(surface.vertices.size(), 0);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    if (root(i) == i) ++fans[static_cast<std::size_t>(surface.triangles[i / 3][i % 3])];
  }
  std::map<int, std::vector<int>> bad;
  for (std::size_t i = 0; i < parent.size(); ++i) {
    int const v = surface.triangles[i / 3][i % 3];
    if (fans[static_cast<std::size_t>(v)] > 1) bad[v].push_back(static_cast<int>(i / 3));
  }
  Collector non_manifold;
  for (auto const& [vertex, triangles] : bad) {
    non_manifold.add({});
    for (int const t : triangles) non_manifold.involve(t);
  }
  non_manifold.report(Fault::non_manifold_vertex, out);
}

void find_flat_shells(TriangleSurface const& surface, Adjacency const& adjacent, Diagnosis& out) {
  Vec3 const origin = out.box.lower;
  std::vector<double> volume(static_cast<std::size_t>(adjacent.shells), 0.0), area = volume;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    auto const shell = static_cast<std::size_t>(adjacent.shell[t]);
    volume[shell] += dot(surface.centre(t) - origin, surface.area_vector(t)) / 3;
    area[shell] += surface.area(t);
  }
  Collector flat;
  for (std::size_t s = 0; s < volume.size(); ++s) {
    if (std::fabs(volume[s]) >= least_volume * std::pow(area[s], 1.5)) continue;
    flat.add({});
    for (std::size_t t = 0; t < surface.size(); ++t) {
      if (adjacent.shell[t] == static_cast<int>(s)) flat.involve(static_cast<int>(t));
    }
  }
  flat.report(Fault::no_volume, out);
}

void find_intersections(TriangleSurface const& surface, Diagnosis& out) {
  Collector pairs;
  for (auto const& [a, b] : self_intersections(surface)) pairs.add({a, b});
  pairs.report(Fault::self_intersection, out);
}

void find_inward_shells(TriangleSurface const& surface, Adjacency const& adjacent, Diagnosis& out) {
  std::vector<bool> const inward = inward_triangles(surface);
  std::vector<bool> shell_known(static_cast<std::size_t>(adjacent.shells), false);
  Collector shells;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    if (!inward[t]) continue;
    auto const shell = static_cast<std::size_t>(adjacent.shell[t]);
    if (!shell_known[shell]) shells.add({});
    shell_known[shell] = true;
    shells.involve(static_cast<int>(t));
  }
  shells.report(Fault::inward, out);
}

void measure_edges(TriangleSurface const& surface, std::vector<TriangleSide> const& sides, Diagnosis& out) {
  out.edges.smallest = HUGE_VAL;
  out.angles = {.smallest = 2 * std::numbers::pi, .largest = 0};
  double sum = 0;
  std::size_t count = 0;
  for_each_edge(sides, [&](std::span<TriangleSide const> edge) {
    Vec3 const along = surface.at(edge[0].high) - surface.at(edge[0].low);
    double const size = length(along);
    sum += size;
    ++count;
    out.edges.largest = std::max(out.edges.largest, size);
    if (size < out.edges.smallest) {
      out.edges.smallest = size;
      out.edges.at_smallest = edge[0].triangle;
    }
    if (edge.size() != 2 || edge[0].rising == edge[1].rising) return;
    Vec3 const n = surface.normal(static_cast<std::size_t>(edge[0].triangle)),
               m = surface.normal(static_cast<std::size_t>(edge[1].triangle));
    double const bend = std::atan2(dot(cross(n, m), (edge[0].rising ? 1 : -1) / size * along), dot(n, m));
    double const angle = std::numbers::pi - bend;
    if (angle < out.angles.smallest) {
      out.angles.smallest = angle;
      out.angles.at_smallest = {edge[0].triangle, edge[1].triangle};
    }
    if (angle > out.angles.largest) {
      out.angles.largest = angle;
      out.angles.at_largest = {edge[0].triangle, edge[1].triangle};
    }
  });
  out.edges.mean = sum / static_cast<double>(count);
  if (out.angles.largest == 0) out.angles = {.smallest = std::numbers::pi, .largest = std::numbers::pi};
}

}  // namespace

std::string fault_name(Fault fault) { return text_of(fault).name; }
std::string fault_remedy(Fault fault) { return text_of(fault).remedy; }

double relative_height(TriangleSurface const& surface, std::size_t triangle) {
  auto const [a, b, c] = surface.corners(triangle);
  double const longest = std::max({length(b - a), length(c - b), length(a - c)});
  return longest > 0 ? 2 * surface.area(triangle) / (longest * longest) : 0;
}

std::vector<double> edge_lengths(TriangleSurface const& surface) {
  std::vector<double> out;
  for_each_edge(sides_by_edge(surface), [&](std::span<TriangleSide const> edge) {
    out.push_back(length(surface.at(edge[0].high) - surface.at(edge[0].low)));
  });
  return out;
}

Diagnosis diagnose(TriangleSurface const& surface) {
  Diagnosis out;
  auto const sides = sides_by_edge(surface);
  Adjacency const adjacent = adjacency(surface);
  out.shells = adjacent.shells;
  out.box = bounding_box(surface);
  measure_edges(surface, sides, out);
  find_degenerate(surface, out);
  find_bad_edges(sides, out);
  find_bad_vertices(surface, sides, out);
  bool const closed = out.healthy();
  if (closed) find_flat_shells(surface, adjacent, out);
  find_intersections(surface, out);
  if (out.healthy()) find_inward_shells(surface, adjacent, out);
  return out;
}

}  // namespace g27
