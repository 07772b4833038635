#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "fsi/surface/adjacency.hpp"
#include "fsi/surface/cgal_mesh.hpp"
#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/local_remesh.hpp"
#include "fsi/surface/polygon_mesh.hpp"

namespace g27 {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Half = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;

constexpr int rounds = 3;               ///< of parting and joining
constexpr double most_turn = 40;        ///< of a normal by one change [degrees]
constexpr double straight = 50;         ///< turn of a sharp line up to which a vertex on it is no corner [degrees]
constexpr double wanted_height = 0.35;  ///< of triangles over their longest edge, where one is mended
constexpr double step = 0.5;            ///< of a vertex towards the middle of its neighbours

double const cos_turn = std::cos(most_turn * std::numbers::pi / 180);

/// What a vertex may do: move along a side, along a sharp line, along a plane that the surface ends on, not at all.
enum class Place { side, line, border, corner };

using Corners = std::array<Vec3, 3>;
Vec3 area_of(Corners const& c) { return 0.5 * cross(c[1] - c[0], c[2] - c[0]); }
/// The side, from its corner on, that is least like the two others: mirror images have each other's.
std::size_t odd_side(Corners const& c) {
  double const l[3] = {length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])};
  auto const odd = [&](std::size_t k) { return std::fabs(2 * l[k] - l[(k + 1) % 3] - l[(k + 2) % 3]); };
  std::size_t side = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (odd(k) > odd(side)) side = k;
  }
  return side;
}
double longest_of(Corners const& c) {
  return std::max({length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])});
}
double height_of(Corners const& c) {
  double const longest = longest_of(c);
  return 2 * length(area_of(c)) / (longest * longest);
}

class Remesher {
 public:
  Remesher(TriangleSurface const& surface, LocalRemeshOptions const& options)
      : before_(surface),
        o_(options),
        cos_sharp_(std::cos(options.feature_angle * std::numbers::pi / 180)),
        mesh_(to_cgal<Mesh>(surface)) {
    parents_ = mesh_.add_property_map<Face, std::vector<int>>("f:parents").first;
    for (Face const f : mesh_.faces()) parents_[f] = {static_cast<int>(f)};
  }

  LocalRemesh run() {
    for (int n = 0; n < rounds; ++n) {
      std::uint64_t const before = changes();
      split(), collapse(), flip(), move();
      if (changes() == before) break;
    }
    for (Face const f : mesh_.faces()) set_first_side(f);
    mesh_.collect_garbage();
    LocalRemesh out{.surface = from_cgal(mesh_), .parents = {}, .counts = counts_};
    for (Face const f : mesh_.faces()) {
      std::vector<int>& p = parents_[f];
      std::sort(p.begin(), p.end());
      p.erase(std::unique(p.begin(), p.end()), p.end());
      out.parents.push_back(std::move(p));
    }
    return out;
  }

