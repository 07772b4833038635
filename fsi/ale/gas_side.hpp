#pragma once
/// The gas of the model problems: layers along +n from the contact, which is a wall at rest.
#include "fsi/ale/lanes.hpp"
#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/gas_fields.hpp"

namespace g27 {

/// The gas at the contact before it is met: where the characteristics that reach it start.
struct GasTrace {
  double rho, u, p;
};

class GasSide {
 public:
  GasSide(AnyEos const& eos, double width, ModelOptions const& options);

  /// Velocities less `frame` [lane].
  void load(std::span<ModelStencil const> stencils, std::array<Vec3, model_lanes> const& frame);
  void shift(std::array<Vec3, model_lanes> const& by) noexcept;
  /// By the predictor of the options, or by Godunov's.
  GasTrace trace(std::size_t lane, double dt, bool first_order);
  /// New states of the core layers, by the pressures at the wall. False: a state that is none.
  void step(double dt, std::array<double, model_lanes> const& pressure, bool first_order);
  [[nodiscard]] GasFields state(std::size_t lane, int layer, Vec3 const& frame, bool& sound) const;
  [[nodiscard]] AnyEos const& eos() const noexcept { return eos_; }

  void transverse(double dt);

 private:
  static constexpr std::size_t rho = 0, u = 1, p = 4, K = 5, margin = 6, fields = 7;
  using Terms = LaneRows<5>;
  struct Flux {
    LaneRows<5> q;
    LaneRows<2> at;  ///< pressure and normal velocity
  };
  /// The cell beyond the contact: the gas continued through the state there.
  void continue_beyond(std::array<double, model_lanes> const& pressure) noexcept;
  /// Lanes in which a strong shock lies between the contact and the third layer.
  bool shocks(std::array<double, model_lanes> const& pressure, bool* in_shock) const noexcept;
  void put(std::size_t lane, int i, int j, int k, GasFields const& q);
  void term_of(int i, int j, int k, double dt, std::array<Terms*, 3> const& out);
  /// Where both far cells are known the switch is that of the grid.
  void faces(int axis, std::array<int, 3> cell, bool far_left, bool far_right, Terms const* left, Terms const* right,
             double dt, bool first_order, Flux& out);
  /// Layer, and the cell of it: 0 the centre, 1 2 its neighbours along a, 3 4 along b.
  [[nodiscard]] Terms& term(int layer, int cell, int axis) noexcept {
    return terms_[static_cast<std::size_t>((layer * 5 + cell) * 3 + axis)];
  }

  AnyEos eos_;
  GasKernels const& kernels_;
  EosKernels const& law_;
  PredictorKernel predictor_;
  ModelOptions options_;
  void const* at_eos_;
  double exponent_, h_;
  LaneBlock<fields> block_;
  std::vector<Terms> terms_;
  FaceProblems problems_{model_lanes};
  Padded still_, width_, pair_, triple_;
  LaneStencil<fields> stencil_;
  std::array<LaneRows<5>, core_layers> now_, next_;
};

}  // namespace g27
