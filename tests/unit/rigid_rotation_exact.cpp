/// A rigidly rotating stressed body against the nonlinear equations of hypoelastic solids.
#include "tests/catch.hpp"
#include "verification/exact/rigid_rotation.hpp"

using namespace g27;

namespace {

RigidRotation body(ExactSolidLaw const& law, double rho, double p) {
  return {.law = law,
          .rho = rho,
          .p = p,
          .S = {1.3, -0.4, -0.9, 0.7, -0.2, 0.5},
          .axis = {0.3, -0.5, 1.1},
          .rate = 1.7,
          .centre = {0.2, 0.1, -0.3},
          .drift = {0.4, -0.2, 0.6}};
}
std::vector<RigidRotation> const bodies{body(LinearBulkLaw{175, 7.8}, 7.9, 0),
                                        body(MieGruneisenLaw{2.785, 5.328, 1.338, 2}, 2.9, 6),
                                        body(StiffenedLaw{3.1, 5}, 2, 1)};

}  // namespace

TEST_CASE("rigid rotation satisfies the equations of motion", "[oracle]") {
  for (RigidRotation const& b : bodies) {
    INFO("law " << b.law.index());
    SolidMaterial const material{b.law, 27.6};
    Vector3 const x{0.5, -0.4, 0.3};
    double const t = 0.8, h = 1e-3;
    auto d = [&](auto field, std::size_t axis) {
      auto f = [&](double s) {
        Vector3 y = x;
        if (axis < 3) y[axis] += s;
        return field(b.at(y, axis < 3 ? t : t + s));
      };
      return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
    };
    SolidPoint const s = b.at(x, t);
    auto material_rate = [&](auto field) {
      double sum = d(field, 3);
      for (std::size_t a = 0; a < 3; ++a) sum += s.u[a] * d(field, a);
      return sum;
    };
    double L[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) L[i][j] = d([i](SolidPoint const& q) { return q.u[i]; }, j);
    SolidPoint const rate = elastic_rate(material, s, L);
    double const tolerance = 1e-9;  // fourth-order differences of fields of order ten
    for (std::size_t i = 0; i < 3; ++i) {
      double force = 0;
      for (std::size_t j = 0; j < 3; ++j) force += d([&](SolidPoint const& q) { return q.stress(i, j); }, j);
      CHECK(std::fabs(s.rho * material_rate([i](SolidPoint const& q) { return q.u[i]; }) - force) < tolerance);
    }
    CHECK(std::fabs(material_rate([](SolidPoint const& q) { return q.rho; }) - rate.rho) < tolerance);
    CHECK(std::fabs(material_rate([](SolidPoint const& q) { return q.e; }) - rate.e) < tolerance);
    CHECK(std::fabs(material_rate([](SolidPoint const& q) { return q.p; }) - rate.p) < tolerance);
    for (std::size_t c = 0; c < 6; ++c)
      CHECK(std::fabs(material_rate([c](SolidPoint const& q) { return q.S[c]; }) - rate.S[c]) < tolerance);
    CHECK(s.p == Approx(pressure(b.law, s.rho, s.e)).epsilon(1e-13));
  }
}

TEST_CASE("the invariants of the deviator stay, and a whole turn brings it back", "[oracle]") {
  RigidRotation const& b = bodies[0];
  auto invariants = [](Tensor6 const& S) {
    double second = 0, third = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        second += S[tensor_place[i][j]] * S[tensor_place[i][j]];
        for (std::size_t k = 0; k < 3; ++k)
          third += S[tensor_place[i][j]] * S[tensor_place[j][k]] * S[tensor_place[k][i]];
      }
    }
    return std::pair{second, third};
  };
  Vector3 const x{0.5, -0.4, 0.3};
  auto const [second, third] = invariants(b.S);
  auto const [second_later, third_later] = invariants(b.at(x, 1.234).S);
  CHECK(second_later == Approx(second).epsilon(1e-13));
  CHECK(third_later == Approx(third).epsilon(1e-13));
  double const period = 2 * M_PI / b.rate;
  for (std::size_t c = 0; c < 6; ++c) {
    CHECK(b.at(x, period).S[c] == Approx(b.S[c]).margin(1e-13));
    CHECK(std::fabs(b.at(x, period / 2).S[c] - b.S[c]) > 1e-3);
  }
}

TEST_CASE("particles keep their density and move with the velocity", "[oracle]") {
  for (RigidRotation const& b : bodies) {
    Vector3 const start{0.7, 0.2, -0.6};
    double const t = 0.9, h = 1e-3;
    Vector3 const now = b.moved(start, t);
    CHECK(b.at(now, t).rho == Approx(b.at(start, 0).rho).epsilon(1e-13));
    CHECK(b.at(now, t).p == Approx(b.at(start, 0).p).epsilon(1e-13));
    for (std::size_t i = 0; i < 3; ++i) {
      double const speed = (8 * (b.moved(start, t + h)[i] - b.moved(start, t - h)[i]) -
                            (b.moved(start, t + 2 * h)[i] - b.moved(start, t - 2 * h)[i])) /
                           (12 * h);
      CHECK(speed == Approx(b.at(now, t).u[i]).margin(1e-10));
    }
  }
}

TEST_CASE("a quarter turn about z exchanges the axes", "[oracle]") {
  RigidRotation b{.law = LinearBulkLaw{}, .rho = 7800, .S = {1, 2, -3, 0.5, 0.25, -0.125}, .rate = M_PI / 2};
  Tensor6 const S = b.at({0.1, 0, 0}, 1).S;
  // x -> y, y -> -x
  Tensor6 const expected{2, 1, -3, -0.5, 0.125, 0.25};
  for (std::size_t c = 0; c < 6; ++c) CHECK(S[c] == Approx(expected[c]).margin(1e-14));
}
