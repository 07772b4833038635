#include "fsi/surface/repair.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "fsi/surface/adjacency.hpp"
#include "fsi/surface/polygon_mesh.hpp"

namespace g27 {
namespace {

constexpr double weld_distance = 1e-5;  ///< of the diagonal of the box
constexpr std::size_t largest_hole = 8;
constexpr double largest_hole_area = 0.02;  ///< of the surface's

class Repairer {
 public:
  explicit Repairer(TriangleSurface const& surface)
      : work_{.surface = surface, .origin = {}, .steps = {}, .diagnosis = {}} {
    work_.origin.resize(surface.size());
    std::iota(work_.origin.begin(), work_.origin.end(), 0);
  }

  Repair run() {
    remove_collapsed("removed triangles without three vertices");
    remove_duplicates();
    weld_open_edges();
    if (manifold() && orient()) {
      close_holes();
      remove_degenerate();
      if (work_.surface.size() > 0) turn_outward();
    }
    remove_unused_vertices();
    if (work_.surface.size() > 0) work_.diagnosis = diagnose(work_.surface);
    return std::move(work_);
  }

 private:
  TriangleSurface& surface() { return work_.surface; }

  /// Notes a step that changed triangles, by their present numbers.
  void note(std::string const& what, std::size_t count, std::vector<std::size_t> const& triangles) {
    if (count == 0) return;
    std::vector<int> ids;
    for (std::size_t const t : triangles) {
      if (work_.origin[t] >= 0) ids.push_back(work_.origin[t]);
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    work_.steps.push_back({what, count, ids});
  }

  void remove(std::vector<std::size_t> const& ascending) {
    std::size_t kept = 0, next = 0;
    for (std::size_t t = 0; t < surface().size(); ++t) {
      if (next < ascending.size() && ascending[next] == t) {
        ++next;
        continue;
      }
      surface().triangles[kept] = surface().triangles[t];
      work_.origin[kept++] = work_.origin[t];
    }
    surface().triangles.resize(kept);
    work_.origin.resize(kept);
  }

  void remove_collapsed(std::string const& what) {
    std::vector<std::size_t> collapsed;
    for (std::size_t t = 0; t < surface().size(); ++t) {
      auto const& [a, b, c] = surface().triangles[t];
      if (a == b || b == c || c == a) collapsed.push_back(t);
    }
    note(what, collapsed.size(), collapsed);
    remove(collapsed);
  }

  void remove_duplicates() {
    std::set<Triangle> seen;
    std::vector<std::size_t> duplicates;
    for (std::size_t t = 0; t < surface().size(); ++t) {
      Triangle key = surface().triangles[t];
      std::sort(key.begin(), key.end());
      if (!seen.insert(key).second) duplicates.push_back(t);
    }
    note("removed duplicate triangles", duplicates.size(), duplicates);
    remove(duplicates);
  }

  void weld_open_edges() {
    std::set<int> open;
    for_each_edge(sides_by_edge(surface()), [&](std::span<TriangleSide const> edge) {
      if (edge.size() == 1) open.insert({edge[0].low, edge[0].high});
    });
    if (open.empty()) return;
    double const near = weld_distance * bounding_box(surface()).diagonal();
    std::vector<int> by_x(open.begin(), open.end());
    std::sort(by_x.begin(), by_x.end(), [&](int a, int b) { return surface().at(a)[0] < surface().at(b)[0]; });
    std::vector<int> merged(surface().vertices.size());
    std::iota(merged.begin(), merged.end(), 0);
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      Vec3 const& x = surface().at(by_x[i]);
      for (std::size_t j = i + 1; j < by_x.size() && surface().at(by_x[j])[0] - x[0] <= near; ++j) {
        int& other = merged[static_cast<std::size_t>(by_x[j])];
        if (other == by_x[j] && length(surface().at(by_x[j]) - x) <= near) {
          other = merged[static_cast<std::size_t>(by_x[i])];
        }
      }
    }
    std::size_t count = 0;
    for (std::size_t v = 0; v < merged.size(); ++v) count += merged[v] != static_cast<int>(v);
    std::vector<std::size_t> changed;
    for (std::size_t t = 0; t < surface().size(); ++t) {
      Triangle const before = surface().triangles[t];
      for (int& v : surface().triangles[t]) v = merged[static_cast<std::size_t>(v)];
      if (surface().triangles[t] != before) changed.push_back(t);
    }
    note("welded vertices closer than 1e-5 of the size", count, changed);
    remove_collapsed("removed triangles that the welding left without area");
    remove_duplicates();
  }

