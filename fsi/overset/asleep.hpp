#pragma once
/// Bodies that nothing has reached yet.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Whether a step would leave a body as it is: itself and the gas within six cells of its box at rest, uniform and in
/// balance. Velocities and deviatoric stresses must be zero bit by bit; density and pressure may differ by the
/// round-off with which cells compute them.
bool asleep(Body const& body);

}  // namespace g27
