#pragma once
/// The surface of a body as triangles, and what the body within it holds.
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "fsi/surface/vec3.hpp"

namespace g27 {

/// A surface that cannot be read, made or meshed: what is wrong, and what to do about it.
struct SurfaceError : std::runtime_error {
  SurfaceError(std::string what_, std::string remedy_)
      : std::runtime_error(what_ + "; " + remedy_), problem(std::move(what_)), remedy(std::move(remedy_)) {}
  std::string problem, remedy;
};

/// Indices of three vertices, counter-clockwise when seen from outside the body: the normal points out of it.
using Triangle = std::array<int, 3>;

struct TriangleSurface {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;

  [[nodiscard]] std::size_t size() const noexcept { return triangles.size(); }
  [[nodiscard]] std::array<Vec3, 3> corners(std::size_t t) const noexcept {
    auto const& [a, b, c] = triangles[t];
    return {at(a), at(b), at(c)};
  }
  /// Centroid of a triangle [m].
  [[nodiscard]] Vec3 centre(std::size_t t) const noexcept {
    auto const [a, b, c] = corners(t);
    return (1.0 / 3.0) * (a + b + c);
  }
  /// Normal times area [m^2].
  [[nodiscard]] Vec3 area_vector(std::size_t t) const noexcept {
    auto const [a, b, c] = corners(t);
    return 0.5 * cross(b - a, c - a);
  }
  [[nodiscard]] double area(std::size_t t) const noexcept { return length(area_vector(t)); }
  /// Unit normal; not finite for a triangle without area.
  [[nodiscard]] Vec3 normal(std::size_t t) const noexcept {
    Vec3 const n = area_vector(t);
    return (1 / length(n)) * n;
  }
  [[nodiscard]] Vec3 const& at(int vertex) const noexcept { return vertices[static_cast<std::size_t>(vertex)]; }
};

struct BoundingBox {
  Vec3 lower, upper;  ///< [m]
  [[nodiscard]] double diagonal() const noexcept { return length(upper - lower); }
};

/// Smallest box around the triangles' corners. Needs a triangle.
BoundingBox bounding_box(TriangleSurface const& surface);

/// Integrals over the surface and over the body within it: exact for the polyhedron. An inward surface has a negative
/// volume and mass; an open one has volume and moments that depend on where it lies.
struct MassProperties {
  double area = 0, volume = 0, mass = 0;           ///< [m^2], [m^3], [kg]
  Vec3 centroid{0, 0, 0};                          ///< [m]
  std::array<std::array<double, 3>, 3> inertia{};  ///< tensor about the centroid [kg m^2]
};

/// density: [kg/m^3]. Volume integrals by the divergence theorem, from a point of the body's box, so that a body far
/// from the origin loses no digits. Needs a triangle.
MassProperties mass_properties(TriangleSurface const& surface, double density = 1);

}  // namespace g27
