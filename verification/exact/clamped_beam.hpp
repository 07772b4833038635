#pragma once
/// First bending vibration of a beam that is clamped at one end and free at the other, as wide as it stays plane
/// (plane strain).
namespace g27 {

struct ClampedBeam {
  double thickness, length;  ///< [m]
  double density, young, poisson;

  /// Thin: w^2 sqrt(E I/((1 - nu^2) rho A L^4)) with w = 1.8751, cos w cosh w = -1 [rad/s].
  [[nodiscard]] double thin() const;
  /// With shear and rotary inertia (Timoshenko, Phil. Mag. 41 (1921) 744; shear coefficient 5/6) [rad/s].
  [[nodiscard]] double thick() const;
  /// First mode of the thin one at y, 1 at the tip, and its slope [1], [1/m].
  struct Mode {
    double value, slope;
  };
  [[nodiscard]] Mode mode(double y) const;
};

}  // namespace g27
