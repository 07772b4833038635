#pragma once
/// Steady isentropic vortex of an ideal gas, carried by a uniform flow: an exact smooth solution of the Euler equations
/// in the plane (Yee, Sandham and Djomehri, J. Comput. Phys. 150 (1999) 199; Shu 1998).
///
/// Speed around the centre v = strength (r/a) exp((1 - (r/a)^2)/2), largest at r = a. The momentum balance
/// dp/dr = rho v^2/r of an isentropic gas is d(c^2)/dr = (gamma - 1) v^2/r, hence
/// c^2 = c0^2 - (gamma - 1)/2 strength^2 exp(1 - (r/a)^2).
namespace g27 {

struct PlaneState {
  double rho, u, v, p;  ///< density [kg/m^3], velocity [m/s], pressure [Pa]
};

struct Vortex {
  double gamma = 1.4;
  double rho0 = 1, p0 = 1 / 1.4;      ///< far away
  double u0 = 0, v0 = 0;              ///< velocity that carries it [m/s]
  double x0 = 0, y0 = 0, radius = 1;  ///< centre at t = 0, radius of the largest speed [m]
  double strength = 0.5;              ///< largest speed around the centre [m/s]

  /// State at (x, y, t). A vacuum opens in the centre, and density and pressure are NaN, unless
  /// (gamma - 1)/2 e strength^2 < c0^2.
  [[nodiscard]] PlaneState at(double x, double y, double t) const;
};

}  // namespace g27
