#include "verification/exact/bonded_wave.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/exact/numerics.hpp"

namespace g27 {

BondedWave::BondedWave(SolidMaterial const& material_l, SolidPoint const& left, SolidMaterial const& material_r,
                       SolidPoint const& right, std::size_t family, std::function<double(double x)> profile)
    : left_(material_l, left), right_(material_r, right), family_(family), profile_(std::move(profile)) {
  double const modulus = std::max(left_.stiffness()[0][0], right_.stiffness()[0][0]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(left.u[i] - right.u[i]) > 1e-12 * left_.speeds()[0] ||
        std::fabs(left.stress(0, i) - right.stress(0, i)) > 1e-12 * modulus)
      throw NumericsError("bonded solids have one velocity and one traction");
  }
  // tractions over z_k
  double const z = left.rho * left_.speeds()[family];
  Eigen::Matrix<double, 6, 6> A;
  Eigen::Matrix<double, 6, 1> b;
  for (std::size_t i = 0; i < 3; ++i) {
    auto const row = static_cast<int>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      auto const col = static_cast<int>(j);
      double const r_l = left_.vectors()[j][i], r_r = right_.vectors()[j][i];
      A(row, col) = r_l, A(row, col + 3) = -r_r;
      A(row + 3, col) = left.rho * left_.speeds()[j] / z * r_l;
      A(row + 3, col + 3) = right.rho * right_.speeds()[j] / z * r_r;
    }
    b(row) = -left_.vectors()[family][i], b(row + 3) = left_.vectors()[family][i];
  }
  Eigen::Matrix<double, 6, 1> const x = A.fullPivLu().solve(b);
  for (std::size_t j = 0; j < 3; ++j) alpha_[j] = x[static_cast<int>(j)], beta_[j] = x[static_cast<int>(j) + 3];
}

SolidPoint BondedWave::left(double x, double t) const {
  SolidPoint s = left_.base();
  double const c = left_.speeds()[family_];
  left_.add(s, family_, profile_(x - c * t), 1);
  for (std::size_t j = 0; j < 3; ++j) left_.add(s, j, alpha_[j] * profile_(-c * (t + x / left_.speeds()[j])), -1);
  return s;
}

SolidPoint BondedWave::right(double x, double t) const {
  SolidPoint s = right_.base();
  double const c = left_.speeds()[family_];
  for (std::size_t j = 0; j < 3; ++j) right_.add(s, j, beta_[j] * profile_(-c * (t - x / right_.speeds()[j])), 1);
  return s;
}

}  // namespace g27
