#pragma once
/// Exact solution of the Riemann problem between any two laws: shocks by the Hugoniot relation, rarefactions by the
/// isentrope and its Riemann invariant, a vacuum where the two fans do not meet (Toro, 3rd ed., ch. 4; Menikoff and
/// Plohr 1989). Valid for convex isentropes.
#include <string>
#include <vector>

#include "riemann/state/gas.hpp"
#include "verification/exact/isentrope.hpp"

namespace g27 {

class GasRiemann {
 public:
  /// Jump at x = 0, t = 0. Throws NumericsError for states outside their laws.
  GasRiemann(ExactEos const& eos_l, GasState<> const& left, ExactEos const& eos_r, GasState<> const& right);

  [[nodiscard]] double p_star() const { return p_star_; }
  /// Contact speed; in a vacuum the mean speed of its two fronts.
  [[nodiscard]] double u_star() const { return (side_[0].u_star + side_[1].u_star) / 2; }
  [[nodiscard]] double rho_star_l() const { return side_[0].rho_star; }
  [[nodiscard]] double rho_star_r() const { return side_[1].rho_star; }
  [[nodiscard]] bool vacuum() const { return vacuum_; }
  /// "shock" or "rarefaction"
  [[nodiscard]] std::string wave_l() const { return side_[0].shock ? "shock" : "rarefaction"; }
  [[nodiscard]] std::string wave_r() const { return side_[1].shock ? "shock" : "rarefaction"; }
  /// As "rarefaction-contact-shock" or "rarefaction-vacuum-rarefaction".
  [[nodiscard]] std::string pattern() const;
  /// Speeds of all wave edges from left to right [m/s]: one a shock, two a fan, one the contact, two a vacuum.
  [[nodiscard]] std::vector<double> speeds() const;

  /// State on the ray x/t = xi; density 0 in a vacuum.
  [[nodiscard]] GasState<> at(double xi) const;
  /// Conserved densities on the ray x/t = xi.
  [[nodiscard]] GasConserved<> conserved(double xi) const;
  /// Mean of the conserved densities over [x0, x1] at t >= 0. Exact: in a self-similar solution U is the derivative of
  /// xi U - F(U) by xi, across shocks as well, so no quadrature is needed.
  [[nodiscard]] GasConserved<> average(double x0, double x1, double t) const;

 private:
  /// One side, seen so that its wave runs to the left (the right side is mirrored).
  struct Side {
    Isentrope isentrope;
    GasState<> state;
    double u_star = 0, rho_star = 0;
    bool shock = false;
    double head = 0, tail = 0;  ///< speeds in the laboratory frame; equal for a shock
  };
  struct Ray {
    int region;  ///< 0 left, 1 left wave, 2 left star, 3 vacuum, 4 right star, 5 right wave, 6 right
    GasState<> state;
    ExactEos const* eos;
  };
  [[nodiscard]] Ray ray(double xi) const;
  [[nodiscard]] GasState<> in_fan(int side, double xi) const;
  /// xi U - F(U)
  [[nodiscard]] GasConserved<> antiderivative(Ray const& r, double xi) const;
  void finish(int side, double p);

  Side side_[2];
  double p_star_ = 0;
  bool vacuum_ = false;
};

/// Density behind a shock of pressure p > state.p; throws NumericsError beyond the law's limit.
double shock_density(ExactEos const& eos, GasState<> const& state, double p);

}  // namespace g27
