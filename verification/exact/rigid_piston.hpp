#pragma once
/// A rigid piston of finite mass between two ideal gases at rest: the higher pressure accelerates it, each gas holds a
/// simple wave that the piston sends into it.
///
/// At the piston p = p0 (1 -+ (gamma - 1)/2 v/c0)^(2 gamma/(gamma - 1)), minus behind it, plus ahead; M/A dv/dt is the
/// difference. Against a vacuum v = 2 c0/(gamma - 1) (1 - (1 + (gamma + 1) p0 t/(2 c0 M/A))^(-(gamma - 1)/(gamma +
/// 1))). Exact until the compression ahead breaks (Courant and Friedrichs, Supersonic Flow and Shock Waves (1948),
/// sections 40 and 42).
#include <vector>

#include "riemann/state/gas.hpp"

namespace g27 {

class RigidPiston {
 public:
  struct Gas {
    double gamma = 1.4, rho = 1, p = 1;  ///< p = 0 ahead: a vacuum
  };
  struct Setup {
    Gas behind, ahead{.p = 0};
    double mass_per_area = 1;  ///< [kg/m^2]
    double t_end = 1;          ///< [s]
  };
  /// At rest at time 0. Throws NumericsError for a gas behind that does not push.
  explicit RigidPiston(Setup const& setup);

  /// Way [m], velocity [m/s] and pressures [Pa] at 0 <= t <= t_end: to about 1e-12.
  [[nodiscard]] double position(double t) const { return at(t, 0); }
  [[nodiscard]] double velocity(double t) const { return at(t, 1); }
  [[nodiscard]] double pressure_behind(double t) const;
  [[nodiscard]] double pressure_ahead(double t) const;
  /// The gas at (x, t), of which the piston, as thin as a point, is behind or ahead; t before the wave ahead breaks.
  [[nodiscard]] GasState<> behind(double x, double t) const;
  [[nodiscard]] GasState<> ahead(double x, double t) const;
  /// When the compression ahead becomes a shock [s]; infinite against a vacuum.
  [[nodiscard]] double breaking_time() const;

 private:
  [[nodiscard]] double acceleration(double v) const;
  [[nodiscard]] double at(double t, int component) const;
  [[nodiscard]] GasState<> beside(Gas const& gas, double side, double x, double t) const;

  Setup setup_;
  std::vector<std::vector<double>> path_;  ///< way and velocity at equal intervals
};

}  // namespace g27
