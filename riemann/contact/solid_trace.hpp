#pragma once
/// A solid as a contact meets it: its normal velocity as a function of the pressure on it, from what arrives at its
/// surface along the outgoing characteristics. A rigid wall and a rigid body are the limits of great impedance.
#include <limits>

namespace g27 {

/// v(P) = free_velocity + min(P, P_y)/Z + max(P - P_y, 0)/Z_p for a pressure P that pushes the solid along n: v grows
/// with P. Elastic up to P_y, at the tangent modulus beyond.
struct SolidTrace {
  double free_velocity = 0;  ///< velocity along n of the surface without pressure [m/s]
  double impedance = std::numeric_limits<double>::infinity();          ///< Z = rho a [Pa s/m], > 0
  double yield_pressure = std::numeric_limits<double>::infinity();     ///< P_y [Pa]
  double plastic_impedance = std::numeric_limits<double>::infinity();  ///< Z_p <= Z: Z_p^2 = rho (rho a_p^2)

  [[nodiscard]] double velocity(double P) const noexcept {
    if (P <= yield_pressure) return free_velocity + P / impedance;
    return free_velocity + yield_pressure / impedance + (P - yield_pressure) / plastic_impedance;
  }
  /// dv/dP [m/(s Pa)].
  [[nodiscard]] double compliance(double P) const noexcept {
    return 1.0 / (P <= yield_pressure ? impedance : plastic_impedance);
  }
};

/// A solid whose surface moves at v under the pressure P, both along n.
/// in  impedance Z = rho a [Pa s/m]
[[nodiscard]] inline SolidTrace elastic_trace(double v, double P, double impedance) noexcept {
  return {.free_velocity = v - P / impedance, .impedance = impedance};
}

/// A rigid wall that moves at v, whatever the pressure.
[[nodiscard]] inline SolidTrace rigid_wall_trace(double v) noexcept { return {.free_velocity = v}; }

/// A rigid body in the middle of a step: M dv/dt = A P + F gives v + (dt/2) (P + F/A)/(M/A), the trace of a solid of
/// the impedance 2 (M/A)/dt. in  v at the start of the step [m/s], mass_per_area M/A [kg/m^2], dt [s], force_per_area
/// F/A [Pa]: all else that pushes
[[nodiscard]] inline SolidTrace rigid_body_trace(double v, double mass_per_area, double dt,
                                                 double force_per_area = 0) noexcept {
  double const impedance = 2.0 * mass_per_area / dt;
  return {.free_velocity = v + force_per_area / impedance, .impedance = impedance};
}

}  // namespace g27
