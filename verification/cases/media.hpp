#pragma once
/// One medium of each law, with a state to put waves on: as the scheme knows it and as the exact solutions know it.
#include <string>
#include <vector>

#include "riemann/eos/registry.hpp"
#include "riemann/state/gas.hpp"
#include "verification/exact/eos.hpp"

namespace g27 {

struct Medium {
  AnyEos eos;
  ExactEos exact;
  GasState<> base;  ///< at rest
  double sound;     ///< sound speed there [m/s]
  /// relative change of density at the base's pressure that keeps off the cold curve: little in a condensed medium
  double density_swing;
};

/// ideal: gamma 1.4, rho = 1, c = 1. stiffened: water (gamma 4.4, p_inf 0.6 GPa) at 1 bar. jwl: the TNT-RDX products of
/// the paper at 1300 kg/m^3, 5 GPa. mie-gruneisen: aluminium 2024 at 2900 kg/m^3, 5 GPa.
/// Throws std::invalid_argument for another name.
Medium medium(std::string const& eos);

std::vector<std::string> media();

}  // namespace g27
