/// The collapsing shell: launch speeds in closed form, energy balance by two routes, motion.
#include "tests/catch.hpp"
#include "verification/exact/be_shell.hpp"

using namespace g27;

TEST_CASE("launch speeds without hardening have a closed form", "[oracle]") {
  // int ln((R^n + s)/(a^n + s)) ds over the volume: x ln x - x at its ends
  for (int const symmetry : {1, 2}) {
    double const R = 0.7, R1 = 1.1, rho = 1.9, Y = 0.04;
    Shell const shell{.symmetry = symmetry, .inner = R, .outer = R1, .rho = rho, .yield = Y, .hardening = 0};
    int const n = symmetry + 1;
    auto primitive = [](double x) { return x * std::log(x); };  // the terms -x cancel between the two logarithms
    for (double const stop : {0.6, 0.35, 0.1}) {
      double const a = std::pow(stop, n), start = std::pow(R, n), volume = std::pow(R1, n) - start;
      double const logs = primitive(start + volume) - primitive(start) - primitive(a + volume) + primitive(a);
      double const k = symmetry == 2 ? 2 : 2 / std::sqrt(3.0);
      double const work = Y * k / (n * n) * logs, field = symmetry == 2 ? 1 / R - 1 / R1 : std::log(R1 / R);
      CHECK(shell.launch_speed(stop) ==
            Approx(std::sqrt(2 * work / (rho * std::pow(R, 2 * symmetry) * field))).epsilon(1e-12));
    }
  }
}

TEST_CASE("the commonly quoted speeds of the spherical shell rest on a volume that is too large", "[oracle]") {
  // u0 = sqrt(4 Y R1 F/(3 rho (R1 - R0))), F = int_lambda^1 x^2 ln(1 + q/x^3) dx, q = (R1/R0)^3 - 1 = 3 a + 3 a^2 +
  // a^3, a = R1/R0 - 1. With q = 3 (a + a^2 + a^3) the same formula gives .068105, .062565, .055064 and .045304 cm/us
  // for stops at 3, 4, 5 and 6 cm.
  Shell const sphere{.symmetry = 2, .inner = 8, .outer = 10, .rho = 1.845, .yield = .0033, .hardening = 0};
  double const a = 0.25, right = 3 * a + 3 * a * a + a * a * a, wrong = 3 * (a + a * a + a * a * a);
  auto speed = [](double stop, double q) {
    double sum = 0;
    int const n = 2000;  // Simpson's rule
    double const lambda = stop / 8, h = (1 - lambda) / n;
    for (int i = 0; i <= n; ++i) {
      double const x = lambda + h * i;
      sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * x * x * std::log(1 + q / (x * x * x));
    }
    return std::sqrt(4 * .0033 * 10 * sum * h / 3 / (3 * 1.845 * 2));
  };
  for (auto const& [stop, quoted] : {std::pair{3.0, .068105}, {4.0, .062565}, {5.0, .055064}, {6.0, .045304}}) {
    CHECK(speed(stop, wrong) == Approx(quoted).epsilon(1e-5));
    CHECK(sphere.launch_speed(stop) == Approx(speed(stop, right)).epsilon(1e-10));
    CHECK(sphere.stop_radius(sphere.launch_speed(stop)) == Approx(stop).epsilon(1e-12));
  }
  CHECK(sphere.stop_radius(.062565) == Approx(4.0).margin(.1));  // still within the usual allowance
}

TEST_CASE("plastic work by particles is that of the force on the wall", "[oracle]") {
  for (int const symmetry : {1, 2}) {
    for (double const hardening : {0.0, 0.02}) {
      Shell const shell{.symmetry = symmetry, .inner = 1, .outer = 1.4, .rho = 2, .yield = .03, .hardening = hardening};
      for (double const stop : {0.9, 0.5, 0.2}) {
        CHECK(shell.residual(stop) < 1e-11);
        CHECK(shell.plastic_work(stop) == Approx(shell.kinetic_energy(1, shell.launch_speed(stop))).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("the time to stop follows from the equation of motion", "[oracle]") {
  // a'' from the energy balance, integrated by fourth-order Runge-Kutta steps
  Shell const shell{.symmetry = 2, .inner = 1, .outer = 1.4, .rho = 2, .yield = .03, .hardening = 0.01};
  double const u0 = shell.launch_speed(0.6), end = shell.stop_time(u0);
  auto acceleration = [&](double a, double v) {  // d/dt (m(a) v^2/2 + W(a)) = 0
    double const h = 1e-4;
    auto d = [&](auto f) { return (8 * (f(a + h) - f(a - h)) - (f(a + 2 * h) - f(a - 2 * h))) / (12 * h); };
    double const m = 2 * shell.kinetic_energy(a, 1), dm = d([&](double x) { return 2 * shell.kinetic_energy(x, 1); }),
                 dW = d([&](double x) { return shell.plastic_work(x); });
    return -(dm * v * v / 2 + dW) / m;
  };
  double a = 1, v = -u0;
  int const steps = 100;
  double const dt = end / steps;
  for (int i = 0; i < steps; ++i) {
    double const k1 = acceleration(a, v), k2 = acceleration(a + dt / 2 * v, v + dt / 2 * k1);
    double const k3 = acceleration(a + dt / 2 * (v + dt / 2 * k1), v + dt / 2 * k2);
    double const k4 = acceleration(a + dt * (v + dt / 2 * k2), v + dt * k3);
    a += dt * v + dt * dt / 6 * (k1 + k2 + k3);
    v += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  CHECK(a == Approx(0.6).epsilon(1e-8));
  CHECK(std::fabs(v) < 1e-7 * u0);
}

TEST_CASE("a shell that closes its cavity is refused", "[oracle]") {
  Shell const shell{.symmetry = 2, .inner = 1, .outer = 1.4, .rho = 2, .yield = .03, .hardening = 0};
  CHECK_THROWS(shell.stop_radius(1.1 * shell.launch_speed(0.01)));
}
