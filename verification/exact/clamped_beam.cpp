#include "verification/exact/clamped_beam.hpp"

#include <array>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

double root() {
  static double const w = find_root([](double x) { return std::cos(x) * std::cosh(x) + 1; }, 1.8, 2.0);
  return w;
}

}  // namespace

double ClampedBeam::thin() const {
  double const plane = young / (1 - poisson * poisson);
  return root() * root() / (length * length) * std::sqrt(plane * thickness * thickness / (12 * density));
}

double ClampedBeam::thick() const {
  // deflection, rotation, moment and shear force per width along the beam, by Runge-Kutta from the clamp
  using State = std::array<double, 4>;
  double const A = thickness, I = A * thickness * thickness / 12, bending = young / (1 - poisson * poisson) * I;
  double const shear = 5.0 / 6 * 0.5 * young / (1 + poisson) * A;
  auto const tip = [&](State s, double w) {
    auto const slope = [&](State const& q) {
      return State{q[1] + q[3] / shear, q[2] / bending, -q[3] - density * I * w * w * q[1],
                   -density * A * w * w * q[0]};
    };
    auto const go = [](State const& q, double d, State const& k) {
      State out = q;
      for (std::size_t i = 0; i < 4; ++i) out[i] += d * k[i];
      return out;
    };
    constexpr int steps = 200;
    double const d = length / steps;
    for (int n = 0; n < steps; ++n) {
      State const a = slope(s), b = slope(go(s, d / 2, a)), c = slope(go(s, d / 2, b)), e = slope(go(s, d, c));
      for (std::size_t i = 0; i < 4; ++i) s[i] += d / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
    }
    return s;
  };
  auto const free_end = [&](double w) {
    State const m = tip({0, 0, bending / length, 0}, w), v = tip({0, 0, 0, bending / (length * length)}, w);
    return (m[2] * v[3] - m[3] * v[2]) / (bending * bending);
  };
  return find_root(free_end, 0.5 * thin(), 1.01 * thin());
}

ClampedBeam::Mode ClampedBeam::mode(double y) const {
  double const k = root() / length, a = k * y, w = root();
  double const s = (std::sinh(w) - std::sin(w)) / (std::cosh(w) + std::cos(w));
  return {0.5 * (std::cosh(a) - std::cos(a) - s * (std::sinh(a) - std::sin(a))),
          0.5 * k * (std::sinh(a) + std::sin(a) - s * (std::cosh(a) - std::cos(a)))};
}

}  // namespace g27
