#include "verification/exact/elastic_riemann.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

Eigen::Vector3d traction(SolidPoint const& s) { return {s.stress(0, 0), s.stress(0, 1), s.stress(0, 2)}; }
Eigen::Vector3d velocity(SolidPoint const& s) { return {s.u[0], s.u[1], s.u[2]}; }

}  // namespace

ElasticRiemann::ElasticRiemann(SolidMaterial const& material, SolidPoint const& base, SolidPoint const& left,
                               SolidPoint const& right)
    : families_(material, base) {
  Vector3 const& c = families_.speeds();
  Eigen::Matrix3d R;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) R(i, k) = families_.vectors()[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
  }
  Eigen::Vector3d const z = base.rho * Eigen::Vector3d(c[0], c[1], c[2]);
  auto const lu = R.fullPivLu();
  Eigen::Matrix3d const Z_inverse = R * z.cwiseInverse().asDiagonal() * lu.inverse();
  Eigen::Vector3d const ul = velocity(left), ur = velocity(right), sl = traction(left), sr = traction(right);
  // s* - s_l = Z (u* - u_l) and s* - s_r = -Z (u* - u_r)
  Eigen::Vector3d const us = (ul + ur + Z_inverse * (sr - sl)) / 2;
  Eigen::Vector3d const amplitude_l = lu.solve(us - ul), amplitude_r = lu.solve(us - ur);
  Eigen::Vector3d const ss = sl + R * z.cwiseProduct(amplitude_l);
  for (int k = 0; k < 3; ++k) {
    auto const i = static_cast<std::size_t>(k);
    u_star_[i] = us[k];
    s_star_[i] = ss[k];
  }
  states_[0] = left;
  states_[7] = right;
  for (std::size_t k = 0; k < 3; ++k) {
    auto const col = static_cast<int>(k);
    states_[k + 1] = states_[k], states_[6 - k] = states_[7 - k];
    families_.add(states_[k + 1], k, amplitude_l[col], -1);
    families_.add(states_[6 - k], k, amplitude_r[col], 1);
  }
  scale_ = z[0] * ((ur - ul).norm() + (sr - sl).norm() / z[0]);
}

std::vector<double> ElasticRiemann::rays() const {
  Vector3 const& c = families_.speeds();
  double const u = families_.base().u[0];
  return {u - c[0], u - c[1], u - c[2], u, u + c[2], u + c[1], u + c[0]};
}

SolidPoint ElasticRiemann::at(double xi) const {
  std::size_t i = 0;
  for (double const ray : rays()) i += xi > ray ? 1 : 0;
  return states_[i];
}

double ElasticRiemann::residual() const {
  double worst = 0;
  Eigen::Vector3d const star(s_star_[0], s_star_[1], s_star_[2]);
  for (std::size_t const side : {std::size_t{3}, std::size_t{4}})
    worst = std::max(worst, (traction(states_[side]) - star).norm());
  return scale_ > 0 ? worst / scale_ : 0;
}

}  // namespace g27
