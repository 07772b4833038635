#include "verification/exact/elastic_riemann.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

Eigen::Vector3d traction(SolidPoint const& s) { return {s.stress(0, 0), s.stress(0, 1), s.stress(0, 2)}; }
Eigen::Vector3d velocity(SolidPoint const& s) { return {s.u[0], s.u[1], s.u[2]}; }

/// Changes that the strain u_i,x = g_i causes in a particle of the base state.
SolidPoint strained(SolidMaterial const& material, SolidPoint const& base, Eigen::Vector3d const& g) {
  double const L[3][3] = {{g[0], 0, 0}, {g[1], 0, 0}, {g[2], 0, 0}};
  return elastic_rate(material, base, L);
}

void add(SolidPoint& s, SolidPoint const& change, Eigen::Vector3d const& du) {
  s.rho += change.rho, s.p += change.p, s.e += change.e;
  for (std::size_t c = 0; c < 6; ++c) s.S[c] += change.S[c];
  for (int i = 0; i < 3; ++i) s.u[static_cast<std::size_t>(i)] += du[i];
}

}  // namespace

ElasticRiemann::ElasticRiemann(SolidMaterial const& material, SolidPoint const& base, SolidPoint const& left,
                               SolidPoint const& right)
    : carrier_(base.u[0]) {
  Eigen::Matrix3d M;
  for (int k = 0; k < 3; ++k) M.col(k) = traction(strained(material, base, Eigen::Vector3d::Unit(k)));
  Eigen::EigenSolver<Eigen::Matrix3d> const eigen(M);
  // real and positive, or the base state has no waves
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return eigen.eigenvalues()[a].real() > eigen.eigenvalues()[b].real(); });
  Eigen::Matrix3d R;
  for (int k = 0; k < 3; ++k) {
    auto const value = eigen.eigenvalues()[order[static_cast<std::size_t>(k)]];
    if (!(value.real() > 0) || std::fabs(value.imag()) > 1e-12 * M.norm())
      throw NumericsError("the base state has no real waves: it needs mu > 0 and a deviator below it");
    c_[static_cast<std::size_t>(k)] = std::sqrt(value.real() / base.rho);
    R.col(k) = eigen.eigenvectors().col(order[static_cast<std::size_t>(k)]).real();
  }
  Eigen::Vector3d const z = base.rho * Eigen::Vector3d(c_[0], c_[1], c_[2]);
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
    for (int j = 0; j < 3; ++j) M_[i][static_cast<std::size_t>(j)] = M(k, j);
  }
  states_[0] = left;
  states_[7] = right;
  for (std::size_t k = 0; k < 3; ++k) {
    auto const col = static_cast<int>(k);
    Eigen::Vector3d const du_l = R.col(col) * amplitude_l[col], du_r = R.col(col) * amplitude_r[col];
    states_[k + 1] = states_[k];
    add(states_[k + 1], strained(material, base, du_l / c_[k]), du_l);
    states_[6 - k] = states_[7 - k];
    add(states_[6 - k], strained(material, base, -du_r / c_[k]), du_r);
  }
  scale_ = z[0] * ((ur - ul).norm() + (sr - sl).norm() / z[0]);
}

std::vector<double> ElasticRiemann::rays() const {
  return {carrier_ - c_[0], carrier_ - c_[1], carrier_ - c_[2], carrier_,
          carrier_ + c_[2], carrier_ + c_[1], carrier_ + c_[0]};
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
