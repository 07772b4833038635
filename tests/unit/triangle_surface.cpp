/// Surfaces of basic bodies: integrals against closed forms, meshes, neighbours, files.
#include "fsi/surface/triangle_surface.hpp"

#include <algorithm>
#include <numbers>

#include "fsi/surface/adjacency.hpp"
#include "fsi/surface/diagnosis.hpp"
#include "fsi/surface/shapes.hpp"
#include "fsi/surface/stl_file.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

constexpr double pi = std::numbers::pi;

/// Turned about the axis (1, 2, 3) by 0.7 and moved.
Vec3 moved(Vec3 const& x) {
  Vec3 const k = (1 / std::sqrt(14.0)) * Vec3{1, 2, 3};
  return std::cos(0.7) * x + std::sin(0.7) * cross(k, x) + ((1 - std::cos(0.7)) * dot(k, x)) * k + Vec3{3, -40, 7};
}

TriangleSurface moved(TriangleSurface surface) {
  for (Vec3& x : surface.vertices) x = moved(x);
  return surface;
}

struct EdgeRange {
  double smallest, largest;
};

EdgeRange edge_range(TriangleSurface const& surface, double edge) {
  auto const lengths = edge_lengths(surface);
  auto const [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  return {*least / edge, *most / edge};
}

}  // namespace

TEST_CASE("integrals over a box are exact, wherever it lies", "[surface]") {
  // 60 digits are not needed: the sums are of some hundred terms of the size of the result
  TriangleSurface const box = make_box({0.3, 0.5, 0.7}, 0.1);
  MassProperties const m = mass_properties(box, 7800);
  double const mass = 7800 * 0.3 * 0.5 * 0.7;
  CHECK(m.area == Approx(2 * (0.15 + 0.21 + 0.35)).epsilon(1e-13));
  CHECK(m.volume == Approx(0.105).epsilon(1e-13));
  CHECK(m.mass == Approx(mass).epsilon(1e-13));
  CHECK(length(m.centroid) < 1e-15);
  CHECK(m.inertia[0][0] == Approx(mass / 12 * (0.25 + 0.49)).epsilon(1e-13));
  CHECK(m.inertia[1][1] == Approx(mass / 12 * (0.09 + 0.49)).epsilon(1e-13));
  CHECK(m.inertia[2][2] == Approx(mass / 12 * (0.09 + 0.25)).epsilon(1e-13));
  CHECK(std::fabs(m.inertia[0][1]) < 1e-13 * mass);

  // The trace and the volume stay in any frame; coordinates of 40 have steps of 7e-15.
  MassProperties const away = mass_properties(moved(box), 7800);
  CHECK(away.volume == Approx(0.105).epsilon(1e-12));
  CHECK(length(away.centroid - moved(Vec3{0, 0, 0})) < 1e-13);
  CHECK(away.inertia[0][0] + away.inertia[1][1] + away.inertia[2][2] ==
        Approx(mass / 6 * (0.09 + 0.25 + 0.49)).epsilon(1e-12));
  CHECK(away.inertia[0][1] == Approx(away.inertia[1][0]).epsilon(1e-12));
  CHECK(std::fabs(away.inertia[0][1]) > 1e-3 * mass * 0.1);
}

TEST_CASE("integrals over a tetrahedron are exact", "[surface]") {
  // corners 0, a e_x, b e_y, c e_z: V = abc/6, centroid (a, b, c)/4, int x^2 dV = V a^2/10, int xy dV = V ab/20
  double const a = 0.2, b = 0.5, c = 1.1, volume = a * b * c / 6;
  TriangleSurface const corner{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}},
                               {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  MassProperties const m = mass_properties(corner, 2);
  CHECK(m.volume == Approx(volume).epsilon(1e-14));
  CHECK(m.centroid[1] == Approx(b / 4).epsilon(1e-14));
  double const yy = volume * b * b * (1.0 / 10 - 1.0 / 16), zz = volume * c * c * (1.0 / 10 - 1.0 / 16);
  CHECK(m.inertia[0][0] == Approx(2 * (yy + zz)).epsilon(1e-13));
  CHECK(m.inertia[1][2] == Approx(-2 * volume * b * c * (1.0 / 20 - 1.0 / 16)).epsilon(1e-13));
  CHECK(corner.normal(1)[1] == Approx(-1));
  CHECK(length(corner.normal(3)) == Approx(1));

  MassProperties const regular = mass_properties(make_tetrahedron(0.01, 0.0007));
  CHECK(regular.volume == Approx(1e-6 / (6 * std::sqrt(2.0))).epsilon(1e-13));
  CHECK(regular.inertia[0][0] == Approx(regular.volume * 1e-4 / 20).epsilon(1e-12));
  CHECK(length(regular.centroid) < 1e-15);
}

