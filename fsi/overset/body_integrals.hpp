#pragma once
/// What a body holds: mass, momentum, angular momentum, energy, over the volume within its surface.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Of the polyhedron within the surface and the planes of symmetry that cut it: exact.
struct Enclosed {
  double volume = 0;                ///< [m^3]
  Vec3 centroid{0, 0, 0};           ///< [m]
  std::array<double, 6> moments{};  ///< second moments about it, xx yy zz xy xz yz [m^5]
};
Enclosed enclosed(Body const& body);
/// Of a surface that planes cut.
Enclosed enclosed(TriangleSurface const& surface, Mirrors const& cut);

/// Of a body that planes of symmetry cut: of the part within the domain.
struct BodyIntegrals {
  double volume = 0, mass = 0;      ///< [m^3], [kg]
  Vec3 centre{0, 0, 0};             ///< of mass [m]
  Vec3 momentum{0, 0, 0};           ///< [N s]
  Vec3 angular{0, 0, 0};            ///< about the centre of mass [N m s]
  double strain = 0;                ///< elastic energy, p^2/(2 K) + S:S/(4 mu) [J]
  double energy = 0, kinetic = 0;   ///< total, and its kinetic part [J]
  std::array<double, 6> inertia{};  ///< second moments of mass about the centre, xx yy zz xy xz yz [kg m^2]
};

/// Cells that the surface cuts take the part within it, by `rays` x `rays` lines along x each, and the state at the
/// centre of that part; the parts are scaled so that they add up to the polyhedron's volume.
BodyIntegrals integrals(Body const& body, int rays = 4);

}  // namespace g27
