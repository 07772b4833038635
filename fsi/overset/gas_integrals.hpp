#pragma once
/// What the gas outside of the bodies holds: mass, momentum, angular momentum, energy.
#include "fsi/overset/overset_solver.hpp"

namespace g27 {

struct GasIntegrals {
  double volume = 0, mass = 0, energy = 0;  ///< [m^3], [kg], total energy [J]
  Vec3 momentum{0, 0, 0};                   ///< [N s]
  Vec3 angular{0, 0, 0};                    ///< about the origin [N m s]
};

/// Part of each of the gas's cells that lies outside of the bodies, x fastest, by `rays` x `rays` lines along x.
std::vector<double> gas_share(OversetSolver const& solver, int rays = 4);

/// Cells that a surface cuts take the part outside of it, with the state at the centre of that part.
GasIntegrals gas_integrals(OversetSolver const& solver, int rays = 4);

}  // namespace g27
