#pragma once
/// Reading solids from the arguments of an oracle.
#include "verification/exact/arguments.hpp"
#include "verification/exact/solid.hpp"

namespace g27 {

/// Parameters of a material, each with `suffix` appended: its law (`fallback`: linear-bulk and its like), mu, strength,
/// yield and hardening. Without any of them it is the steel of solid_material_argument.
std::vector<OracleParameter> solid_parameters(std::string const& suffix = "",
                                              std::string const& fallback = "linear-bulk");
/// What is not given is taken from `other_suffix`, when there is one and its law is the same; failing that a linear law
/// is steel (K 175 GPa, 7800 kg/m^3, mu 80.77 GPa, yield 340 MPa, hardening 240 MPa) and an ideal gas or JWL products
/// have mu = 0. Throws OracleError.
SolidMaterial solid_material_argument(OracleArguments const& arguments, std::string const& suffix = "",
                                      std::string const& other_suffix = "");

/// Density and pressure: rho falls back to the reference density of the law, p to 0; the linear law's p follows from
/// rho.
std::vector<OracleParameter> solid_state_parameters(std::string const& suffix = "");
/// rho, p and e only.
SolidPoint solid_state_argument(OracleArguments const& arguments, SolidMaterial const& material,
                                std::string const& suffix = "");

/// Columns of samples along x: density, velocity, pressure, energy, Sxx, plastic strain.
struct SolidColumns {
  std::vector<double> rho, u, p, e, sxx, ep;
  void add(SolidPoint const& s);
  void append_to(OracleRecord& out) const;
};

}  // namespace g27
