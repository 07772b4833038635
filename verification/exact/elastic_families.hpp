#pragma once
/// Small plane waves along x in a uniformly stressed solid.
///
/// Small changes of velocity and traction s = (sxx, sxy, sxz) about a base state obey u_t = s_x/rho, s_t = M u_x in its
/// frame, where column k of M is the rate of s that u_k,x = 1 causes (`elastic_rate`). A wave of speed c that runs to
/// the right or left carries du parallel to r, M r = rho c^2 r, and ds = -+ rho c du; it strains by u_i,x = -+ du_i/c,
/// which changes everything else.
#include "verification/exact/solid.hpp"

namespace g27 {

class ElasticFamilies {
 public:
  /// Throws NumericsError for a base state whose waves are not real.
  ElasticFamilies(SolidMaterial const& material, SolidPoint const& base);

  [[nodiscard]] SolidPoint const& base() const { return base_; }
  /// c, the fastest (P) first [m/s].
  [[nodiscard]] Vector3 const& speeds() const { return c_; }
  /// r of each family, of length 1, its largest component positive.
  [[nodiscard]] std::array<Vector3, 3> const& vectors() const { return r_; }
  /// Rows of M [Pa].
  [[nodiscard]] std::array<Vector3, 3> const& stiffness() const { return M_; }
  /// Adds to a state what a wave of that family changes whose velocity changes by du r; it runs to the right
  /// (direction 1) or to the left (-1).
  void add(SolidPoint& s, std::size_t family, double du, double direction) const;

 private:
  SolidMaterial material_;
  SolidPoint base_;
  Vector3 c_{};
  std::array<Vector3, 3> r_{}, M_{};
  std::array<SolidPoint, 3> strained_{};  ///< rates of the gradients r e_x^T
};

}  // namespace g27
