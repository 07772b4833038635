#pragma once
/// Blake's problem: a pressure P that acts from t = 0 on inside a spherical cavity of radius a, in an infinite linear
/// elastic solid at rest (Blake, J. Acoust. Soc. Am. 24 (1952) 211; Sharpe, Geophysics 7 (1942) 144).
///
/// The displacement is the gradient of F(tau)/r, tau = t - (r - a)/c, c^2 = (lambda + 2 mu)/rho, and
/// sigma_rr = rho F''/r + 4 mu (F'/(c r^2) + F/r^3) = -P at r = a makes F a damped oscillation,
///   F = -(P a^3/(4 mu)) [1 - exp(-b tau) (cos w tau + (b/w) sin w tau)],  b = 2 mu/(rho a c),  w^2 = 4 mu/(rho a^2) -
///   b^2.
namespace g27 {

struct Blake {
  double lambda = 25e9, mu = 25e9, rho = 3000, radius = 0.1, pressure = 1e6;

  struct Point {
    double displacement, velocity;  ///< radial
    double strain_rr, strain_tt;
    double stress_rr, stress_tt;  ///< radial and hoop
  };
  /// r >= radius: zero ahead of the front r = radius + c t. At r < radius the state of the wall.
  [[nodiscard]] Point at(double r, double t) const;
  [[nodiscard]] double sound_speed() const;
  [[nodiscard]] double front(double t) const;
  /// Displacement of the wall after the wave has gone: P a/(4 mu).
  [[nodiscard]] double static_displacement() const;
};

}  // namespace g27
