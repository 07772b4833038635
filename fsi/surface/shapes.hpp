#pragma once
/// Surfaces of basic bodies, centred at the origin, with triangles of a wanted edge length.
///
/// Edges are between 0.7 and 1.2 times the length asked for, where every side of the body has room for six; thinner
/// parts have shorter ones.
#include <functional>
#include <map>

#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// size: lengths along x, y and z [m]. Each side is parted into rectangles and these into four triangles about their
/// centres: the mesh has every symmetry of the box.
TriangleSurface make_box(Vec3 const& size, double edge);

/// About the z axis; vertices on the cylinder, so that its volume is too small by a part of O(edge^2/radius^2) [m].
TriangleSurface make_cylinder(double radius, double height, double edge);

/// Vertices on the sphere; volume as of the cylinder. From an icosahedron, each side in n^2 triangles.
TriangleSurface make_sphere(double radius, double edge);

/// Regular, with a corner on the z axis; side: length between its corners [m].
TriangleSurface make_tetrahedron(double side, double edge);

struct ShapeParameter {
  std::string name, what, example;
};

/// A shape as a command makes it; all parameters are lengths [m] and required, `edge` among them.
struct Shape {
  std::string name, what;
  std::vector<ShapeParameter> parameters;
  std::function<TriangleSurface(std::map<std::string, double> const&)> make;
};

/// Sorted by name: box cube cylinder disc plate sphere tetrahedron.
std::vector<Shape> const& all_shapes();

}  // namespace g27
