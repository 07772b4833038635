#pragma once
/// An elastic plate between ideal gases that a plane shock meets head on, or that the pressure of one of them drives:
/// exact by the method of characteristics for a plate of constant impedance.
///
/// Waves cross the plate in a time tau each; between their arrivals both faces move at constant speeds. At each face
/// the characteristic that leaves the plate, sigma -+ Z u, meets the gas: at first a shock against a moving wall, then
/// simple waves, p = p_1 (1 -+ (gamma - 1)/2 (u - u_1)/c_1)^(2 gamma/(gamma - 1)). Valid until a wave comes back from
/// the reflected shock; behind the plate to the third order in u/c.
#include <vector>

namespace g27 {

class StruckPlate {
 public:
  struct Gas {
    double gamma = 1.4, rho = 1, p = 1;  ///< at rest, ahead of the shock
  };
  struct Plate {
    double thickness = 1, rho = 1, stiffness = 1;  ///< [m], [kg/m^3], K + 4 mu/3 [Pa]
  };
  /// Gas in front of the plate; `shock_speed` of the shock that brought it there, 0: at rest.
  struct Front {
    double rho, u, p, shock_speed;
  };
  /// Behind a shock into this gas. Throws NumericsError for mach < 1.
  static Front behind_shock(Gas const& gas, double mach);
  /// The plate is at rest until time 0, under the pressure of the gas at its back.
  StruckPlate(Front const& front, Gas const& back, Plate const& plate, double t_end);

  /// Front: 0, back: 1. Displacement [m], velocity [m/s] and pressure of the gas [Pa] there.
  [[nodiscard]] double displacement(int face, double t) const;
  [[nodiscard]] double velocity(int face, double t) const;
  [[nodiscard]] double pressure(int face, double t) const;
  /// Time in which waves cross the plate [s].
  [[nodiscard]] double tau() const { return tau_; }

 private:
  struct Stage {
    double u[2], p[2];
  };
  [[nodiscard]] std::size_t stage(double t) const;
  double tau_ = 0, p0_ = 0;
  std::vector<Stage> stages_;
};

}  // namespace g27