 private:
  [[nodiscard]] std::uint64_t changes() const { return counts_.splits + counts_.collapses + counts_.flips; }
  [[nodiscard]] Vec3 at(Vertex v) const {
    auto const& p = mesh_.point(v);
    return {p.x(), p.y(), p.z()};
  }
  void put(Vertex v, Vec3 const& x) { mesh_.point(v) = {x[0], x[1], x[2]}; }
  [[nodiscard]] double length_of(Edge e) const { return length(at(mesh_.vertex(e, 0)) - at(mesh_.vertex(e, 1))); }
  [[nodiscard]] Corners corners(Face f) const {
    Half const h = mesh_.halfedge(f);
    return {at(mesh_.source(h)), at(mesh_.target(h)), at(mesh_.target(mesh_.next(h)))};
  }
  /// A triangle that is what it was keeps its first side.
  void set_first_side(Face f) {
    Corners const now = corners(f);
    std::size_t const number = f;  // as of the triangle that it was
    std::size_t side = 0;
    auto const turned = [&] { return Corners{now[side], now[(side + 1) % 3], now[(side + 2) % 3]}; };
    while (side < 3 && (number >= before_.size() || turned() != before_.corners(number))) ++side;
    if (side == 3) side = odd_side(now);
    Half h = mesh_.prev(mesh_.halfedge(f));
    for (std::size_t k = 0; k < side; ++k) h = mesh_.next(h);
    mesh_.set_halfedge(f, h);
  }
  /// Calls f(halfedge to v) for the triangles around a vertex.
  template <class F>
  void for_each_around(Vertex v, F const& f) const {
    for (Half const h : mesh_.halfedges_around_target(mesh_.halfedge(v))) {
      if (!mesh_.is_border(h)) f(h);
    }
  }
  /// Sum of the area vectors of the triangles around a vertex.
  [[nodiscard]] Vec3 area_around(Vertex v) const {
    Vec3 area{0, 0, 0};
    for_each_around(v, [&](Half h) { area = area + area_of(corners(mesh_.face(h))); });
    return area;
  }
  /// Least height of the triangles around a vertex.
  [[nodiscard]] double worst_around(Vertex v) const {
    double worst = 1;
    for_each_around(v, [&](Half h) { worst = std::min(worst, height_of(corners(mesh_.face(h)))); });
    return worst;
  }
  [[nodiscard]] bool sharp(Edge e) const {
    if (mesh_.is_border(e)) return true;
    Vec3 const a = area_of(corners(mesh_.face(mesh_.halfedge(e, 0)))),
               b = area_of(corners(mesh_.face(mesh_.halfedge(e, 1))));
    return dot(a, b) < cos_sharp_ * length(a) * length(b);
  }
  /// The axis across the plane that holds these points, of a vertex at the border and its neighbours there; 3 if none
  /// does. Of two, where a side of the body lies across an axis as well, the one that the surface is less across.
  [[nodiscard]] std::size_t axis_of(Vertex v, std::array<Vertex, 2> const& line) const {
    Vec3 const area = area_around(v);
    std::size_t found = 3;
    for (std::size_t a = 0; a < 3; ++a) {
      if (at(line[0])[a] != at(v)[a] || at(line[1])[a] != at(v)[a]) continue;
      if (found == 3 || std::fabs(area[a]) < std::fabs(area[found])) found = a;
    }
    return found;
  }
  /// `line`: neighbours along the sharp line or the border, where the vertex lies on one.
  [[nodiscard]] Place place(Vertex v, std::array<Vertex, 2>& line) const {
    std::size_t n = 0;
    for (Half const h : mesh_.halfedges_around_target(mesh_.halfedge(v))) {
      if (!sharp(mesh_.edge(h))) continue;
      if (n == 2) return Place::corner;
      line[n++] = mesh_.source(h);
    }
    if (n == 0) return Place::side;
    if (n == 1) return Place::corner;
    Vec3 const a = at(v) - at(line[0]), b = at(line[1]) - at(v);
    if (dot(a, b) <= std::cos(straight * std::numbers::pi / 180) * length(a) * length(b)) return Place::corner;
    if (!mesh_.is_border(v)) return Place::line;
    return axis_of(v, line) < 3 ? Place::border : Place::corner;
  }

  /// Edges for which f gives a number below 0, by that number; of equals, sides of one triangle, the longest first.
  template <class F>
  std::vector<Edge> edges_by(F const& f) const {
    std::vector<std::tuple<double, double, Edge>> found;
    for (Edge const e : mesh_.edges()) {
      double const x = f(e);
      if (x < 0) found.emplace_back(x, -length_of(e), e);
    }
    std::sort(found.begin(), found.end());
    std::vector<Edge> out;
    for (auto const& [x, longest, e] : found) out.push_back(e);
    return out;
  }