TEST_CASE("spheres and cylinders converge at second order", "[surface]") {
  std::vector<std::array<double, 3>> error;  // of the sphere's volume, area and inertia
  std::vector<double> cylinder;
  for (double const edge : {0.2, 0.1, 0.05, 0.025}) {
    MassProperties const s = mass_properties(make_sphere(0.5, edge));
    error.push_back({1 - s.volume / (pi / 6), 1 - s.area / pi, 1 - s.inertia[2][2] / (pi / 6 * 0.1)});
    MassProperties const c = mass_properties(make_cylinder(0.5, 2, edge));
    cylinder.push_back(1 - c.volume / (pi / 2));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t q = 0; q < 3; ++q) {
      CHECK(std::log2(error[i][q] / error[i + 1][q]) == Approx(2).margin(0.3));  // n of the icosahedron is whole
    }
    CHECK(std::log2(cylinder[i] / cylinder[i + 1]) == Approx(2).margin(0.3));
  }
  for (std::size_t q = 0; q < 3; ++q) {
    CHECK(std::log2(error[0][q] / error[3][q]) / 3 == Approx(2).margin(0.1));
  }
  CHECK(error[3][0] < 2e-3);
}

TEST_CASE("made bodies are healthy, their edges in range", "[surface]") {
  for (double const edge : {0.02, 0.05, 0.07, 0.09, 0.13}) {
    for (TriangleSurface const& s : {make_box({1, 1, 1}, edge), make_box({2, 0.9, 1.1}, edge),
                                     make_cylinder(0.8, 1, edge), make_sphere(0.7, edge), make_tetrahedron(1, edge)}) {
      Diagnosis const d = diagnose(s);
      CAPTURE(edge, s.size());
      CHECK(d.healthy());
      CHECK(d.shells == 1);
      auto const [least, most] = edge_range(s, edge);
      CHECK(least >= 0.7);
      CHECK(most <= 1.2 * (1 + 1e-8));               // a whole number of edges is taken as such to 1e-9
      CHECK(s.vertices.size() == s.size() / 2 + 2);  // Euler's polyhedron formula
    }
  }
  for (Shape const& shape : all_shapes()) {  // thin and coarse ones as well
    std::map<std::string, double> lengths;
    for (ShapeParameter const& p : shape.parameters) lengths[p.name] = p.name == "thickness" ? 0.1 : 1;
    CAPTURE(shape.name);
    CHECK(diagnose(shape.make(lengths)).healthy());
  }
  CHECK_THROWS_AS(make_box({1, 1, 0}, 0.1), SurfaceError);
  CHECK_THROWS_AS(make_sphere(1, NAN), SurfaceError);
  CHECK_THROWS_AS(make_sphere(1, 1e-9), SurfaceError);
}

TEST_CASE("a box has its symmetries", "[surface]") {
  auto const sorted = [](TriangleSurface const& s, Vec3 const& mirror) {
    std::vector<Vec3> centres;
    for (std::size_t t = 0; t < s.size(); ++t) {
      Vec3 const c = s.centre(t);
      Vec3 key{};
      for (std::size_t d = 0; d < 3; ++d) key[d] = std::round(mirror[d] * c[d] * 1e9);
      centres.push_back(key);
    }
    std::sort(centres.begin(), centres.end());
    return centres;
  };
  TriangleSurface const box = make_box({1, 0.7, 1.3}, 0.2);
  CHECK(sorted(box, {1, 1, 1}) == sorted(box, {-1, 1, 1}));
  CHECK(sorted(box, {1, 1, 1}) == sorted(box, {1, -1, 1}));
  CHECK(sorted(box, {1, 1, 1}) == sorted(box, {1, 1, -1}));
}

