/// The linear elastic Riemann problem against closed forms, the equations and conservation.
#include "tests/catch.hpp"
#include "verification/exact/elastic_riemann.hpp"

using namespace g27;

namespace {

SolidMaterial const steel{LinearBulkLaw{175, 7.8}, 80.77};
SolidMaterial const aluminium{MieGruneisenLaw{2.785, 5.328, 1.338, 2}, 27.6};

SolidPoint base_state(SolidMaterial const& material, double rho, double p, Tensor6 const& S, Vector3 const& u) {
  double const of_density = pressure(material.law, rho, 0);
  bool const linear = std::holds_alternative<LinearBulkLaw>(material.law);
  SolidPoint s{.rho = rho, .u = u, .p = linear ? of_density : p, .e = 0, .S = S};
  s.e = energy(material.law, s.rho, s.p);
  return s;
}

SolidPoint changed(SolidPoint s, double size) {
  s.rho += size * 0.3;
  s.p += size * 7;
  s.u = {s.u[0] + size, s.u[1] - 0.7 * size, s.u[2] + 0.4 * size};
  Tensor6 const d{3, -1, -2, 5, -4, 2};
  for (std::size_t c = 0; c < 6; ++c) s.S[c] += size * d[c];
  return s;
}

}  // namespace

TEST_CASE("wave speeds and coupling in a stressed solid", "[oracle]") {
  Tensor6 const S{5, -4, -1, 3, 2, 1.5};
  for (auto const& [material, rho, p] : {std::tuple{steel, 8.0, 0.0}, {aluminium, 2.9, 6.0}}) {
    SolidPoint const base = base_state(material, rho, p, S, {0.4, 0, 0});
    ElasticRiemann const solution(material, base, changed(base, 1e-3), base);
    double const mu = material.mu, f = gruneisen(material.law, rho), K = bulk_modulus(material.law, rho, base.p);
    // rho a^2 = K + (4/3) mu - f S11; rho beta^2 = mu + (3/4) S11 +- (1/2) sqrt((S22 - S33)^2/4 + S23^2)
    double const split = std::sqrt(std::pow(S[1] - S[2], 2) / 4 + S[5] * S[5]) / 2;
    CHECK(rho * std::pow(solution.speeds()[0], 2) == Approx(K + 4. / 3 * mu - f * S[0]).epsilon(1e-13));
    CHECK(rho * std::pow(solution.speeds()[1], 2) == Approx(mu + 0.75 * S[0] + split).epsilon(1e-13));
    CHECK(rho * std::pow(solution.speeds()[2], 2) == Approx(mu + 0.75 * S[0] - split).epsilon(1e-13));
    double const M[3][3] = {{K + 4. / 3 * mu - f * S[0], -(1 + f) * S[3], -(1 + f) * S[4]},
                            {0, mu + (S[0] - S[1]) / 2, -S[5] / 2},
                            {0, -S[5] / 2, mu + (S[0] - S[2]) / 2}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) CHECK(solution.stiffness()[i][j] == Approx(M[i][j]).margin(1e-12));
    CHECK(solution.residual() < 1e-12);
  }
}

TEST_CASE("without pre-stress P and S waves are acoustic and apart", "[oracle]") {
  SolidPoint const base = base_state(steel, 7.8, 0, {}, {});
  SolidPoint left = base, right = base;
  left.u = {0.02, 0.03, -0.01};
  right.S = {0.4, -0.3, -0.1, 0.2, 0.5, 0};
  ElasticRiemann const solution(steel, base, left, right);
  double const zp = std::sqrt(7.8 * (175 + 4. / 3 * 80.77)), zs = std::sqrt(7.8 * 80.77);
  // u* = (u_l + u_r)/2 + (s_r - s_l)/(2 z), s* = (s_l + s_r)/2 + z (u_r - u_l)/2 for each polarisation
  CHECK(solution.u_star()[0] == Approx(0.01 + 0.4 / (2 * zp)).epsilon(1e-13));
  CHECK(solution.u_star()[1] == Approx(0.015 + 0.2 / (2 * zs)).epsilon(1e-13));
  CHECK(solution.u_star()[2] == Approx(-0.005 + 0.5 / (2 * zs)).epsilon(1e-13));
  CHECK(solution.traction_star()[0] == Approx(0.2 - zp * 0.01).epsilon(1e-13));
  CHECK(solution.traction_star()[1] == Approx(0.1 - zs * 0.015).epsilon(1e-13));
  CHECK(solution.traction_star()[2] == Approx(0.25 + zs * 0.005).epsilon(1e-13));
  // between the P and the S wave on the right: no shear yet
  double const c = zp / 7.8, b = zs / 7.8;
  SolidPoint const s = solution.at((c + b) / 2);
  CHECK(s.u[0] == Approx(solution.u_star()[0]).epsilon(1e-13));
  CHECK(std::fabs(s.u[1]) < 1e-15);
  CHECK(s.S[3] == Approx(0.2).epsilon(1e-13));
  CHECK(s.rho - 7.8 == Approx(7.8 * (solution.u_star()[0]) / c).epsilon(1e-10));  // strain u/c of 1e-3
}

