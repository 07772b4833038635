#pragma once
/// Smooth motion of gas and an elastic solid that share a contact, both nonlinear, both periodic in time.
///
/// The contact moves at V(t) = V sin(2 pi t/T). From it a simple wave runs into the solid, which lies on the right in
/// uniaxial strain: hypoelastic, p = K (rho/rho0 - 1), Sxx = -(4/3) mu ln(rho/rho0); its stress gives the contact's
/// pressure P(t). Velocity and pressure there are Cauchy data for the gas on the left, since both of its families cross
/// the contact: in the mass coordinate m, u_m = v_t and p_m = -u_t on the isentrope, marched away from the contact.
/// Fourier collocation in t, CVODE in m: exact to round-off as long as no wave breaks.
/// (Courant and Friedrichs 1948, sections 40 and 18; Trefethen, Spectral Methods in MATLAB (2000), ch. 3.)
#include <vector>

#include "riemann/state/gas.hpp"
#include "verification/exact/isentrope.hpp"
#include "verification/exact/solid.hpp"

namespace g27 {

struct ElasticPistonSetup {
  ExactEos eos = IdealLaw{1.4};
  GasState<> gas{1.0, 0.0, 1.0 / 1.4};  ///< at V = 0, beside the contact
  LinearBulkLaw law{.K = 2.5, .rho0 = 2.0};
  double mu = 1.5;
  double velocity = 0.03, period = 1;  ///< V, T
  double depth = 0.7;                  ///< mass of gas per area, as far as it is known [kg/m^2]
};

class ElasticPiston {
 public:
  /// Throws NumericsError where a wave breaks in the gas before `depth`.
  explicit ElasticPiston(ElasticPistonSetup const& setup);

  /// The contact.
  [[nodiscard]] double position(double t) const;
  [[nodiscard]] double velocity(double t) const;
  [[nodiscard]] double pressure(double t) const;

  /// The gas at one time.
  class Profile {
   public:
    /// Left of the contact, not beyond the depth; continued smoothly a little further on both ends.
    [[nodiscard]] GasState<> at(double x) const;
    [[nodiscard]] double leftmost() const { return x_.back(); }

   private:
    friend class ElasticPiston;
    Isentrope const* isentrope_ = nullptr;
    std::vector<double> x_, rho_, u_, rho_slope_, u_slope_;  ///< from the contact to the depth; slopes by m
    double step_ = 0;                                        ///< of m
  };
  [[nodiscard]] Profile gas(double t) const;
  /// Largest share of the highest quarter of the harmonics in time, over the amplitude: what the truncation may leave.
  [[nodiscard]] double truncation() const { return truncation_; }

  /// The solid, right of the contact; continued smoothly a little to its left.
  [[nodiscard]] SolidPoint solid(double x, double t) const;
  /// The particle that is at (x, t), by its distance from the contact where the solid bears the gas at V = 0.
  [[nodiscard]] double particle(double x, double t) const;
  [[nodiscard]] double particle_velocity(double label, double t) const;

 private:
  struct Emission {
    double time, w;  ///< when the characteristic left the contact, and the velocity it carries
  };
  [[nodiscard]] double density(double w) const;
  [[nodiscard]] double sound_speed(double rho) const;
  [[nodiscard]] double stress(double rho) const;  ///< p - Sxx
  [[nodiscard]] Emission emission(double x, double t) const;
  void march();

  ElasticPistonSetup setup_;
  Isentrope isentrope_;
  double rho_base_;                ///< of the solid under the pressure of the gas at V = 0
  std::vector<double> rho_;        ///< of the solid at equidistant w in [-V, V]
  std::vector<double> rho_slope_;  ///< by w
  /// [mass node][time node]
  std::vector<std::vector<double>> x_node_, rho_node_, u_node_, rho_rate_, u_rate_;
  double truncation_ = 0;
};

}  // namespace g27
