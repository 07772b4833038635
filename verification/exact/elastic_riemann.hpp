#pragma once
/// Riemann problem of linear elasticity in a uniformly stressed and moving solid: P and S waves with their coupling by
/// the pre-stress (elastic_families.hpp), and what rides with the material.
#include <vector>

#include "verification/exact/elastic_families.hpp"

namespace g27 {

class ElasticRiemann {
 public:
  /// Coefficients of `base`; left and right differ little from it in any variable. Jump at x = 0, t = 0. Throws
  /// NumericsError for a base state whose waves are not real.
  ElasticRiemann(SolidMaterial const& material, SolidPoint const& base, SolidPoint const& left,
                 SolidPoint const& right);

  /// Wave speeds in the frame of the base state, the fastest (P) first.
  [[nodiscard]] Vector3 const& speeds() const { return families_.speeds(); }
  /// Rows of M.
  [[nodiscard]] std::array<Vector3, 3> const& stiffness() const { return families_.stiffness(); }
  /// At the contact: velocity and traction of both sides.
  [[nodiscard]] Vector3 const& u_star() const { return u_star_; }
  [[nodiscard]] Vector3 const& traction_star() const { return s_star_; }
  /// State on the ray x/t = xi.
  [[nodiscard]] SolidPoint at(double xi) const;
  /// Speeds at which the state jumps, in increasing order: six waves and the contact.
  [[nodiscard]] std::vector<double> rays() const;
  /// Gap between the tractions that the states beside the contact have and the one that the waves agree on, over rho
  /// c_P times the jump.
  [[nodiscard]] double residual() const;

 private:
  ElasticFamilies families_;
  Vector3 u_star_{}, s_star_{};
  std::array<SolidPoint, 8> states_{};  ///< between the rays, from left to right
  double scale_ = 0;
};

}  // namespace g27
