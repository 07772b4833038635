#pragma once
/// Nonlinear simple wave before it breaks: an exact smooth solution of the Euler equations for any convex law.
///
/// One Riemann invariant and the entropy are constant, the other invariant rides on straight characteristics (Courant
/// and Friedrichs 1948, section 40; Landau and Lifshitz, section 101).
#include <vector>

#include "riemann/state/gas.hpp"
#include "verification/exact/isentrope.hpp"
#include "verification/exact/numerics.hpp"

namespace g27 {

enum class Running { right, left };

class SimpleWave {
 public:
  /// u(x, 0) = base.u + perturbation(x) with |perturbation| <= amplitude [m/s]; rho and p follow from the isentrope
  /// through `base`. Throws NumericsError for a base state outside the law, or an amplitude that reaches a vacuum.
  SimpleWave(ExactEos const& eos, GasState<> const& base, ScalarFunction perturbation, double amplitude,
             Running running = Running::right);

  /// State at (x [m], t [s]), 0 <= t < breaking_time; exact to about 1e-13 of each variable's range.
  [[nodiscard]] GasState<> at(double x, double t) const;
  /// Mean of the conserved densities over [x0, x1].
  [[nodiscard]] GasConserved<> average(double x0, double x1, double t) const;
  /// First time at which characteristics that start in [x0, x1] cross [s]; infinite where they diverge. Central
  /// differences between `samples` points: good to about 1/samples^2.
  [[nodiscard]] double breaking_time(double x0, double x1, int samples = 10000) const;

  /// Speed of the characteristic that carries the velocity perturbation w.
  [[nodiscard]] double characteristic_speed(double w) const;
  /// State where the velocity perturbation is w.
  [[nodiscard]] GasState<> state_of(double w) const;

 private:
  [[nodiscard]] double density(double w) const;

  Isentrope isentrope_;
  GasState<> base_;
  ScalarFunction perturbation_;
  double amplitude_, sign_;  ///< sign: +1 running right
  /// Density and its slope by w, at equidistant w in [-amplitude, amplitude].
  std::vector<double> rho_, slope_;
};

}  // namespace g27
