#pragma once
/// Sedov's point explosion in a cold ideal gas of uniform density (Sedov 1959, ch. IV; Landau and Lifshitz, section
/// 106).
///
/// With R = (E t^2/(alpha rho0))^(delta/2), delta = 2/(symmetry + 3), j = symmetry + 1, lambda = ln(r/R):
///   u = delta (r/t) V, rho = rho0 G, p = rho0 delta^2 (r/t)^2 P,   Z = gamma P/G,   q = ln(V - 1/gamma),
/// mass and entropy conservation give
///   G'/G = -(V' + j V)/(V - 1),   P'/P = gamma G'/G + (2/delta - 2 V)/(V - 1),
/// and momentum, with Z (V - 1/gamma) = (gamma - 1) V^2 (1 - V)/2 =: S from the conservation of energy inside r/R,
///   q' = (j S + (V - 1) V (1/delta - V))/((V - 1)^2 (V - 1/gamma) - S).
/// In V itself the inward integration from the strong shock, V = P = 2/(gamma + 1), G = (gamma + 1)/(gamma - 1), is
/// unstable: errors grow as (r/R)^-j.
#include <vector>

#include "riemann/state/gas.hpp"

namespace g27 {

class Sedov {
 public:
  /// symmetry 0, 1, 2; energy E > 0: all of it, on both sides of the plane [J/m^2], per length [J/m] or [J]. Throws
  /// NumericsError for gamma <= 1 or beyond the value where the centre becomes a vacuum (7 when spherical).
  Sedov(double gamma, int symmetry, double energy, double rho0);

  /// E t^2/(rho0 R^(symmetry + 3)) of the whole explosion.
  [[nodiscard]] double alpha() const { return alpha_; }
  [[nodiscard]] double shock_radius(double t) const;
  /// State behind the shock at t > 0.
  [[nodiscard]] GasState<> shocked(double t) const;
  /// State at r >= 0, t > 0; ahead of the shock p = 0.
  [[nodiscard]] GasState<> at(double r, double t) const;
  /// Mean of the conserved densities over [r0, r1], weighted with r^symmetry.
  [[nodiscard]] GasConserved<> average(double r0, double r1, double t) const;
  /// Largest relative gap between P of the conservation of energy and P integrated with the conservation of entropy.
  [[nodiscard]] double residual() const { return residual_; }

 private:
  struct Similarity {
    double q, log_G, log_P;
  };
  [[nodiscard]] Similarity slope(Similarity const& s) const;
  [[nodiscard]] Similarity similarity(double lambda) const;

  double gamma_;
  int symmetry_;
  double energy_, rho0_, delta_;
  double alpha_ = 0, residual_ = 0;
  std::vector<Similarity> nodes_, slopes_;  ///< equidistant in lambda, from the shock inwards
};

}  // namespace g27
