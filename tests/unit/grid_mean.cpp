/// Cell averages in two and three dimensions against closed forms.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/cases/grid_mean.hpp"

using namespace g27;

namespace {
AnyEos const gas = IdealGas{1.4};
}

TEST_CASE("densities and states convert into one another", "[cases]") {
  GasPoint const s{1.7, {0.3, -0.4, 1.2}, 2.5};
  GasDensities const q = densities_of(gas, s);
  CHECK(q.energy == Approx(2.5 / 0.4 + 0.5 * 1.7 * (0.09 + 0.16 + 1.44)).epsilon(1e-15));
  GasPoint const back = point_of(gas, q);
  CHECK(back.p == Approx(2.5).epsilon(1e-14));
  CHECK(back.u[2] == Approx(1.2).epsilon(1e-15));
}

TEST_CASE("a plane's share of a cell", "[cases]") {
  GasDensities const below{1, {0, 0, 0}, 0}, above{};
  Vec3 const centre{0.3, -0.2, 0.7}, h{0.2, 0.1, 0.3};
  auto share = [&](int dimensions, Vec3 n, double offset) {
    double const norm = std::hypot(n[0], n[1], n[2]);
    for (double& c : n) c /= norm;
    double middle = 0;
    for (int d = 0; d < dimensions; ++d) middle += n[static_cast<std::size_t>(d)] * centre[static_cast<std::size_t>(d)];
    return half_space_mean(dimensions, n, middle + offset / norm, below, above)(centre, h).mass;
  };
  CHECK(share(2, {1, 0, 0}, 0.05) == Approx(0.75).epsilon(1e-14));
  CHECK(share(2, {1, 2, 0}, 0.0) == Approx(0.5).epsilon(1e-14));
  // (x, 2y) spans a square of 0.2; at 0.1 of its middle's diagonal sum an eighth is left above
  CHECK(share(2, {1, 2, 0}, 0.1) == Approx(1 - 0.125).epsilon(1e-3));  // Gauss points and a kink
  // 3D: coordinates scaled to a unit cube, x + y + z < 1/2 of its 3: (1/2)^3/6
  CHECK(share(3, {1 / 0.2, 1 / 0.1, 1 / 0.3}, -1.0) == Approx(0.125 / 6).margin(1e-3));
  CHECK(share(3, {1, 1, 1}, 10.0) == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("plane means equal the point values' means", "[cases]") {
  // polynomial in s, integrated exactly both ways; with drift along the plane
  Vec3 const n{0.6, 0.8, 0}, drift{-0.8 * 0.7, 0.6 * 0.7, 0};
  auto const state = [](double s) { return GasState<>{1 + s * s, 0.5, 2 + s}; };
  CellMean const line = mean_of(gas, Symmetry::planar, state);
  GridMean const by_line = plane_mean(2, n, line, drift);
  GridMean const by_point = mean_of(gas, 2, [&](Vec3 const& x) -> GasPoint {
    GasState<> const s = state(n[0] * x[0] + n[1] * x[1]);
    return {s.rho, {s.u * n[0] + drift[0], s.u * n[1] + drift[1], 0}, s.p};
  });
  GasDensities const a = by_line({0.4, 0.9, 0.5}, {0.3, 0.2, 1}), b = by_point({0.4, 0.9, 0.5}, {0.3, 0.2, 1});
  CHECK(a.mass == Approx(b.mass).epsilon(1e-14));
  CHECK(a.momentum[0] == Approx(b.momentum[0]).epsilon(1e-13));
  CHECK(a.momentum[1] == Approx(b.momentum[1]).epsilon(1e-14));
  CHECK(a.energy == Approx(b.energy).epsilon(1e-14));
}

TEST_CASE("radial means sum to the content of a ball", "[cases]") {
  // density 3 inside r = 0.8, 1 outside, on the unit quadrant and octant
  for (int const dimensions : {2, 3}) {
    GridMean const mean = radial_mean(
        gas, dimensions,
        [](double r) {
          return GasState<>{r < 0.8 ? 3.0 : 1.0, -1.0, 1.0};
        },
        0.8);
    int const n = 16;
    double const h = 1.0 / n;
    double mass = 0, count = 0;
    for (int k = 0; k < (dimensions > 2 ? n : 1); ++k) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i, ++count) {
          mass += mean({(i + 0.5) * h, (j + 0.5) * h, dimensions > 2 ? (k + 0.5) * h : 0.5},
                       {h, h, dimensions > 2 ? h : 1.0})
                      .mass;
        }
      }
    }
    double const ball = dimensions == 2 ? M_PI / 4 * 0.64 : M_PI / 6 * 0.512;
    CHECK(mass / count == Approx(1 + 2 * ball).epsilon(3e-4));
    GasDensities const q = mean({0.3, 0.4, dimensions > 2 ? 0.0 : 0.5}, {1e-6, 1e-6, 1e-6});
    CHECK(q.momentum[0] == Approx(-1.8).epsilon(1e-5));
    CHECK(q.momentum[1] == Approx(-2.4).epsilon(1e-5));
  }
}