  void split() {
    for (Edge const e : edges_by([&](Edge e) { return o_.longest - length_of(e); })) {
      Half h = mesh_.halfedge(e);
      if (mesh_.is_border(h)) h = mesh_.opposite(h);
      bool const border = mesh_.is_border(mesh_.opposite(h));
      Vec3 const middle = 0.5 * (at(mesh_.source(h)) + at(mesh_.target(h)));
      std::array<std::vector<int>, 2> parents{parents_[mesh_.face(h)], {}};
      if (!border) parents[1] = parents_[mesh_.face(mesh_.opposite(h))];
      Half const half = CGAL::Euler::split_edge(h, mesh_), back = mesh_.opposite(half);
      put(mesh_.target(half), middle);
      Half const one = CGAL::Euler::split_face(half, mesh_.next(mesh_.next(half)), mesh_);
      for (Half const s : {one, mesh_.opposite(one)}) parents_[mesh_.face(s)] = parents[0];
      ++counts_.splits;
      if (border) continue;
      Half const two = CGAL::Euler::split_face(mesh_.prev(back), mesh_.next(back), mesh_);
      for (Half const s : {two, mesh_.opposite(two)}) parents_[mesh_.face(s)] = parents[1];
    }
  }

  /// A triangle around a vertex, and what it would be if the vertex were at x.
  struct Changed {
    Corners before, after;
  };
  [[nodiscard]] Changed changed(Half to_vertex, Vec3 const& x) const {
    Vec3 const b = at(mesh_.target(mesh_.next(to_vertex))), c = at(mesh_.source(to_vertex));
    return {{at(mesh_.target(to_vertex)), b, c}, {x, b, c}};
  }
  /// No normal turns far, and no triangle becomes worse than the worst was or than is wanted.
  [[nodiscard]] bool sound(std::vector<Changed> const& triangles, double worst) const {
    for (Changed const& t : triangles) {
      Vec3 const a = area_of(t.before), b = area_of(t.after);
      double const la = length(a), lb = length(b);
      bool const flat = height_of(t.before) < o_.height;  // its normal means little
      if (!(lb > 0) || (!flat && dot(a, b) < cos_turn * la * lb)) return false;
      if (height_of(t.after) < std::min(worst, o_.height * 1.5)) return false;
    }
    return true;
  }
  /// x corrected along the area vector so that the volume stays; false if that is far. `lost`: volume that the
  /// triangles with x have less than those before.
  /// Along `axis`, if it is one, x stays.
  [[nodiscard]] bool keep_volume(std::vector<Changed> const& triangles, double lost, double most, std::size_t axis,
                                 Vec3& x) const {
    Vec3 area{0, 0, 0};
    for (Changed const& t : triangles) area = area + area_of(t.after);
    if (axis < 3) area[axis] = 0;
    double const square = dot(area, area);
    if (!(square > 0)) return false;
    Vec3 const shift = (3 * lost / square) * area;
    x = x + shift;
    return length(shift) < most;
  }

  void collapse() {
    auto const wanted = [&](Edge e) {
      double const l = length_of(e);
      if (l < o_.shortest) return l - o_.shortest;
      // the shortest edge of a flat triangle
      for (Half const h : {mesh_.halfedge(e, 0), mesh_.halfedge(e, 1)}) {
        if (mesh_.is_border(h)) continue;
        Corners const c = corners(mesh_.face(h));
        if (height_of(c) < o_.height && l < 0.5 * longest_of(c)) return l / longest_of(c) - 1e6;
      }
      return 1.0;
    };
    for (Edge const e : edges_by(wanted)) {
      if (mesh_.is_removed(e) || !(wanted(e) < 0)) continue;
      if (CGAL::Euler::does_satisfy_link_condition(e, mesh_)) try_collapse(e);
    }
  }

