#pragma once
/// Exact contact between a gas and an elastoplastic solid at rest beside each other at t = 0: the gas against a wall
/// that moves as fast as the waves of uniaxial strain let the solid's surface move under the pressure on that wall.
///
/// Gas against a moving wall is the Riemann problem with its own mirror image (Toro, 3rd ed., 6.3.3): GasRiemann, on
/// the left; solid: AxialWaves, on the right, or a solid of constant impedance, v = u + (P - sigma)/(rho a). The gas
/// may leave the solid behind it: the contact's pressure is then the lowest that its law allows.
#include <optional>

#include "verification/exact/axial_waves.hpp"
#include "verification/exact/gas_riemann.hpp"

namespace g27 {

enum class SolidModel { linear, waves };

class GasSolid {
 public:
  /// Contact at x = 0, t = 0. The solid's normal stress is solid.p - solid.S[0]. `linear`: of constant impedance, in
  /// which density and stress change by du/a. Throws NumericsError for states outside their laws.
  GasSolid(ExactEos const& eos, GasState<> const& gas, SolidMaterial const& material, SolidPoint const& solid,
           SolidModel model = SolidModel::waves);

  [[nodiscard]] double p_star() const { return p_star_; }
  /// Velocity of the solid's surface.
  [[nodiscard]] double u_star() const { return u_star_; }
  /// The gas's front lies behind the surface.
  [[nodiscard]] bool vacuum() const { return vacuum_; }
  /// Left of the surface: the gas, of density 0 in a vacuum.
  [[nodiscard]] GasRiemann const& gas() const { return *gas_; }
  /// The solid beside the contact.
  [[nodiscard]] SolidPoint solid_star() const;
  /// The solid on the ray x/t = xi, on the right of the surface.
  [[nodiscard]] SolidPoint solid_at(double xi) const;
  /// Speeds of the waves in the solid, in increasing order.
  [[nodiscard]] std::vector<double> solid_speeds() const;
  /// As "elastic shock, plastic shock".
  [[nodiscard]] std::string solid_pattern() const;
  /// Gap of the jump conditions in the solid, and of the pressures beside the contact over the larger stress.
  [[nodiscard]] double residual() const;

 private:
  [[nodiscard]] double surface_velocity(double sigma) const;
  [[nodiscard]] GasRiemann against_wall(double u) const;

  ExactEos eos_;
  GasState<> state_;
  SolidMaterial material_;
  SolidPoint ahead_;
  SolidModel model_;
  double a_ = 0;
  double p_star_ = 0, u_star_ = 0;
  bool vacuum_ = false;
  std::optional<GasRiemann> gas_;
  std::optional<AxialWaves> waves_;
};

}  // namespace g27
