#pragma once
/// A rigid wall in the place of the model problems' solid: of infinite impedance, at rest in the frame it is given.
#include <limits>

#include "fsi/ale/lanes.hpp"

namespace g27 {

/// With the members of SolidSide that model problems call.
struct WallSide {
  void load(std::span<ModelStencil const>, std::array<Vec3, model_lanes> const&) noexcept {}
  void shift(std::array<Vec3, model_lanes> const&) noexcept {}
  void transverse(double) noexcept {}
  void set_ghosts() noexcept {}
  void respond(double, std::array<double, model_lanes> const&, bool, std::array<Vec3, model_lanes>& velocity) noexcept {
    velocity.fill({0, 0, 0});
  }
  void step(double, std::array<double, model_lanes> const&, bool) noexcept {}
  [[nodiscard]] SolidFields state(std::size_t, int, Vec3 const&, bool&) const noexcept { return {}; }
  [[nodiscard]] double impedance(std::size_t) const noexcept { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] double sound_speed(std::size_t) const noexcept { return std::numeric_limits<double>::infinity(); }
};

}  // namespace g27
