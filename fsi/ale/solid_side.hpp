#pragma once
/// The solid of the model problems: layers along -n from the contact, on which the gas's pressure acts.
#include "fsi/ale/lanes.hpp"
#include "scheme/kernel/solid_kernels.hpp"

namespace g27 {

class SolidSide {
 public:
  SolidSide(AnySolid const& solid, double width, ModelOptions const& options);

  /// Velocities less `frame` [lane].
  void load(std::span<ModelStencil const> stencils, std::array<Vec3, model_lanes> const& frame);
  void shift(std::array<Vec3, model_lanes> const& by) noexcept;
  void transverse(double dt);
  /// Lateral cells outside of the body take its traction condition: after transverse(), before step().
  void set_ghosts();
  /// Velocity of the contact under these pressures, mean over the step.
  void respond(double dt, std::array<double, model_lanes> const& pressure, bool first_order,
               std::array<Vec3, model_lanes>& velocity);
  void step(double dt, std::array<double, model_lanes> const& pressure, bool first_order);
  [[nodiscard]] SolidFields state(std::size_t lane, int layer, Vec3 const& frame, bool& sound) const;
  /// Impedance of P waves in the cell at the contact [kg/(m^2 s)].
  [[nodiscard]] double impedance(std::size_t lane) const noexcept;
  [[nodiscard]] double sound_speed(std::size_t lane) const noexcept {
    return impedance(lane) / block_.at(solid_cell::rho, along(0), 1, 1)[lane];
  }

 private:
  using Terms = LaneRows<solid_cell::terms>;
  using Flux = LaneRows<solid_face::fields>;
  using Averages = LaneRows<solid_conserved::fields>;
  /// The kernels' axis 0 is n, so that the layers count backwards along it.
  static constexpr int along(int layer) noexcept { return 2 - layer; }
  void put(std::size_t lane, int layer, int j, int k, SolidFields const& q);
  void term_of(int layer, int j, int k, double dt, std::array<Terms*, 3> const& out);
  void contact_face(double dt, std::array<double, model_lanes> const& pressure, bool first_order, Flux& out);
  void faces(int axis, std::array<int, 3> cell, bool far_left, bool far_right, bool const* free, Terms& left,
             Terms& right, double dt, bool first_order, Flux& out);
  [[nodiscard]] Terms& term(int layer, int cell, int axis) noexcept {
    return terms_[static_cast<std::size_t>((layer * 5 + cell) * 3 + axis)];
  }

  AnySolid solid_;
  SolidKernels const& kernels_;
  ModelOptions options_;
  Strength strength_;
  double h_;
  LaneBlock<solid_cell::fields> block_;
  LaneStencil<solid_cell::fields> stencil_;
  std::vector<Terms> terms_;
  std::span<ModelStencil const> stencils_;
  std::array<Vec3, model_lanes> frame_{};
  std::array<bool, model_lanes> tip_{};      ///< where no switch acts
  std::array<double, model_lanes> quiet_{};  ///< bend of the amplitudes up to which it does not, over K + 4 mu/3
  LaneRows<3> given_;
  std::array<Averages, core_layers> now_, next_;
};

}  // namespace g27
