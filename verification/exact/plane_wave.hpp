#pragma once
/// Plane simple waves of finite amplitude in elastoplastic solids, in any direction and with any stress ahead.
///
/// A wave of one family that runs along n leaves the states of a curve U(w), w the length of the change of velocity:
///   du/dw = r, M r = rho c^2 r, |r| = 1, M e_k = rate of the traction on n that the gradient e_k n^T causes;
///   dU/dw = -(rate that r n^T causes)/c, for density, energy, pressure, deviator and plastic strain.
/// Every value of w travels with its own speed n.u + c: w(s, t) = w0(s - speed(w) t), s = n.x, until the wave breaks
/// (Courant and Friedrichs (1948), section 40, for a system of eleven equations). With `plastic` the curve starts on
/// the yield surface and all material loads: the rates are those of plastic flow.
#include <array>
#include <functional>
#include <vector>

#include "verification/exact/solid.hpp"

namespace g27 {

/// As `elastic_rate`, of material that loads plastically:
///   dS -= S 3 mu (S:D)/(q^2 (1 + H/(3 mu))),  d ep = 3 mu (S:D)/(q (3 mu + H)),  q^2 = (3/2) S:S.
SolidPoint plastic_rate(SolidMaterial const& material, SolidPoint const& s, double const (&L)[3][3]);

class PlaneWave {
 public:
  /// `profile`: w at t = 0 over s = n.x; its values lie within [low, high], which contains 0, the value of `ahead`.
  /// family 0: P, 1 and 2: S by falling speed; all run along +n. Throws NumericsError where speeds are not real.
  PlaneWave(SolidMaterial const& material, SolidPoint const& ahead, Vector3 const& n, int family, double low,
            double high, std::function<double(double s)> profile, bool plastic = false);

  /// State of the curve.
  [[nodiscard]] SolidPoint state(double w) const;
  /// n.u + c [m/s].
  [[nodiscard]] double speed(double w) const;
  /// Velocity c relative to the material ahead [m/s].
  [[nodiscard]] double celerity() const { return celerity_; }
  /// w at (s, t), before the wave breaks.
  [[nodiscard]] double at(double s, double t) const;
  [[nodiscard]] SolidPoint state_at(Vector3 const& x, double t) const;

 private:
  using Row = std::array<double, 14>;  ///< rho u p e S ep speed
  [[nodiscard]] Row row(double w) const;

  Vector3 n_;
  double low_, high_, step_, celerity_ = 0;
  double slowest_ = 0, fastest_ = 0;
  std::vector<Row> nodes_, slopes_;
  std::function<double(double)> profile_;
};

/// w(s, t) at one time, tabulated over [s0, s1]: for the averages of many cells. Cubic Hermite interpolation with
/// slopes of fourth order.
class PlaneWaveAt {
 public:
  PlaneWaveAt(PlaneWave const& wave, double s0, double s1, double t, int nodes = 4096);
  [[nodiscard]] double operator()(double s) const;

 private:
  double s0_, step_;
  std::vector<double> w_;  ///< [nodes], two more on either side
};

}  // namespace g27
