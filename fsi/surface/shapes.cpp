#include "fsi/surface/shapes.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "fsi/surface/stl_file.hpp"

namespace g27 {
namespace {

constexpr double most_triangles = 1e7;

void check(std::initializer_list<double> lengths, double edge) {
  double area = 0;
  for (double const l : lengths) {
    if (!(l > 0) || !std::isfinite(l)) throw SurfaceError("a length is not positive", "give lengths such as 1 cm");
    area = std::max(area, l * l);
  }
  if (!(edge > 0) || !std::isfinite(edge)) {
    throw SurfaceError("the edge length is not positive", "give one such as 0.07 cm");
  }
  if (area / (edge * edge) > most_triangles / 20) {
    throw SurfaceError("the edge length would make more than ten million triangles", "give a longer one");
  }
}

int parts(double number) { return std::max(1, static_cast<int>(number)); }

/// Each triangle in n^2, with common vertices on common edges; vertices between corners are linear.
TriangleSurface subdivide(TriangleSurface const& coarse, int n) {
  TriangleSurface out{coarse.vertices, {}};
  std::map<std::pair<int, int>, int> first_on_edge;
  // Vertex at `step` of n from a to b.
  auto on_edge = [&](int a, int b, int step) {
    if (step == 0 || step == n) return step == 0 ? a : b;
    auto const [at, fresh] = first_on_edge.emplace(std::minmax(a, b), static_cast<int>(out.vertices.size()));
    if (fresh) {
      Vec3 const low = coarse.at(std::min(a, b)), high = coarse.at(std::max(a, b));
      for (int k = 1; k < n; ++k) out.vertices.push_back(1.0 / n * ((n - k) * low + static_cast<double>(k) * high));
    }
    return at->second + (a < b ? step : n - step) - 1;
  };
  for (auto const& [a, b, c] : coarse.triangles) {
    // Rows from the side a b to the corner c.
    std::vector<std::vector<int>> rows;
    for (int j = 0; j <= n; ++j) {
      std::vector<int>& row = rows.emplace_back();
      for (int i = 0; i + j <= n; ++i) {
        if (j == 0) {
          row.push_back(on_edge(a, b, i));
        } else if (i == 0) {
          row.push_back(on_edge(a, c, j));
        } else if (i + j == n) {
          row.push_back(on_edge(b, c, j));
        } else {
          row.push_back(static_cast<int>(out.vertices.size()));
          out.vertices.push_back(
              1.0 / n * ((n - i - j) * coarse.at(a) + static_cast<double>(i) * coarse.at(b) + j * coarse.at(c)));
        }
      }
    }
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      for (std::size_t i = 0; i + 1 < rows[j].size(); ++i) {
        out.triangles.push_back({rows[j][i], rows[j][i + 1], rows[j + 1][i]});
        if (i + 1 < rows[j + 1].size()) {
          out.triangles.push_back({rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]});
        }
      }
    }
  }
  return out;
}

/// Triangles between successive circles about the z axis, each with its own number of vertices; 1: a point on the axis.
class Revolution {
 public:
  /// phase: of a step, by which the circle is turned
  void add_circle(double radius, double z, int count, double phase) {
    Circle const next{static_cast<int>(surface_.vertices.size()), count};
    for (int k = 0; k < count; ++k) {
      double const angle = 2 * std::numbers::pi * (k + phase) / count;
      surface_.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    if (next.first > 0) connect(last_, next);
    last_ = next;
  }
  [[nodiscard]] TriangleSurface const& surface() const { return surface_; }

 private:
  struct Circle {
    int first, count;
    [[nodiscard]] int vertex(int k) const { return first + k % count; }
  };

  /// Goes around both circles at once, each time along the shorter diagonal.
  void connect(Circle const& below, Circle const& above) {
    int const end_below = below.count > 1 ? below.count : 0, end_above = above.count > 1 ? above.count : 0;
    for (int i = 0, j = 0; i < end_below || j < end_above;) {
      int const a = below.vertex(i), b = above.vertex(j), next_a = below.vertex(i + 1), next_b = above.vertex(j + 1);
      bool const along_below = j == end_above || (i < end_below && distance(next_a, b) <= distance(a, next_b));
      surface_.triangles.push_back({a, along_below ? next_a : next_b, b});
      ++(along_below ? i : j);
    }
  }
  [[nodiscard]] double distance(int a, int b) const { return length(surface_.at(a) - surface_.at(b)); }

  TriangleSurface surface_;
  Circle last_{0, 0};
};

using Lengths = std::map<std::string, double>;

ShapeParameter edge_parameter() { return {"edge", "length of the triangles' edges", "0.07 cm"}; }

}  // namespace

