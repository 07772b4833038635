/// The laws and rates of solids that the exact solutions share, against finite differences and identities.
#include "tests/catch.hpp"
#include "verification/exact/solid.hpp"

using namespace g27;

namespace {

template <class F>
double difference(F f, double h) {  // fourth order
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

struct Sample {
  ExactSolidLaw law;
  double rho, p;
};
std::vector<Sample> const samples{{LinearBulkLaw{175, 7.8}, 8.3, 11.22},
                                  {MieGruneisenLaw{2.79, 5.33, 1.34, 2.1}, 3.1, 14},
                                  {MieGruneisenLaw{2.79, 5.33, 1.34, 2.1}, 2.6, -3},
                                  {ConstantGammaLaw{2.79, 5.33, 1.34, 2.1}, 3.1, 14},
                                  {ConstantGammaLaw{2.79, 5.33, 1.34, 2.1}, 2.6, -3},
                                  {StiffenedLaw{3.7, 5}, 2.2, 4},
                                  {IdealLaw{1.3}, 1.7, 0.8},
                                  {JwlLaw{708.6056, 13.16457, 4.94, 1.35, .28, 1.65}, 2.1, 20}};

}  // namespace

TEST_CASE("laws of solids: inverse, bulk modulus and Grueneisen coefficient", "[oracle]") {
  for (auto const& [law, rho, p0] : samples) {
    bool const linear = law.index() == 0;
    double const p = linear ? pressure(law, rho, 0) : p0, e = energy(law, rho, p);
    INFO("law " << law.index() << " rho " << rho);
    CHECK(pressure(law, rho, e) == Approx(p).epsilon(1e-13).margin(1e-13));
    // fourth-order differences over 1e-3 of the value: 1e-12 of the fifth derivative, round-off 1e-13
    double const by_rho = difference([&, r = rho](double d) { return pressure(law, r * (1 + d), e); }, 1e-3) / rho;
    double const by_e = difference([&, r = rho](double d) { return pressure(law, r, e + d); }, 1e-2);
    CHECK(gruneisen(law, rho) == Approx(by_e / rho).epsilon(1e-10).margin(1e-10));
    CHECK(bulk_modulus(law, rho, p) == Approx(rho * by_rho + p * by_e / rho).epsilon(1e-9));
  }
}

TEST_CASE("the linear law's energy lies on its isentrope", "[oracle]") {
  ExactSolidLaw const law = LinearBulkLaw{175, 7.8};
  double const rho = 8.3, slope = difference([&](double d) { return energy(law, rho + d, 0); }, 1e-3);
  CHECK(slope == Approx(pressure(law, rho, 0) / (rho * rho)).epsilon(1e-9));
  CHECK(energy(law, 7.8, 0) == 0);
}

TEST_CASE("elastic rates keep the deviator free of trace and turn with the material", "[oracle]") {
  SolidMaterial const material{MieGruneisenLaw{2.79, 5.33, 1.34, 2}, 27.6};
  SolidPoint s{.rho = 3, .u = {}, .p = 12, .e = energy(material.law, 3, 12), .S = {1.3, -0.4, -0.9, 0.7, -0.2, 0.5}};
  double const L[3][3] = {{0.1, 0.7, -0.3}, {-0.2, 0.4, 0.25}, {0.6, -0.15, -0.35}};
  SolidPoint const rate = elastic_rate(material, s, L);
  CHECK(std::fabs(rate.S[0] + rate.S[1] + rate.S[2]) < 1e-14);
  CHECK(rate.rho == Approx(-s.rho * 0.15).epsilon(1e-14));
  // p(rho, e) along the path
  double const by_path =
      difference([&](double d) { return pressure(material.law, s.rho + d * rate.rho, s.e + d * rate.e); }, 1e-3);
  CHECK(rate.p == Approx(by_path).epsilon(1e-9));
  // S:W-part does no work: the rate of S:S/2 is 2 mu S:D
  double quadratic = 0, loading = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      quadratic += s.S[tensor_place[i][j]] * rate.S[tensor_place[i][j]];
      loading += 2 * material.mu * s.S[tensor_place[i][j]] * L[i][j];
    }
  }
  CHECK(quadratic == Approx(loading).epsilon(1e-13));
  // rotation alone
  double const W[3][3] = {{0, -0.8, 0.3}, {0.8, 0, -0.5}, {-0.3, 0.5, 0}};
  SolidPoint const turning = elastic_rate(material, s, W);
  CHECK(std::fabs(turning.p) < 1e-15);  // W S - S W does no work: round-off
  double const angle = 1e-3;
  double R[3][3];
  auto rotated = [&](double a) {  // exp(a W) by its series
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        double w2 = 0, w3 = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          w2 += W[i][k] * W[k][j];
          for (std::size_t l = 0; l < 3; ++l) w3 += W[i][k] * W[k][l] * W[l][j];
        }
        R[i][j] = (i == j ? 1 : 0) + a * W[i][j] + a * a / 2 * w2 + a * a * a / 6 * w3;
      }
    }
    return turned(R, s.S);
  };
  for (std::size_t c = 0; c < 6; ++c)
    CHECK(turning.S[c] == Approx(difference([&](double a) { return rotated(a)[c]; }, angle)).margin(1e-9));
}

TEST_CASE("averages of solids are exact for polynomials, across breaks and along axes without width", "[oracle]") {
  // rho = 2: momentum 2 u, energy 2 e + u^2, rho S and rho ep linear in what is averaged
  auto state = [](Vector3 const& x) {
    SolidPoint s;
    s.rho = 2;
    s.u = {x[0] * x[0] * x[1], x[2], 1};
    s.S = {x[1] * x[1] * x[1], 0, 0, x[0] * x[2], 0, 0};
    s.ep = x[0];
    return s;
  };
  Vector3 const centre{0.5, 1, 3}, widths{1, 2, 0};
  SolidDensities const mean = solid_average(state, centre, widths);
  CHECK(mean.mass == Approx(2).epsilon(1e-14));
  CHECK(mean.momentum[0] == Approx(2 * (1. / 3) * 1).epsilon(1e-14));
  CHECK(mean.momentum[1] == Approx(2 * 3).epsilon(1e-14));
  CHECK(mean.energy == Approx((1. / 5) * (4. / 3) + 9 + 1).epsilon(1e-14));
  CHECK(mean.rho_S[0] == Approx(2 * 2).epsilon(1e-14));
  CHECK(mean.rho_S[3] == Approx(2 * 0.5 * 3).epsilon(1e-14));
  CHECK(mean.rho_ep == Approx(2 * 0.5).epsilon(1e-14));
  std::vector<double> const breaks{-1, 0.25, 7};
  auto step = [&](double x) { return state({x < 0.25 ? 1.0 : 3.0, 1, 0}); };
  CHECK(solid_average(step, 0, 1, breaks).momentum[0] == Approx(2 * (0.25 * 1 + 0.75 * 9)).epsilon(1e-14));
}