TEST_CASE("every wave satisfies the linear jump conditions", "[oracle]") {
  for (auto const& [material, rho, p] : {std::tuple{steel, 8.0, 0.0}, {aluminium, 2.9, 6.0}}) {
    SolidPoint const base = base_state(material, rho, p, {5, -4, -1, 3, 2, 1.5}, {0.4, 0.1, 0});
    ElasticRiemann const solution(material, base, changed(base, 1e-3), changed(base, -2e-3));
    std::vector<double> const rays = solution.rays();
    REQUIRE(std::is_sorted(rays.begin(), rays.end()));
    for (std::size_t k = 0; k < rays.size(); ++k) {
      INFO("wave " << k);
      SolidPoint const a = solution.at(rays[k] - 1e-9), b = solution.at(rays[k] + 1e-9);
      double const D = rays[k] - base.u[0];
      double const mass = rho * (b.u[0] - a.u[0]) - D * (b.rho - a.rho);
      if (k != 3) CHECK(std::fabs(mass) < 1e-13 * rho);
      for (std::size_t i = 0; i < 3; ++i) {
        double const du = b.u[i] - a.u[i], ds = b.stress(0, i) - a.stress(0, i);
        CHECK(std::fabs(rho * D * du + ds) < 1e-12);  // of stresses of order one
        if (k == 3) CHECK(std::fabs(du) < 1e-14);
      }
      if (k == 3) continue;
      // [q] D = -dq/dL: what the strain -[u]/D does to a particle
      double const L[3][3] = {
          {-(b.u[0] - a.u[0]) / D, 0, 0}, {-(b.u[1] - a.u[1]) / D, 0, 0}, {-(b.u[2] - a.u[2]) / D, 0, 0}};
      SolidPoint const rate = elastic_rate(material, base, L);
      CHECK(b.p - a.p == Approx(rate.p).margin(1e-12));
      for (std::size_t c = 0; c < 6; ++c) CHECK(b.S[c] - a.S[c] == Approx(rate.S[c]).margin(1e-12));
    }
    // the sides are untouched
    CHECK(solution.at(rays.front() - 1).S == changed(base, 1e-3).S);
    CHECK(solution.at(rays.back() + 1).u == changed(base, -2e-3).u);
  }
}

TEST_CASE("the star state turns with the plane across the wave", "[oracle]") {
  // y and z exchanged
  auto exchanged = [](SolidPoint s) {
    std::swap(s.u[1], s.u[2]);
    std::swap(s.S[1], s.S[2]);
    std::swap(s.S[3], s.S[4]);
    return s;
  };
  SolidPoint const base = base_state(aluminium, 2.9, 6, {5, -4, -1, 3, 2, 1.5}, {0.4, 0.1, 0});
  ElasticRiemann const a(aluminium, base, changed(base, 1e-3), base);
  ElasticRiemann const b(aluminium, exchanged(base), exchanged(changed(base, 1e-3)), exchanged(base));
  CHECK(a.u_star()[0] == Approx(b.u_star()[0]).epsilon(1e-12));
  CHECK(a.u_star()[1] == Approx(b.u_star()[2]).margin(1e-13));
  CHECK(a.traction_star()[2] == Approx(b.traction_star()[1]).epsilon(1e-12));
}

TEST_CASE("a base state without real waves is refused", "[oracle]") {
  SolidPoint const base = base_state(steel, 7.8, 0, {-120, 60, 60, 0, 0, 0}, {});  // mu + (3/4) S11 < 0
  CHECK_THROWS(ElasticRiemann(steel, base, base, base));
}
