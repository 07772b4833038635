#include "verification/exact/elastic_families.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

SolidPoint strained(SolidMaterial const& material, SolidPoint const& base, Vector3 const& g) {
  double const L[3][3] = {{g[0], 0, 0}, {g[1], 0, 0}, {g[2], 0, 0}};
  return elastic_rate(material, base, L);
}

}  // namespace

ElasticFamilies::ElasticFamilies(SolidMaterial const& material, SolidPoint const& base)
    : material_(material), base_(base) {
  Eigen::Matrix3d M;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 unit{};
    unit[k] = 1;
    SolidPoint const rate = strained(material, base, unit);
    for (std::size_t i = 0; i < 3; ++i) M_[i][k] = M(static_cast<int>(i), static_cast<int>(k)) = rate.stress(0, i);
  }
  Eigen::EigenSolver<Eigen::Matrix3d> const eigen(M);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return eigen.eigenvalues()[a].real() > eigen.eigenvalues()[b].real(); });
  for (std::size_t k = 0; k < 3; ++k) {
    auto const value = eigen.eigenvalues()[order[k]];
    if (!(value.real() > 0) || std::fabs(value.imag()) > 1e-12 * M.norm())
      throw NumericsError("the base state has no real waves: it needs mu > 0 and a deviator below it");
    c_[k] = std::sqrt(value.real() / base.rho);
    Eigen::Vector3d r = eigen.eigenvectors().col(order[k]).real().normalized();
    Eigen::Index largest = 0;
    r.cwiseAbs().maxCoeff(&largest);
    if (r[largest] < 0) r = -r;
    r_[k] = {r[0], r[1], r[2]};
    strained_[k] = strained(material, base, r_[k]);
  }
}

void ElasticFamilies::add(SolidPoint& s, std::size_t family, double du, double direction) const {
  SolidPoint const& rate = strained_[family];
  double const by = -direction * du / c_[family];
  s.rho += by * rate.rho, s.p += by * rate.p, s.e += by * rate.e;
  for (std::size_t c = 0; c < 6; ++c) s.S[c] += by * rate.S[c];
  for (std::size_t i = 0; i < 3; ++i) s.u[i] += du * r_[family][i];
}

}  // namespace g27
