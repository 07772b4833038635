#pragma once
/// Solids of the verification cases: as the scheme knows them and as the exact solutions know them.
#include <string>
#include <vector>

#include "riemann/solid/material.hpp"
#include "verification/exact/solid.hpp"

namespace g27 {

struct SolidMedium {
  AnySolid scheme;
  SolidMaterial exact;
  double rho0;   ///< unstressed [kg/m^3]
  double bulk;   ///< modulus, unstressed [Pa]
  double sound;  ///< of P waves, unstressed [m/s]
};

/// steel: the paper's, K 175, mu 80.77, Y 0.34, H 0.24 GPa, 7800 kg/m^3, linear bulk modulus. aluminium: 2024, Meyers,
/// Dynamic Behavior of Materials (1994), table 5.1, mu 27.6, Y 0.3 GPa. beryllium: that of
/// Howell and Ball's shell, 1845 kg/m^3, mu 151, Y 0.33 GPa; its law U_s = 7998 m/s + 1.124 u_p, Gamma 1.1 in round
/// values, on which a shell that moves as if incompressible hardly depends. copper: of the rods that strike a wall in
/// Foulk et al. (2021), E 117 GPa, nu .35, Y 0.4, H 0.1 GPa, 8930 kg/m^3, linear bulk modulus. `plastic`: with
/// their yield stress, else elastic. Throws std::invalid_argument for another name.
SolidMedium solid_medium(std::string const& name, bool plastic = false);

/// Those that every case of grids is run with: steel aluminium.
std::vector<std::string> solid_media();

/// A state with the pressure and energy of the law's reference curve at this density (of the linear law), or of
/// `p` [Pa].
SolidPoint solid_state(SolidMedium const& m, double rho, Vector3 const& u, double p, Tensor6 const& S = {},
                       double ep = 0);

}  // namespace g27
