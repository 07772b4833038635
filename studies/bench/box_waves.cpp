#include "studies/bench/box_waves.hpp"

#include <cmath>
#include <numbers>

namespace g27 {

namespace {

double wave(Vec3 const& x) { return 0.01 * std::sin(2.0 * std::numbers::pi * (x[0] + x[1] + 2.0 * x[2])); }

}  // namespace

GasGrid gas_wave(AnyEos const& eos, GasState<> const& base, int cells, Predictor predictor, RiemannSolver riemann,
                 int threads) {
  GasGridSetup setup{.eos = eos, .cells = {cells, cells, cells}};
  for (GridBoundary& b : setup.sides) b.kind = GridBoundary::Kind::periodic;
  setup.options.predictor = predictor, setup.options.riemann = riemann, setup.options.threads = threads;
  GasGrid grid(std::move(setup));
  double const K = std::visit([&](auto const& e) { return e.bulk_modulus(base.rho, base.p); }, eos);
  double const c = std::sqrt(K / base.rho);
  grid.set_state(
      [&](Vec3 const& x) {
        double const w = wave(x);
        return GasPoint{base.rho * (1.0 + w), {0.3 * c * (1.0 + w), 0.2 * c, 0.1 * c}, base.p + K * w};
      },
      1);
  return grid;
}

SolidGrid solid_wave(AnySolid const& material, double rho, int cells, Predictor predictor, int threads) {
  SolidGridSetup setup{.material = material, .cells = {cells, cells, cells}};
  for (SolidBoundary& b : setup.sides) b.kind = SolidBoundary::Kind::periodic;
  setup.options.predictor = predictor, setup.options.threads = threads;
  SolidGrid grid(std::move(setup));
  double const K = std::visit([&](auto const& e) { return e.bulk_modulus(rho, 0.0); }, material.eos);
  double const c = std::sqrt(K / rho);
  // uniaxial: S11 = -2/3 Y; its surface is reached where the material has a yield stress
  double const Y = material.plastic() ? material.Y0 : 1e-3 * K;
  Sym3 const S{-2.0 / 3.0 * Y, Y / 3.0, Y / 3.0, 0, 0, 0};
  grid.set_state(
      [&](Vec3 const& x) {
        double const w = wave(x);
        return SolidPoint{.rho = rho * (1.0 + w), .u = {c * (0.1 + w), 0.05 * c, 0.02 * c}, .p = K * w, .S = S};
      },
      1);
  return grid;
}

}  // namespace g27