  bool manifold() {
    bool fine = surface().size() > 0;
    for_each_edge(sides_by_edge(surface()),
                  [&](std::span<TriangleSide const> edge) { fine = fine && edge.size() <= 2; });
    return fine;
  }

  /// Floods each shell from its first triangle, then turns the smaller part. False if a shell has one side only.
  bool orient() {
    Adjacency const adjacent = adjacency(surface());
    std::vector<int> sense(surface().size(), 0);  // 1: as it is, -1: to be turned
    std::vector<std::size_t> waiting;
    for (std::size_t seed = 0; seed < surface().size(); ++seed) {
      if (sense[seed] != 0) continue;
      sense[seed] = 1;
      std::vector<std::size_t> shell{seed};
      long turned = 0;
      for (std::size_t at = 0; at < shell.size(); ++at) {
        std::size_t const t = shell[at];
        turned += sense[t] < 0;
        for (std::size_t e = 0; e < 3; ++e) {
          if (adjacent.beside[t][e] < 0) continue;
          auto const n = static_cast<std::size_t>(adjacent.beside[t][e]);
          int const wanted = same_direction(t, e, n) ? -sense[t] : sense[t];
          if (sense[n] != 0 && sense[n] != wanted) return false;
          if (sense[n] == 0) shell.push_back(n);
          sense[n] = wanted;
        }
      }
      if (2 * turned > static_cast<long>(shell.size())) {
        for (std::size_t const t : shell) sense[t] = -sense[t];
      }
    }
    std::vector<std::size_t> turned;
    for (std::size_t t = 0; t < surface().size(); ++t) {
      if (sense[t] < 0) turned.push_back(t);
    }
    turn(turned, "turned triangles against their neighbours");
    return true;
  }

  /// Whether triangle n leads along side e of t in the direction of t.
  [[nodiscard]] bool same_direction(std::size_t t, std::size_t e, std::size_t n) const {
    auto const& a = work_.surface.triangles[t];
    auto const& b = work_.surface.triangles[n];
    for (std::size_t f = 0; f < 3; ++f) {
      if (b[f] == a[e] && b[(f + 1) % 3] == a[(e + 1) % 3]) return true;
    }
    return false;
  }

  void turn(std::vector<std::size_t> const& triangles, std::string const& what) {
    for (std::size_t const t : triangles) std::swap(surface().triangles[t][1], surface().triangles[t][2]);
    note(what, triangles.size(), triangles);
  }

  void close_holes() {
    std::vector<int> next(surface().vertices.size(), -1);  // along the hole's border, against the triangles
    std::set<int> crossing;
    for_each_edge(sides_by_edge(surface()), [&](std::span<TriangleSide const> edge) {
      if (edge.size() != 1) return;
      int const from = edge[0].rising ? edge[0].high : edge[0].low, to = edge[0].rising ? edge[0].low : edge[0].high;
      if (next[static_cast<std::size_t>(from)] >= 0) crossing.insert(from);
      next[static_cast<std::size_t>(from)] = to;
    });
    double const area = mass_properties(surface()).area;
    std::size_t holes = 0, added = 0;
    for (std::size_t start = 0; start < next.size(); ++start) {
      if (next[start] < 0) continue;
      std::vector<int> border;
      bool simple = true;
      for (int v = static_cast<int>(start); next[static_cast<std::size_t>(v)] >= 0;) {
        border.push_back(v);
        simple = simple && !crossing.contains(v);
        v = std::exchange(next[static_cast<std::size_t>(v)], -1);
      }
      if (!simple || border.size() < 3 || border.size() > largest_hole) continue;
      auto const patch = patch_of(border);
      TriangleSurface const lid{surface().vertices, patch};
      if (patch.empty() || (border.size() > 3 && mass_properties(lid).area > largest_hole_area * area)) continue;
      surface().triangles.insert(surface().triangles.end(), patch.begin(), patch.end());
      work_.origin.resize(surface().size(), -1);
      ++holes;
      added += patch.size();
    }
    note("closed holes with " + std::to_string(added) + " new triangles", holes, {});
  }

  std::vector<Triangle> patch_of(std::vector<int> const& border) {
    std::vector<Vec3> points;
    for (int const v : border) points.push_back(surface().at(v));
    auto patch = triangulate_polygon(points);
    for (Triangle& t : patch) {
      for (int& v : t) v = border[static_cast<std::size_t>(v)];
    }
    return patch;
  }

