#pragma once
/// The isentrope through one state: pressure, sound speed and Riemann invariant as functions of density.
#include <vector>

#include "verification/exact/eos.hpp"

namespace g27 {

class Isentrope {
 public:
  /// Through (rho [kg/m^3], p [Pa]); throws NumericsError unless rho > 0 and c^2 > 0 there.
  Isentrope(ExactEos eos, double rho, double p);

  [[nodiscard]] ExactEos const& eos() const { return eos_; }
  /// Pressure [Pa] at rho > 0: closed form, but for Mie-Grueneisen in compression the solution of its linear equation
  /// dp/d eta = p_ref' + Gamma0 (p - rho0 e_ref') by quadrature.
  [[nodiscard]] double pressure(double rho) const;
  [[nodiscard]] double sound_speed(double rho) const;
  /// Integral of c/rho d rho from the base state to rho [m/s]; u - invariant is constant through a right-going
  /// simple wave, u + invariant through a left-going one.
  [[nodiscard]] double invariant(double rho) const;
  /// Density at which the pressure is p > lowest_pressure().
  [[nodiscard]] double density(double p) const;
  /// Density at which the invariant is w > vacuum_invariant().
  [[nodiscard]] double density_of_invariant(double w) const;
  /// Limits for rho -> 0.
  [[nodiscard]] double lowest_pressure() const;
  [[nodiscard]] double vacuum_invariant() const;

 private:
  [[nodiscard]] double below(double rho) const;

  ExactEos eos_;
  double rho_, p_;
};

/// The isentrope by the first law alone, de = p d rho/rho^2 (CVODE): an independent path to the closed forms.
struct IsentropePoint {
  double rho, p, c, invariant;
};
/// From (rho, p) to each of `densities`, which must be monotone and lie on one side of rho.
std::vector<IsentropePoint> integrate_isentrope(ExactEos const& eos, double rho, double p,
                                                std::vector<double> const& densities);

}  // namespace g27
