#pragma once
/// What a body holds, kept. Momentum and angular momentum exactly: what interpolation between its grids loses or gains
/// is put back as a rigid motion. Mass by and by: vertices do not sweep quite the volume that the solid takes, and the
/// surface is moved along its normal to where it holds the mass.
#include "fsi/overset/body_integrals.hpp"

namespace g27 {

/// What the body held at the start and what the gas has given it since.
struct BodyMomentum {
  Vec3 linear{0, 0, 0};   ///< [N s]
  Vec3 angular{0, 0, 0};  ///< about the centre of the volume, which moves [N m s]
  double work = 0;        ///< of the pressures since the start [J]
  double mass = 0;        ///< [kg]
  double growth = 0;      ///< way of the surface along its normal with its next step, outwards [m]
};

BodyMomentum momentum_of(Body const& body);

/// Adds the impulse and the work of the pressures on the triangles over a step of dt [s].
void add_impulse(Body const& body, double dt, BodyMomentum& held);

/// The velocity field du + omega x (x - centre) that brings the body to what it holds; added to its cells and cores.
/// Of a body that planes of symmetry cut, the part of that motion which the planes allow. And held.growth, for the
/// mass. Clamped bodies are left as they are.
void close_content(Body& body, BodyMomentum& held);

}  // namespace g27
