#pragma once
/// Solid with a linear bulk modulus: p = K0 (rho/rho0 - 1), whatever the energy. Not for gases: the isentropes do not
/// depend on the energy, and p < 0 in expansion.
///
/// The energy is not a function of (rho, p): `energy` gives that of the cold compression from rho0,
///   e = int p drho/rho^2 = (K0/rho0) (ln(rho/rho0) + rho0/rho - 1).
#include "riemann/base/lane_math.hpp"
#include "riemann/solid/law.hpp"

namespace g27 {

struct BulkModulus {
  double rho0 = 7800.0;  ///< density at p = 0 [kg/m^3]; the defaults are steel
  double K0 = 175e9;     ///< bulk modulus at rho0 [Pa]

  static constexpr char const* name = "bulk-modulus";
  static constexpr char const* title = "linear bulk modulus: p = K0 (rho/rho0 - 1)";

  template <Lane V>
  [[nodiscard]] G27_INLINE V pressure(V rho, V /*e*/) const noexcept {
    return (K0 / rho0) * (rho - rho0);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V bulk_modulus(V rho, V /*p*/) const noexcept {
    return (K0 / rho0) * rho;
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V gruneisen(V /*rho*/) const noexcept {
    return V(0.0);
  }
  /// Of the cold compression to rho; p is not read.
  template <Lane V>
  [[nodiscard]] G27_INLINE V energy(V rho, V /*p*/) const noexcept {
    V const v = rho0 / rho;
    return (K0 / rho0) * (v - 1.0 - log(v));
  }
};

}  // namespace g27
