#pragma once
/// Standing waves of free bodies in linear elasticity: natural frequencies and fields of a bar (uniaxial strain), a
/// disc (plane strain) and a sphere (Love, A Treatise on the Mathematical Theory of Elasticity, 4th ed., ch. XII).
///
/// Displacements are U(x) sin(w t), with k_L = w/c_L and k_T = w/c_T:
///   bar      U = cos(k_L x) along x on [0, R], k_L R = m pi;
///   disc     U = grad phi + rot psi of phi = A J_n(k_L r) cos(n theta), psi = B J_n(k_T r) sin(n theta); n = 0: B = 0;
///   sphere   U = grad j_0(k_L r) (radial, n = 0), or U = (x cross grad) [j_n(k_T r) P_n(cos theta)] (torsional,
///            n >= 1);
/// and the traction on the surface vanishes, which gives the frequencies.
#include <vector>

#include "verification/exact/solid.hpp"

namespace g27 {

enum class FreeBody { bar, disc, sphere };

/// A solid of linear elasticity.
struct ElasticSolid {
  double rho = 7800, lambda = 121.15e9, mu = 80.77e9;
  [[nodiscard]] double longitudinal_speed() const;
  [[nodiscard]] double transverse_speed() const;
};

class FreeVibration {
 public:
  /// Mode `mode` >= 1 of the modes of order n in increasing frequency; `size`: length of the bar or radius; `speed`:
  /// the largest velocity on the surface. The order of a bar is 0. Throws NumericsError for an order above 10 or a mode
  /// above 50.
  FreeVibration(FreeBody body, ElasticSolid const& solid, double size, int order, int mode, double speed = 1);

  /// Angular frequency [rad/s].
  [[nodiscard]] double frequency() const { return frequency_; }
  /// k_T size.
  [[nodiscard]] double wave_number() const;
  /// Displacement at the largest excursion, and its gradient dU_i/dx_j.
  struct Shape {
    Vector3 U{};
    double gradient[3][3] = {};
  };
  [[nodiscard]] Shape shape(Vector3 const& x) const;
  [[nodiscard]] Vector3 displacement(Vector3 const& x, double t) const;
  /// rho, u, p and S to first order; bars lie along x in [0, size], discs and spheres around the origin. e is the
  /// energy of strain. Outside, the fields continue analytically.
  [[nodiscard]] SolidPoint at(Vector3 const& x, double t) const;
  /// Largest traction on the surface over the largest stress inside, from the Cartesian fields.
  [[nodiscard]] double residual() const;
  /// Gap between the frequency and Rayleigh's quotient sqrt(int 2 W / int rho U^2), relative: quadrature.
  [[nodiscard]] double rayleigh_gap() const;

 private:
  [[nodiscard]] Shape unscaled(Vector3 const& x) const;
  FreeBody body_;
  ElasticSolid solid_;
  double size_;
  int order_;
  double frequency_ = 0, k_l_ = 0, k_t_ = 0;
  double A_ = 1, B_ = 0, scale_ = 1;
};

}  // namespace g27