  void try_collapse(Edge e) {
    Half const h = mesh_.halfedge(e);
    Vertex const a = mesh_.source(h), b = mesh_.target(h);
    std::array<Vertex, 2> line_a{}, line_b{};
    Place const pa = place(a, line_a), pb = place(b, line_b);
    if (pa == Place::corner && pb == Place::corner) return;
    if (pa != Place::side && pb != Place::side && !sharp(e)) return;
    if (mesh_.is_border(a) && mesh_.is_border(b) && !mesh_.is_border(e)) return;
    bool const fixed = pa != pb;
    Vec3 x = 0.5 * (at(a) + at(b));
    if (fixed) x = static_cast<int>(pa) > static_cast<int>(pb) ? at(a) : at(b);

    std::vector<Changed> around;
    double const worst = std::min(worst_around(a), worst_around(b));
    std::vector<Face> gone;
    for (Half const s : {h, mesh_.opposite(h)}) {
      if (!mesh_.is_border(s)) gone.push_back(mesh_.face(s));
    }
    auto const collect = [&](Vec3 const& to) {
      around.clear();
      for (Vertex const v : {a, b}) {
        for_each_around(v, [&](Half s) {
          if (std::find(gone.begin(), gone.end(), mesh_.face(s)) == gone.end()) around.push_back(changed(s, to));
        });
      }
    };
    // volume between the triangles before and after, from the new place
    auto const lost = [&](Vec3 const& to) {
      double v = 0;
      for (Face const f : gone) v += dot(area_of(corners(f)), corners(f)[0] - to) / 3;
      for (Changed const& t : around) v += dot(area_of(t.before), t.before[0] - to) / 3;
      return v;
    };
    collect(x);
    double change = lost(x);
    if (!fixed) {
      std::size_t const axis = pa == Place::border ? axis_of(a, line_a) : 3;
      if (!keep_volume(around, change, 0.25 * o_.shortest, axis, x)) return;
      collect(x), change = lost(x);
    }
    if (std::fabs(change) > 0.02 * std::pow(o_.shortest, 3) || !sound(around, worst)) return;
    for (Changed const& t : around) {
      if (longest_of(t.after) > std::max(o_.longest, longest_of(t.before))) return;
    }
    // who takes the place of the two triangles that go: their neighbours
    std::vector<std::vector<int>> lost_parents;
    for (Face const f : gone) lost_parents.push_back(parents_[f]);
    for (std::size_t k = 0; k < gone.size(); ++k) {
      for (Half const s : mesh_.halfedges_around_face(mesh_.halfedge(gone[k]))) {
        if (mesh_.edge(s) == e || mesh_.is_border(mesh_.opposite(s))) continue;
        auto& p = parents_[mesh_.face(mesh_.opposite(s))];
        p.insert(p.end(), lost_parents[k].begin(), lost_parents[k].end());
      }
    }
    put(CGAL::Euler::collapse_edge(e, mesh_), x);
    counts_.volume += std::fabs(change), ++counts_.collapses;
  }

  void flip() {
    auto const wanted = [&](Edge e) {
      if (mesh_.is_border(e)) return 1.0;
      double const worst = std::min(height_of(corners(mesh_.face(mesh_.halfedge(e, 0)))),
                                    height_of(corners(mesh_.face(mesh_.halfedge(e, 1)))));
      return worst < wanted_height && !sharp(e) ? worst - 1 : 1.0;
    };
    for (Edge const e : edges_by(wanted)) {
      if (!(wanted(e) < 0)) continue;
      Half const h = mesh_.halfedge(e), back = mesh_.opposite(h);
      Vertex const a = mesh_.source(h), b = mesh_.target(h), c = mesh_.target(mesh_.next(h)),
                   d = mesh_.target(mesh_.next(back));
      if (c == d || mesh_.halfedge(c, d).is_valid()) continue;
      Corners const one{at(a), at(d), at(c)}, two{at(b), at(c), at(d)};
      Corners const was_one = corners(mesh_.face(h)), was_two = corners(mesh_.face(back));
      double const worst = std::min(height_of(was_one), height_of(was_two));
      if (std::min(height_of(one), height_of(two)) < 1.3 * worst) continue;
      if (length(at(d) - at(c)) > o_.longest) continue;
      Vec3 const was = area_of(was_one) + area_of(was_two);
      bool level = true;
      for (Corners const& t : {one, two}) {
        level = level && dot(area_of(t), was) > cos_turn * length(area_of(t)) * length(was);
      }
      double const change = std::fabs(dot(cross(at(b) - at(a), at(c) - at(a)), at(d) - at(a))) / 6;
      if (!level || change > 0.02 * std::pow(o_.shortest, 3)) continue;
      std::vector<int> both = parents_[mesh_.face(h)];
      both.insert(both.end(), parents_[mesh_.face(back)].begin(), parents_[mesh_.face(back)].end());
      CGAL::Euler::flip_edge(h, mesh_);
      parents_[mesh_.face(h)] = both, parents_[mesh_.face(mesh_.opposite(h))] = both;
      counts_.volume += change, ++counts_.flips;
    }
  }

