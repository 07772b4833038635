#pragma once
/// An elastic plate that stands clamped on the wall y = 0, between planes of symmetry across z: bending in the plane.
#include "fsi/overset/body.hpp"

namespace g27 {

struct StandingPlate {
  double thickness, height, width;  ///< along x from 0, along y from 0, along z from 0 [m]
  double cell;                      ///< of its grid [m]
};

/// Its surface, open at the walls: strips along z of 4/3 of a cell, each rectangle in two triangles.
TriangleSurface surface_of(StandingPlate const& plate);

/// Density without pressure [kg/m^3], Young's modulus [Pa], Poisson's ratio.
AnySolid elastic_material(double density, double young, double poisson);

/// The body at rest at a pressure; `room` [m]: where it may go along x, and half as far along y.
BodySetup body_of(StandingPlate const& plate, AnySolid const& material, double pressure, double room);

/// Mean displacement along x of the upper end; the surface has not been meshed anew [m].
double tip_displacement(TriangleSurface const& now, StandingPlate const& plate);

}  // namespace g27
