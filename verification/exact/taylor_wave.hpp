#pragma once
/// Taylor-Zeldovich wave: the self-similar flow of products behind a Chapman-Jouguet detonation that started at r = 0
/// at t = 0 (Taylor, Proc. R. Soc. A 200 (1950) 235; Zeldovich and Kompaneets 1960).
///
/// With xi = r/t and n = 0, 1, 2 for planar, cylindrical, spherical symmetry, u as the independent variable makes the
/// equations regular at the Chapman-Jouguet point, where d xi/du = 0 and du/d xi is infinite:
///   d xi/du = xi ((xi - u)^2/c^2 - 1)/(n u),   d rho/du = rho (xi - u)/c^2;   planar: xi = u + c.
/// At the rest core u -> 0 they are integrated in ln u: xi approaches the core's sound speed as u ln u when spherical,
/// as u otherwise.
#include <utility>
#include <vector>

#include "riemann/state/gas.hpp"
#include "verification/exact/chapman_jouguet.hpp"
#include "verification/exact/isentrope.hpp"

namespace g27 {

class TaylorWave {
 public:
  /// symmetry: 0 planar (rest wall at r = 0), 1 cylindrical, 2 spherical. Throws NumericsError.
  TaylorWave(ExactEos const& products, ChapmanJouguet const& front, int symmetry);

  [[nodiscard]] ChapmanJouguet const& front() const { return front_; }
  /// r/(D t) of the rest core's edge, and the state inside it.
  [[nodiscard]] double core() const { return xi_.back() / front_.D; }
  [[nodiscard]] GasState<> core_state() const { return {rho_.back(), 0, isentrope_.pressure(rho_.back())}; }
  /// State at r/(D t) in [0, 1]; beyond the front, the explosive at rest with p = 0.
  [[nodiscard]] GasState<> at(double r_over_dt) const;
  /// r/(D t) at which the velocity is u, 0 < u <= u_CJ.
  [[nodiscard]] double position(double u) const;
  /// State where the velocity is u. Near the front at(position(u)) has half the digits: there u falls as a square root.
  [[nodiscard]] GasState<> state_of(double u) const;
  /// Mean of the conserved densities over [r0, r1] at t, weighted with r^symmetry. Beyond the front: density rho0 and
  /// the energy E0 per volume, at rest.
  [[nodiscard]] GasConserved<> average(double r0, double r1, double t) const;

 private:
  [[nodiscard]] double xi_slope(double log_u, double xi, double rho) const;
  [[nodiscard]] double rho_slope(double log_u, double xi, double rho) const;
  /// Node below u and the fraction of the way to the next.
  [[nodiscard]] std::pair<std::size_t, double> place(double u) const;
  /// xi (and rho) between the nodes i and i + 1, at the fraction s of their distance in ln u.
  [[nodiscard]] double xi_between(std::size_t i, double s) const;
  [[nodiscard]] double rho_between(std::size_t i, double s) const;

  ChapmanJouguet front_;
  Isentrope isentrope_;
  int symmetry_;
  /// Along ln u, equidistant, from the front to the core.
  double log_u0_ = 0, step_ = 0;
  std::vector<double> xi_, rho_, xi_slope_, rho_slope_;
};

}  // namespace g27
