#include "fsi/ale/wall_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fsi/ale/gas_side.hpp"
#include "riemann/contact/gas_solid.hpp"

namespace g27 {

namespace {

/// Pressure of the gas on a wall that stands still; velocities along the normal out of the wall.
double pressure_on_wall(AnyEos const& any, GasTrace const& gas) {
  return std::visit(
      [&](auto const& eos) {
        GasSolidContact const r = gas_wall_contact(eos, GasState<>{gas.rho, -gas.u, gas.p}, 0.0);
        return r.converged ? r.contact.p : std::numeric_limits<double>::quiet_NaN();
      },
      any);
}

}  // namespace

struct WallProblems::Impl {
  GasSide gas;

  void solve(std::span<ModelStencil const> stencils, std::span<Vec3 const> wall, double dt,
             std::span<ModelResult> results, bool first_order) {
    std::array<Vec3, lanes> frame{};
    for (std::size_t lane = 0; lane < lanes; ++lane) frame[lane] = wall[std::min(lane, stencils.size() - 1)];
    gas.load(stencils, frame);
    gas.transverse(dt);
    std::array<double, lanes> pressure{};
    for (std::size_t lane = 0; lane < lanes; ++lane)
      pressure[lane] = pressure_on_wall(gas.eos(), gas.trace(lane, dt, first_order));
    gas.step(dt, pressure, first_order);
    for (std::size_t lane = 0; lane < stencils.size(); ++lane) {
      ModelResult& r = results[lane];
      if (!r.failed) continue;
      bool sound = std::isfinite(pressure[lane]);
      r.pressure = pressure[lane], r.velocity = frame[lane], r.first_order = first_order;
      for (int layer = 0; layer < core_layers; ++layer)
        r.gas[static_cast<std::size_t>(layer)] = gas.state(lane, layer, frame[lane], sound);
      r.failed = !sound;
    }
  }
};

WallProblems::WallProblems(AnyEos const& gas, double width, ModelOptions options)
    : impl_(new Impl{GasSide(gas, width, options)}) {}
WallProblems::~WallProblems() = default;
WallProblems::WallProblems(WallProblems&&) noexcept = default;

void WallProblems::solve(std::span<ModelStencil const> stencils, std::span<Vec3 const> wall, double dt,
                         std::span<ModelResult> results) {
  for (ModelResult& r : results) r.failed = true;
  impl_->solve(stencils, wall, dt, results, false);
  bool const again = std::any_of(results.begin(), results.end(), [](ModelResult const& r) { return r.failed; });
  if (!again) return;
  impl_->solve(stencils, wall, dt, results, true);
  for (std::size_t lane = 0; lane < results.size(); ++lane) {
    ModelResult& r = results[lane];
    if (!r.failed) continue;
    r.pressure = stencils[lane].gas[0][1][1][gas_field::p], r.velocity = wall[lane], r.first_order = true;
    for (std::size_t l = 0; l < core_layers; ++l) r.gas[l] = stencils[lane].gas[l][1][1];
  }
}

}  // namespace g27