  /// A needle loses its short edge. The longest edge of a cap is flipped to the corner that lies on it. Triangles that
  /// one change touches wait for the next pass.
  void remove_degenerate() {
    std::size_t count = 0;
    std::vector<std::size_t> involved;
    for (int pass = 0; pass < 20; ++pass) {
      Adjacency const adjacent = adjacency(surface());
      std::vector<bool> touched(surface().size(), false);
      std::size_t changes = 0;
      std::vector<std::size_t> now;
      for (std::size_t t = 0; t < surface().size(); ++t) {
        if (relative_height(surface(), t) >= degenerate_height || touched[t]) continue;
        if (collapse(t, adjacent, touched) || flip(t, adjacent, touched)) {
          ++changes;
          now.push_back(t);
        }
      }
      count += changes;
      std::vector<int> ids;
      for (std::size_t const t : now) removed_.push_back(work_.origin[t]);
      std::vector<std::size_t> collapsed;
      for (std::size_t t = 0; t < surface().size(); ++t) {
        auto const& [a, b, c] = surface().triangles[t];
        if (a == b || b == c || c == a) collapsed.push_back(t);
      }
      remove(collapsed);
      if (changes == 0) break;
    }
    if (count > 0) {
      std::sort(removed_.begin(), removed_.end());
      removed_.erase(std::unique(removed_.begin(), removed_.end()), removed_.end());
      std::erase(removed_, -1);
      work_.steps.push_back({"removed degenerate triangles", count, removed_});
    }
  }

  [[nodiscard]] double side_length(std::size_t t, std::size_t e) const {
    auto const& triangle = work_.surface.triangles[t];
    return length(work_.surface.at(triangle[(e + 1) % 3]) - work_.surface.at(triangle[e]));
  }

  bool collapse(std::size_t t, Adjacency const& adjacent, std::vector<bool>& touched) {
    std::array<double, 3> const l{side_length(t, 0), side_length(t, 1), side_length(t, 2)};
    auto const e = static_cast<std::size_t>(std::min_element(l.begin(), l.end()) - l.begin());
    if (l[e] > 2 * degenerate_height * *std::max_element(l.begin(), l.end())) return false;
    int const kept = surface().triangles[t][e], lost = surface().triangles[t][(e + 1) % 3];
    for (int const v : {kept, lost}) {
      for (int const n : adjacent.around(v)) {
        if (touched[static_cast<std::size_t>(n)]) return false;
      }
    }
    for (int const v : {kept, lost}) {
      for (int const n : adjacent.around(v)) touched[static_cast<std::size_t>(n)] = true;
    }
    for (int const n : adjacent.around(lost)) {
      for (int& v : surface().triangles[static_cast<std::size_t>(n)]) {
        if (v == lost) v = kept;
      }
    }
    return true;
  }

  bool flip(std::size_t t, Adjacency const& adjacent, std::vector<bool>& touched) {
    std::array<double, 3> const l{side_length(t, 0), side_length(t, 1), side_length(t, 2)};
    auto const e = static_cast<std::size_t>(std::max_element(l.begin(), l.end()) - l.begin());
    if (adjacent.beside[t][e] < 0) return false;
    auto const n = static_cast<std::size_t>(adjacent.beside[t][e]);
    if (touched[n]) return false;
    Triangle& cap = surface().triangles[t];
    Triangle& other = surface().triangles[n];
    int const a = cap[e], b = cap[(e + 1) % 3], c = cap[(e + 2) % 3];
    int const d = other[0] != a && other[0] != b ? other[0] : other[1] != a && other[1] != b ? other[1] : other[2];
    for (int const at : adjacent.around(c)) {  // the new edge must be new
      Triangle const& near = surface().triangles[static_cast<std::size_t>(at)];
      if (std::find(near.begin(), near.end(), d) != near.end()) return false;
    }
    touched[t] = touched[n] = true;
    cap = {a, d, c};
    other = {d, b, c};
    return true;
  }

  void turn_outward() {
    Diagnosis const now = diagnose(surface());
    SurfaceFinding const* inward = now.find(Fault::inward);
    if (inward == nullptr) return;
    turn({inward->triangles.begin(), inward->triangles.end()}, "turned triangles of inward shells");
  }

  void remove_unused_vertices() {
    std::vector<int> number(surface().vertices.size(), -1);
    std::vector<Vec3> used;
    for (Triangle& t : surface().triangles) {
      for (int& v : t) {
        int& n = number[static_cast<std::size_t>(v)];
        if (n < 0) {
          n = static_cast<int>(used.size());
          used.push_back(surface().at(v));
        }
        v = n;
      }
    }
    surface().vertices = std::move(used);
  }

  Repair work_;
  std::vector<int> removed_;
};

}  // namespace

Repair repair(TriangleSurface const& surface) { return Repairer(surface).run(); }

}  // namespace g27
