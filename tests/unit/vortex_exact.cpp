/// The isentropic vortex against the Euler equations, and against an independent form of its momentum balance.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/exact/vortex.hpp"

using namespace g27;

namespace {

template <class F>
double difference(F f, double h) {  // fourth order
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

Vortex const vortex{
    .gamma = 1.3, .rho0 = 1.2, .p0 = 0.9, .u0 = 0.4, .v0 = -0.7, .x0 = 0.3, .y0 = -0.2, .radius = 1.7, .strength = 0.6};

}  // namespace

TEST_CASE("the vortex satisfies the Euler equations", "[oracle]") {
  double const t = 0.6, h = 1e-3;
  for (double const x : {-1.1, 0.2, 1.9}) {
    for (double const y : {-2.3, -0.6, 0.8}) {
      auto d = [&](auto field, double ex, double ey, double et) {
        return difference([&](double s) { return field(vortex.at(x + s * ex, y + s * ey, t + s * et)); }, h);
      };
      auto rho = [](PlaneState const& s) { return s.rho; };
      auto u = [](PlaneState const& s) { return s.u; };
      auto v = [](PlaneState const& s) { return s.v; };
      auto p = [](PlaneState const& s) { return s.p; };
      PlaneState const s = vortex.at(x, y, t);
      auto material = [&](auto field) { return d(field, 0, 0, 1) + s.u * d(field, 1, 0, 0) + s.v * d(field, 0, 1, 0); };
      double const divergence = d(u, 1, 0, 0) + d(v, 0, 1, 0);
      // fourth-order differences of fields of order one over a length of order one: h^4 and round-off over h
      double const tolerance = 1e-10;
      CHECK(std::fabs(material(rho) + s.rho * divergence) < tolerance);
      CHECK(std::fabs(material(u) + d(p, 1, 0, 0) / s.rho) < tolerance);
      CHECK(std::fabs(material(v) + d(p, 0, 1, 0) / s.rho) < tolerance);
      CHECK(std::fabs(material(p) + vortex.gamma * s.p * divergence) < tolerance);
    }
  }
}

TEST_CASE("the vortex turns fastest at its radius and is isentropic", "[oracle]") {
  double const t = 2, cx = vortex.x0 + vortex.u0 * t, cy = vortex.y0 + vortex.v0 * t;
  auto speed = [&](double r) {
    PlaneState const s = vortex.at(cx + r * 0.6, cy + r * 0.8, t);
    return std::hypot(s.u - vortex.u0, s.v - vortex.v0);
  };
  CHECK(speed(vortex.radius) == Approx(vortex.strength).epsilon(1e-14));
  CHECK(speed(0.95 * vortex.radius) < vortex.strength);
  CHECK(speed(1.05 * vortex.radius) < vortex.strength);
  PlaneState const s = vortex.at(cx + 0.5, cy, t), far = vortex.at(cx + 40, cy, t);
  CHECK(s.v > vortex.v0);  // counter-clockwise
  CHECK(s.p / std::pow(s.rho, vortex.gamma) == Approx(vortex.p0 / std::pow(vortex.rho0, vortex.gamma)).epsilon(1e-14));
  CHECK(far.rho == Approx(vortex.rho0).epsilon(1e-15));
  CHECK(far.p == Approx(vortex.p0).epsilon(1e-15));
}