TEST_CASE("neighbours are mutual, vertices know their triangles", "[surface]") {
  TriangleSurface const s = make_sphere(1, 0.3);
  Adjacency const a = adjacency(s);
  CHECK(a.shells == 1);
  std::size_t corners = 0;
  for (std::size_t t = 0; t < s.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      REQUIRE(a.beside[t][e] >= 0);
      auto const n = static_cast<std::size_t>(a.beside[t][e]);
      int const from = s.triangles[t][e], to = s.triangles[t][(e + 1) % 3];
      bool found = false;
      for (std::size_t f = 0; f < 3; ++f) {
        if (s.triangles[n][f] == to && s.triangles[n][(f + 1) % 3] == from) {
          found = a.beside[n][f] == static_cast<int>(t);
        }
      }
      CHECK(found);
    }
  }
  for (int v = 0; v < static_cast<int>(s.vertices.size()); ++v) {
    for (int const t : a.around(v)) {
      auto const& triangle = s.triangles[static_cast<std::size_t>(t)];
      CHECK(std::find(triangle.begin(), triangle.end(), v) != triangle.end());
      ++corners;
    }
  }
  CHECK(corners == 3 * s.size());

  TriangleSurface two = s;  // a second body, and a hole in the first
  for (Triangle const& t : s.triangles) {
    int const n = static_cast<int>(s.vertices.size());
    two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (Vec3 const& x : s.vertices) two.vertices.push_back(x + Vec3{5, 0, 0});
  two.triangles.erase(two.triangles.begin());
  Adjacency const b = adjacency(two);
  CHECK(b.shells == 2);
  CHECK(b.shell.front() == 0);
  CHECK(b.shell.back() == 1);
  CHECK(std::count_if(b.beside.begin(), b.beside.end(),
                      [](auto const& n) { return std::find(n.begin(), n.end(), Adjacency::open) != n.end(); }) == 3);
}

TEST_CASE("dihedral angles are those within the body", "[surface]") {
  Diagnosis const cube = diagnose(make_box({1, 1, 1}, 0.3));
  CHECK(cube.angles.smallest == Approx(pi / 2));
  CHECK(cube.angles.largest == Approx(pi));
  CHECK(diagnose(make_tetrahedron(1, 2)).angles.smallest == Approx(std::acos(1.0 / 3)));
  CHECK(diagnose(make_tetrahedron(1, 2)).edges.largest == Approx(1));
  // a pit in the side of a cube: its top corner pushed down to the middle
  TriangleSurface pit = make_box({1, 1, 1}, 1);
  for (Vec3& x : pit.vertices) {
    if (x == Vec3{0, 0, 0.5}) x = {0, 0, 0};
  }
  CHECK(diagnose(pit).angles.largest == Approx(2 * pi - std::acos(0.0) - 0.0).margin(pi / 2));
  CHECK(diagnose(pit).angles.largest > pi + 0.5);
}

TEST_CASE("a surface survives its file", "[surface][stl]") {
  TriangleSurface const s = make_cylinder(0.005, 0.01, 0.0011);
  for (double const unit : {1.0, 1e-2, 1e-3}) {
    StlFile const file = parse_stl(binary_stl(s, unit));
    CHECK(file.binary);
    CHECK(file.remarks.empty());
    TriangleSurface const back = weld(file.facets, unit);
    REQUIRE(back.size() == s.size());
    CHECK(back.vertices.size() == s.vertices.size());
    for (std::size_t t = 0; t < s.size(); ++t) {
      CHECK(length(back.centre(t) - s.centre(t)) < 0.01 * 1.2e-7);  // half a step of single precision, twice
    }
    CHECK(diagnose(back).healthy());
    std::string const again = binary_stl(back, unit);
    CHECK((again == binary_stl(weld(parse_stl(again).facets, unit), unit)));  // bit by bit
  }
}

TEST_CASE("ASCII files are read however they are spelled", "[surface][stl]") {
  std::string const text =
      "SOLID my body, facet 1\r\n  FACET NORMAL 0 0 -1\r\n OUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 0 +1.0E+00 0\r\n"
      "VERTEX 1 0 0\r\nENDLOOP ENDFACET\r\nEndSolid my body\r\n"
      "solid\nfacet normal nan nan nan\touter loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 1e0 endloop "
      "endfacet\nendsolid\n";
  for (std::string const& bytes : {text, "\n " + text, "\xEF\xBB\xBF" + text}) {
    StlFile const file = parse_stl(bytes);
    CHECK_FALSE(file.binary);
    CHECK(file.solids == 2);
    REQUIRE(file.facets.size() == 2);
    CHECK(file.facets[0][1] == Vec3{0, 1, 0});
    CHECK(file.remarks.empty());
  }
  std::string const turned =
      "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 endloop endfacet";
  CHECK(parse_stl(turned).remarks.size() == 2);  // the normal, the end
}
