#include "fsi/ale/model_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fsi/ale/gas_side.hpp"
#include "fsi/ale/solid_side.hpp"
#include "fsi/ale/wall_side.hpp"
#include "riemann/contact/gas_solid.hpp"

namespace g27 {

namespace {

constexpr int most_responses = 4;         ///< evaluations of the solid's side of the contact
constexpr double velocity_close = 1e-12;  ///< of the solid's sound speed, at which the contact is found

/// Pressure at which the gas meets a solid that moves with speed - pressure/impedance; velocities along the normal out
/// of the solid.
double meet(AnyEos const& any, GasTrace const& gas, double speed, double impedance) {
  SolidTrace const solid{.free_velocity = -speed, .impedance = impedance};
  return std::visit(
      [&](auto const& eos) {
        GasSolidContact const r = gas_solid_contact(eos, GasState<>{gas.rho, -gas.u, gas.p}, solid);
        return r.converged ? r.contact.p : std::numeric_limits<double>::quiet_NaN();
      },
      any);
}

}  // namespace

struct ModelProblems::Impl {
  virtual ~Impl() = default;
  virtual void solve(std::span<ModelStencil const> stencils, double dt, std::span<ModelResult> results,
                     bool first_order) = 0;
};

/// Solid: SolidSide, or WallSide.
template <class Solid>
struct ModelProblems::Against final : Impl {
  GasSide gas;
  Solid solid;

  template <class... Of>
  Against(AnyEos const& eos, double width, ModelOptions const& options, Of const&... of)
      : gas(eos, width, options), solid{of...} {}

  void solve(std::span<ModelStencil const> stencils, double dt, std::span<ModelResult> results,
             bool first_order) override {
    std::array<Vec3, lanes> frame{};
    for (std::size_t lane = 0; lane < lanes; ++lane)
      frame[lane] = stencils[std::min(lane, stencils.size() - 1)].velocity;
    gas.load(stencils, frame), solid.load(stencils, frame);
    gas.transverse(dt), solid.transverse(dt);

    std::array<double, lanes> pressure{};
    std::array<Vec3, lanes> velocity{};
    contact(dt, first_order, pressure, velocity);
    gas.shift(velocity), solid.shift(velocity);
    for (std::size_t lane = 0; lane < lanes; ++lane) frame[lane] = frame[lane] + velocity[lane];

    gas.transverse(dt), solid.transverse(dt);
    solid.set_ghosts();
    gas.step(dt, pressure, first_order), solid.step(dt, pressure, first_order);
    auto const take = [&](auto const& side, std::size_t lane, auto& states) {
      bool sound = true;
      for (int layer = 0; layer < core_layers; ++layer)
        states[static_cast<std::size_t>(layer)] = side.state(lane, layer, frame[lane], sound);
      return sound;
    };
    std::array<bool, lanes> gas_failed{};
    for (std::size_t lane = 0; lane < stencils.size(); ++lane) {
      ModelResult& r = results[lane];
      if (!r.failed) continue;
      bool sound = std::isfinite(pressure[lane]);
      for (double v : frame[lane]) sound = sound && std::isfinite(v);
      r.pressure = pressure[lane], r.velocity = frame[lane], r.first_order = first_order;
      sound = take(solid, lane, r.solid) && sound;
      bool const sound_gas = take(gas, lane, r.gas);
      r.failed = !sound || !sound_gas, gas_failed[lane] = sound && !sound_gas;
    }
    if (first_order || std::none_of(gas_failed.begin(), gas_failed.end(), [](bool f) { return f; })) return;
    gas.step(dt, pressure, true);  // the solid keeps what the same pressure gave it
    for (std::size_t lane = 0; lane < stencils.size(); ++lane) {
      if (!gas_failed[lane]) continue;
      results[lane].first_order = true, results[lane].failed = !take(gas, lane, results[lane].gas);
    }
  }

  /// The solid's velocity as it depends on the pressure is what its boundary gives: linear while it is elastic.
  void contact(double dt, bool first_order, std::array<double, lanes>& pressure, std::array<Vec3, lanes>& velocity) {
    std::array<GasTrace, lanes> trace{};
    std::array<double, lanes> impedance{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      trace[lane] = gas.trace(lane, dt, first_order);
      impedance[lane] = solid.impedance(lane), pressure[lane] = trace[lane].p;
    }
    solid.respond(dt, pressure, first_order, velocity);
    for (int i = 0; i < most_responses; ++i) {
      std::array<double, lanes> const pressure_before = pressure;
      std::array<Vec3, lanes> const velocity_before = velocity;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        double const free = velocity[lane][0] + pressure[lane] / impedance[lane];
        pressure[lane] = meet(gas.eos(), trace[lane], free, impedance[lane]);
      }
      solid.respond(dt, pressure, first_order, velocity);
      bool done = true;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        double const change = pressure[lane] - pressure_before[lane];
        double const expected = velocity_before[lane][0] - change / impedance[lane], got = velocity[lane][0];
        if (std::fabs(got - expected) <= velocity_close * solid.sound_speed(lane)) continue;
        done = false;
        double const slope = (velocity_before[lane][0] - got) / change;
        if (slope > 0.1 / impedance[lane] && slope < 100 / impedance[lane]) impedance[lane] = 1 / slope;
      }
      if (done) break;
    }
  }
};

namespace {

ModelOptions known(ModelOptions options) {
  if (options.predictor == Predictor::parabolic) options.predictor = Predictor::linear;
  return options;
}

}  // namespace

ModelProblems::ModelProblems(AnyEos const& gas, AnySolid const& solid, double gas_width, double solid_width,
                             ModelOptions options)
    : impl_(std::make_unique<Against<SolidSide>>(gas, gas_width, known(options), solid, solid_width, known(options))) {}
ModelProblems::ModelProblems(AnyEos const& gas, double gas_width, ModelOptions options)
    : impl_(std::make_unique<Against<WallSide>>(gas, gas_width, known(options))) {}
ModelProblems::~ModelProblems() = default;
ModelProblems::ModelProblems(ModelProblems&&) noexcept = default;

void ModelProblems::solve(std::span<ModelStencil const> stencils, double dt, std::span<ModelResult> results) {
  for (ModelResult& r : results) r.failed = true;
  impl_->solve(stencils, dt, results, false);
  bool const again = std::any_of(results.begin(), results.end(), [](ModelResult const& r) { return r.failed; });
  if (!again) return;
  impl_->solve(stencils, dt, results, true);
  for (std::size_t lane = 0; lane < results.size(); ++lane) {
    ModelResult& r = results[lane];
    if (!r.failed) continue;
    ModelStencil const& s = stencils[lane];
    r.pressure = s.gas[0][1][1][gas_field::p], r.velocity = s.velocity, r.first_order = true;
    for (std::size_t l = 0; l < core_layers; ++l) r.gas[l] = s.gas[l][1][1], r.solid[l] = s.solid[l][1][1];
  }
}

}  // namespace g27
