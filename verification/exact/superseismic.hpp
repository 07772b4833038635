#pragma once
/// A shock in an ideal gas that runs along the surface of an elastic half-space faster than its P waves: steady and
/// self-similar in the frame of its foot (Banks, Henshaw and Schwendeman, J. Comput. Phys. 231 (2012) 3518).
///
/// The gas lies at y > 0, the foot moves along +x at V. The shock leans forward by the angle xi from the normal of the
/// surface, which turns the gas towards the solid by theta, tan(xi + theta) = (rho_2/rho_1) tan xi, into the direction
/// of the surface behind the foot. In the solid a P and an S wave are left behind, plane fronts through the foot with
/// normals n of n_x = c/V, between which all is uniform: linear elasticity, grad u = A n_p n_p^T + B t n_s^T, t across
/// n_s. A and B follow from the traction, -(p_2 - p_1) n, and the surface's slope closes the system:
///   tan theta = u_y,x/(1 + u_x,x).
/// The linear theory leaves open on which normal the stress acts: N of the undeformed surface, sigma N = -P n, or that
/// of the deformed one, sigma n = -P n, with n = (-sin theta, cos theta). Both tend to the same for small theta.
#include <array>

#include "riemann/state/gas.hpp"

namespace g27 {

enum class StressNormal { undeformed, deformed };

struct SuperseismicSetup {
  double gamma = 1.4;
  double gas_density = 1, gas_pressure = 1;      ///< ahead, at rest [kg/m^3], [Pa]
  double solid_density = 1, lambda = 1, mu = 1;  ///< [kg/m^3], [Pa]
  double speed = 1;                              ///< V, of the foot [m/s]
  StressNormal normal = StressNormal::deformed;
};

class Superseismic {
 public:
  using Vector = std::array<double, 2>;
  using Tensor = std::array<Vector, 2>;  ///< rows

  /// Throws NumericsError for a foot slower than P waves in the solid or than sound in the gas, and for a solid so soft
  /// that no shock can turn the gas as far as its surface gives way.
  explicit Superseismic(SuperseismicSetup const& setup);

  /// xi [rad], from the normal of the surface ahead.
  [[nodiscard]] double shock_angle() const { return xi_; }
  /// theta [rad], of the surface behind the foot to that ahead.
  [[nodiscard]] double interface_angle() const { return theta_; }
  /// Angles of the fronts to the surface ahead [rad], asin(c/V).
  [[nodiscard]] double p_wave_angle() const { return p_wave_; }
  [[nodiscard]] double s_wave_angle() const { return s_wave_; }

  struct Gas {
    double rho, p;
    Vector u;
  };
  struct Solid {
    Vector u;             ///< velocity, -V du/dx
    Tensor grad, stress;  ///< of the displacement; over the stress ahead [Pa]; s_zz = lambda tr grad
  };
  /// Behind the shock, in the frame of the solid ahead.
  [[nodiscard]] Gas const& gas_behind() const { return gas_; }
  /// Behind the P wave, and behind the S wave too.
  [[nodiscard]] Solid const& behind_p() const { return behind_p_; }
  [[nodiscard]] Solid const& behind_s() const { return behind_s_; }

  /// Seen from the foot at (x, y): the gas above the surface, the solid below.
  [[nodiscard]] bool in_gas(double x, double y) const;
  [[nodiscard]] Gas gas(double x, double y) const;
  [[nodiscard]] Solid solid(double x, double y) const;
  /// Gap of the normal velocities and of the tractions at the surface, over V and the pressure jump.
  [[nodiscard]] double residual() const;

 private:
  /// In the solid, under the pressure jump P and the surface angle theta.
  void load(double P, double theta);
  /// In the gas: sets its state behind and returns theta.
  double turn(double xi);

  SuperseismicSetup setup_;
  double p_wave_, s_wave_, xi_ = 0, theta_ = 0;
  Gas gas_{};
  Solid behind_p_{}, behind_s_{};
};

}  // namespace g27
