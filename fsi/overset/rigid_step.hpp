#pragma once
/// The step of a rigid body among the pressures on its triangles.
///
/// The walls of the model problems move as the body does at the half of the step, which is found first: by the
/// pressures of the last step and the impedance of the gas beside each triangle. The pressures that the walls meet then
/// give the impulse. Second order in time, one model problem a triangle.
#include "fsi/overset/closure.hpp"

namespace g27 {

/// Velocities of the triangles and directions of their axes at the half of a step of dt from `time` on [s].
void start_rigid_step(Body& body, AnyEos const& gas, double time, double dt);

/// Once the triangles have their pressures: momenta, the body's too, and place at the end of the step.
void finish_rigid_step(Body& body, double time, double dt, BodyMomentum& held);

}  // namespace g27
