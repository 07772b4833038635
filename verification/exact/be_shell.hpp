#pragma once
/// Collapse of an incompressible, rigid-plastic shell, cylindrical (plane strain) or spherical, that is thrown inwards
/// with u = -u0 (R_i/r)^j, j = 1 or 2, and stops when its kinetic energy has gone into plastic work (Verney 1968;
/// Howell and Ball, J. Comput. Phys. 175 (2002) 128).
///
/// Volume keeps r^(j+1) - r0^(j+1) one number a^(j+1) - R_i^(j+1), so that the equivalent plastic strain of a particle
/// is k ln(r0/r), k = 2 (spherical) or 2/sqrt 3, and, w = 4 pi or 2 pi,
///   T(a, a') = (rho/2) a'^2 a^(2j) w int_a^b r^-j dr,   W(a) = w int (Y + H e/2) e r0^j dr0,
///   dW/da = -w k a^j int_a^b (Y + H e) dr/r.
namespace g27 {

struct Shell {
  int symmetry = 2;  ///< j
  double inner = 0.08, outer = 0.10, rho = 1845;
  double yield = 330e6, hardening = 0;

  /// Kinetic energy [J, or J/m] when the inner wall is at a and moves with `speed`.
  [[nodiscard]] double kinetic_energy(double a, double speed) const;
  /// Plastic work [J, or J/m] done until the inner wall is at a, 0 < a <= inner.
  [[nodiscard]] double plastic_work(double a) const;
  [[nodiscard]] double outer_radius(double a) const;
  /// Radius at which the inner wall stops; throws NumericsError if the cavity closes to 1 %.
  [[nodiscard]] double stop_radius(double u0) const;
  /// The u0 that stops at `radius` < inner.
  [[nodiscard]] double launch_speed(double radius) const;
  /// Time from launch to stop.
  [[nodiscard]] double stop_time(double u0) const;
  /// Gap between the plastic work by particles and by the force on the wall, relative, when the wall is at a.
  [[nodiscard]] double residual(double a) const;

 private:
  [[nodiscard]] double retarding_force(double a) const;  ///< -dW/da
  [[nodiscard]] double work_between(double a0, double a1) const;
};

}  // namespace g27