TriangleSurface make_box(Vec3 const& size, double edge) {
  check({size[0], size[1], size[2]}, edge);
  std::array<int, 3> n{};
  for (std::size_t d = 0; d < 3; ++d) n[d] = parts(std::ceil(size[d] / (1.2 * edge) - 1e-9));
  std::vector<std::array<Vec3, 3>> facets;
  for (std::size_t d = 0; d < 3; ++d) {
    std::size_t const u = (d + 1) % 3, v = (d + 2) % 3;
    for (int const side : {-1, 1}) {
      auto point = [&](int i, int j, bool centre) {
        Vec3 x{};
        x[d] = side * n[d] * size[d] / (2 * n[d]);  // rounded as on the sides beside
        x[u] = ((centre ? 2 * i + 1 : 2 * i) - n[u]) * size[u] / (2 * n[u]);
        x[v] = ((centre ? 2 * j + 1 : 2 * j) - n[v]) * size[v] / (2 * n[v]);
        return x;
      };
      for (int j = 0; j < n[v]; ++j) {
        for (int i = 0; i < n[u]; ++i) {
          std::array<Vec3, 4> corner{point(i, j, false), point(i + 1, j, false), point(i + 1, j + 1, false),
                                     point(i, j + 1, false)};
          if (side < 0) std::swap(corner[1], corner[3]);
          for (std::size_t k = 0; k < 4; ++k) {
            facets.push_back({corner[k], corner[(k + 1) % 4], point(i, j, true)});
          }
        }
      }
    }
  }
  return weld(facets);
}

TriangleSurface make_cylinder(double radius, double height, double edge) {
  check({radius, height, 2 * std::numbers::pi * radius}, edge);
  // Between aligned vertices of two circles, the diagonal is the longest edge: sqrt(2) 0.84.
  double const step = 0.84 * edge;
  auto whole = [](double number) { return parts(std::ceil(number - 1e-9)); };
  int const circles = whole(radius / step), layers = whole(height / step);
  auto count = [&](int k) {
    return k == 0 ? 1 : std::max(6, whole(2 * std::numbers::pi * radius * k / circles / step));
  };
  Revolution body;
  for (int k = 0; k <= circles; ++k) body.add_circle(radius * k / circles, -height / 2, count(k), 0);
  for (int k = 1; k < layers; ++k) {
    body.add_circle(radius, -height / 2 + height * k / layers, count(circles), k % 2 == 1 ? 0.5 : 0);
  }
  double const phase = layers % 2 == 1 ? 0.5 : 0;
  for (int k = circles; k >= 0; --k) body.add_circle(radius * k / circles, height / 2, count(k), phase);
  return body.surface();
}

TriangleSurface make_sphere(double radius, double edge) {
  check({radius}, edge);
  double const g = std::numbers::phi;
  TriangleSurface const icosahedron{
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriangleSurface out = subdivide(icosahedron, parts(std::ceil(1.11 * radius / edge)));
  for (Vec3& x : out.vertices) x = (radius / length(x)) * x;
  return out;
}

TriangleSurface make_tetrahedron(double side, double edge) {
  check({side}, edge);
  double const r = side / std::sqrt(3.0), h = side * std::sqrt(2.0 / 3);
  return subdivide({{{r, 0, -h / 4}, {-r / 2, side / 2, -h / 4}, {-r / 2, -side / 2, -h / 4}, {0, 0, 3 * h / 4}},
                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
                   parts(std::round(side / edge)));
}

std::vector<Shape> const& all_shapes() {
  static std::vector<Shape> const shapes{
      {"box",
       "a box with sides along the axes",
       {{"x", "length along x", "2 cm"},
        {"y", "length along y", "1 cm"},
        {"z", "length along z", "1 cm"},
        edge_parameter()},
       [](Lengths const& l) {
         return make_box({l.at("x"), l.at("y"), l.at("z")}, l.at("edge"));
       }},
      {"cube",
       "a cube with sides along the axes",
       {{"side", "length of its sides", "1 cm"}, edge_parameter()},
       [](Lengths const& l) {
         return make_box({l.at("side"), l.at("side"), l.at("side")}, l.at("edge"));
       }},
      {"cylinder",
       "a cylinder about the z axis",
       {{"radius", "of its sides", "0.5 cm"}, {"height", "along the axis", "1 cm"}, edge_parameter()},
       [](Lengths const& l) { return make_cylinder(l.at("radius"), l.at("height"), l.at("edge")); }},
      {"disc",
       "a flat cylinder about the z axis",
       {{"radius", "of its rim", "0.5 cm"}, {"thickness", "along the axis", "0.14 cm"}, edge_parameter()},
       [](Lengths const& l) { return make_cylinder(l.at("radius"), l.at("thickness"), l.at("edge")); }},
      {"plate",
       "a square plate across the z axis",
       {{"side", "length of its sides", "2 cm"}, {"thickness", "along z", "0.15 cm"}, edge_parameter()},
       [](Lengths const& l) {
         return make_box({l.at("side"), l.at("side"), l.at("thickness")}, l.at("edge"));
       }},
      {"sphere",
       "a ball",
       {{"radius", "of its surface", "0.5 cm"}, edge_parameter()},
       [](Lengths const& l) { return make_sphere(l.at("radius"), l.at("edge")); }},
      {"tetrahedron",
       "a regular tetrahedron, one corner on the z axis",
       {{"side", "length between its corners", "1 cm"}, edge_parameter()},
       [](Lengths const& l) { return make_tetrahedron(l.at("side"), l.at("edge")); }}};
  return shapes;
}

}  // namespace g27
