#pragma once
/// A small plane wave that meets the bonded face of two stressed solids: the exact linear solution by reflection and
/// transmission. The incoming wave of family k, du = r_k f(x - c_k t), leaves alpha_j f(-c_k (t + x/c_j)) in the
/// families of the left solid and beta_j f(-c_k (t - x/c_j)) in those of the right one; velocity and traction are
/// continuous at x = 0:
///   r_k + sum alpha_j r_j = sum beta_j r'_j,   -z_k r_k + sum alpha_j z_j r_j = -sum beta_j z'_j r'_j,  z = rho c.
#include <functional>

#include "verification/exact/elastic_families.hpp"

namespace g27 {

class BondedWave {
 public:
  /// Both base states have one velocity and one traction on x = const, or NumericsError is thrown. `profile`: f [m/s],
  /// over x. Positions are those of particles in the base state, which rests or moves with the face.
  BondedWave(SolidMaterial const& material_l, SolidPoint const& left, SolidMaterial const& material_r,
             SolidPoint const& right, std::size_t family, std::function<double(double x)> profile);

  [[nodiscard]] ElasticFamilies const& left_families() const { return left_; }
  [[nodiscard]] ElasticFamilies const& right_families() const { return right_; }
  /// alpha and beta.
  [[nodiscard]] Vector3 const& reflected() const { return alpha_; }
  [[nodiscard]] Vector3 const& transmitted() const { return beta_; }
  /// States at x <= 0 of the left solid, at x >= 0 of the right one.
  [[nodiscard]] SolidPoint left(double x, double t) const;
  [[nodiscard]] SolidPoint right(double x, double t) const;

 private:
  ElasticFamilies left_, right_;
  std::size_t family_;
  std::function<double(double)> profile_;
  Vector3 alpha_{}, beta_{};
};

}  // namespace g27
