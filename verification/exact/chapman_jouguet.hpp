#pragma once
/// Chapman-Jouguet state: where the Rayleigh line from the unburnt explosive touches the products' Hugoniot
/// (Fickett and Davis 1979, 2A). The explosive is at rest with pressure `p0`.
#include "riemann/state/gas.hpp"
#include "verification/exact/eos.hpp"

namespace g27 {

struct ChapmanJouguet {
  double D = 0;        ///< detonation speed [m/s]
  GasState<> state{};  ///< products behind the front: rho, u, p
  double E0 = 0;       ///< energy released per initial volume, on the products' scale of energy [J/m^3]
  double rho0 = 0;     ///< density of the explosive [kg/m^3]
};

/// From the energy: e_products - E0/rho0 = (p + p0) (1/rho0 - 1/rho)/2 with sonic flow behind the front.
ChapmanJouguet chapman_jouguet(ExactEos const& products, double rho0, double E0, double p0 = 0);

/// From the isentrope p = A exp(-R1 v) + B exp(-R2 v) + C v^-(1 + omega) of a JWL gas, v = rho0/rho: its tangent from
/// (v = 1, p = 0).
ChapmanJouguet chapman_jouguet_of_isentrope(JwlLaw const& products, double C);

/// From the detonation speed, for an ideal gas: p = rho0 D^2/(gamma + 1).
ChapmanJouguet chapman_jouguet_of_speed(IdealLaw const& products, double rho0, double D);

}  // namespace g27