  /// From a vertex towards the middle of its neighbours, along the side or the line that it is on; nothing at corners.
  [[nodiscard]] Vec3 way_to_middle(Vertex v) const {
    std::array<Vertex, 2> line{};
    Place const where = place(v, line);
    if (where == Place::corner) return {0, 0, 0};
    Vec3 const area = area_around(v);
    Vec3 middle{0, 0, 0};
    int n = 0;
    for_each_around(v, [&](Half h) { middle = middle + at(mesh_.source(h)), ++n; });
    Vec3 shift = step * ((1.0 / n) * middle - at(v));
    if (where == Place::line) {
      Vec3 const tangent = at(line[1]) - at(line[0]);
      shift = (dot(shift, tangent) / dot(tangent, tangent)) * tangent;
    }
    // the volume's derivative by the place is the area vector over three
    return shift - (dot(shift, area) / dot(area, area)) * area;
  }

  /// Vertices of flat triangles, the flattest first; of one triangle the one that has the longest way.
  void move() {
    std::vector<std::tuple<double, double, Vertex>> flat;
    for (Vertex const v : mesh_.vertices()) {
      if (mesh_.is_border(v)) continue;
      double const worst = worst_around(v);
      if (worst <= o_.height * 1.5) flat.emplace_back(worst, -length(way_to_middle(v)), v);
    }
    std::sort(flat.begin(), flat.end());
    for (auto const& [at_first, way, v] : flat) {
      double const worst = worst_around(v);
      if (worst > o_.height * 1.5) continue;
      Vec3 const x = at(v) + way_to_middle(v);
      std::vector<Changed> around;
      double after = 1;
      for (Half const h : mesh_.halfedges_around_target(mesh_.halfedge(v))) {
        around.push_back(changed(h, x)), after = std::min(after, height_of(around.back().after));
      }
      if (!(after > worst) || !sound(around, worst)) continue;
      put(v, x), ++counts_.moves;
    }
  }

  TriangleSurface const& before_;
  LocalRemeshOptions o_;
  double cos_sharp_;
  Mesh mesh_;
  Mesh::Property_map<Face, std::vector<int>> parents_;
  LocalRemeshCounts counts_;
};

}  // namespace

bool needs_remeshing(TriangleSurface const& surface, LocalRemeshOptions const& o) {
  for (std::size_t t = 0; t < surface.size(); ++t) {
    Corners const c = surface.corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      double const l = length(c[(k + 1) % 3] - c[k]);
      if (l < o.shortest || l > o.longest) return true;
    }
    if (height_of(c) < o.height) return true;
  }
  return false;
}

LocalRemesh local_remesh(TriangleSurface const& surface, LocalRemeshOptions const& options) {
  LocalRemesh out = Remesher(surface, options).run();
  if (self_intersections(out.surface, 1).empty() || !self_intersections(surface, 1).empty()) return out;
  LocalRemesh same{.surface = surface, .parents = {}, .counts = {}};
  for (std::size_t t = 0; t < surface.size(); ++t) same.parents.push_back({static_cast<int>(t)});
  same.counts.refused = 1;
  return same;
}

}  // namespace g27
