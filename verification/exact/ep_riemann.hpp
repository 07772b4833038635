#pragma once
/// Riemann problem of uniaxial strain between two elastoplastic solids, bonded at the contact, or between a solid and a
/// fluid (mu = 0): the stress at which the waves of both sides leave one velocity.
#include "verification/exact/axial_waves.hpp"

namespace g27 {

class EpRiemann {
 public:
  /// Jump at x = 0, t = 0. Throws NumericsError for states outside their laws and for a contact that opens a vacuum.
  EpRiemann(SolidMaterial const& material_l, SolidPoint const& left, SolidMaterial const& material_r,
            SolidPoint const& right);

  /// Compressive stress p - Sxx at the contact.
  [[nodiscard]] double sigma_star() const { return sigma_star_; }
  [[nodiscard]] double u_star() const { return u_star_; }
  [[nodiscard]] AxialWaves const& left() const { return left_; }
  [[nodiscard]] AxialWaves const& right() const { return right_; }
  /// Speeds where the state jumps or bends, the contact's among them, in increasing order.
  [[nodiscard]] std::vector<double> speeds() const;
  /// State on the ray x/t = xi.
  [[nodiscard]] SolidPoint at(double xi) const;
  /// Mean over [x0, x1] at t >= 0.
  [[nodiscard]] SolidDensities average(double x0, double x1, double t) const;
  /// That of the waves, and the gap of the velocities at the contact over the larger sound speed.
  [[nodiscard]] double residual() const;

 private:
  SolidPoint initial_l_, initial_r_;
  double sigma_star_;
  AxialWaves left_, right_;
  double u_star_;
};

}  // namespace g27
