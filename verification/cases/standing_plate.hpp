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

/// The body of a material without stress at a pressure, to be given an initial velocity; `room` [m]: where it may go
/// along x, and half as far along y.
BodySetup body_of(StandingPlate const& plate, AnySolid const& material, double room);

/// Mean displacement along x of the upper end; the surface has not been meshed anew [m].
double tip_displacement(TriangleSurface const& now, StandingPlate const& plate);

}  // namespace g27
