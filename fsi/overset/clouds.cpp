#include "fsi/overset/clouds.hpp"

namespace g27 {

namespace {

/// Width of the gas's cells over that of a body's, and so of its triangles, from which on there are so many of these to
/// a cell that a fit would read ten cores for each.
constexpr double dense_from = 1.5;

bool within(WindowBox const& box, Vec3 const& x) {
  for (std::size_t a = 0; a < 3; ++a) {
    double const from = box.lower[a] + box.first[a] * box.h;
    if (x[a] < from || x[a] > from + box.size[a] * box.h) return false;
  }
  return true;
}

/// A core, and its images.
template <class Fields>
void add(std::vector<CloudPoint<Fields>>& points, WindowBox const& box, Vec3 const& x, Fields const& q,
         Vec3 const& foot, std::size_t triangle) {
  int const number = static_cast<int>(triangle);
  if (within(box, x)) points.push_back({x, q, number, foot});
  box.mirrors.for_each([&](Image const& image) {
    Vec3 const y = box.mirrors.image(x, image);
    if (within(box, y))
      points.push_back({y, reflected(q, image, box.mirrors.clamps), number, box.mirrors.image(foot, image), image});
  });
}

}  // namespace

void set_gas_cloud(Body& body, std::vector<std::unique_ptr<Body>> const& all) {
  CellKinds const& kinds = body.gas.kinds;
  double const h = kinds.box().h;
  std::vector<CloudPoint<GasFields>> points;
  for (auto const& other : all) {
    for (std::size_t n = 0; n < other->triangles.size(); ++n) {
      TriangleState const& t = other->triangles[n];
      for (std::size_t k = 0; k < core_layers; ++k) {
        Vec3 const x = core_centre(t, k, h);
        if (within(kinds.box(), x) && kinds.in_medium(x)) add(points, kinds.box(), x, t.gas[k], t.centre, n);
      }
    }
  }
  body.gas.donors.set_cloud(points, h > dense_from * body.setup.cell);
}

void set_solid_cloud(Body& body) {
  CellKinds const& kinds = body.solid.kinds;
  std::vector<CloudPoint<SolidFields>> points;
  for (std::size_t n = 0; n < body.triangles.size(); ++n) {
    TriangleState const& t = body.triangles[n];
    for (std::size_t k = 0; k < core_layers; ++k) {
      Vec3 const x = core_centre(t, k, -body.setup.cell);
      if (k == 0 || kinds.in_medium(x)) add(points, kinds.box(), x, t.solid[k], t.centre, n);
    }
  }
  body.solid.donors.set_cloud(points, false);
}

}  // namespace g27
