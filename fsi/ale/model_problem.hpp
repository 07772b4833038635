#pragma once
/// The model problem of every triangle: 3x3x3 cells of solid and 3x3x3 of gas with the contact between them, which is
/// sharp and moves; two layers a side are integrated over a step.
///
/// The local grid moves with the contact. In the frame of the contact it stands, and so the step is that of the fixed
/// grids, by the same kernels: predictor, Riemann problems, transverse terms, corrector. Many problems are solved
/// together, one in each lane of a row.
#include <memory>
#include <optional>
#include <span>

#include "fsi/overset/fields.hpp"
#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

inline constexpr int core_layers = 2;  ///< layers of cells that a model problem integrates

/// States around a triangle, in its frame, [layer away from the contact][a][b], the triangle at [.][1][1].
struct ModelStencil {
  template <class Fields>
  using Cells = std::array<std::array<std::array<Fields, 3>, 3>, 3>;
  Cells<GasFields> gas;
  std::optional<GasFields> gas_fourth{};  ///< one more along the normal: what the switch sees; left out: as the third
  Cells<SolidFields> solid;               ///< lateral cells outside of the body carry its traction condition
  Cells<SolidFields> solid_smooth;        ///< the same with those cells continued smoothly, for derivatives
  Cells<bool> solid_ghost;                ///< which those are
  bool inner = true;       ///< no side of the body but the contact near, nor crushed: the switch sees loud bends alone
  Vec3 velocity{0, 0, 0};  ///< of the contact in the last step, along the frame's axes [m/s]
};

struct ModelResult {
  double pressure = 0;     ///< at the contact, mean over the step [Pa]
  Vec3 velocity{0, 0, 0};  ///< of the solid there, along the frame's axes [m/s]
  std::array<GasFields, core_layers> gas;
  std::array<SolidFields, core_layers> solid;
  bool first_order = false;  ///< redone by Godunov's scheme, for a state that was none
  bool failed = false;       ///< that failed as well: the states are those before the step
};

struct ModelOptions {
  Predictor predictor = Predictor::linear;
  Switch monotonicity = Switch::graded;
  RiemannSolver riemann = RiemannSolver::fast;
};

class ModelProblems {
 public:
  static constexpr std::size_t lanes = 16;  ///< problems solved together

  /// Widths of the cells of both sides [m]. Profiles are linear for the parabolic predictor as well.
  ModelProblems(AnyEos const& gas, AnySolid const& solid, double gas_width, double solid_width, ModelOptions options);
  /// Of gas against rigid walls: the velocities of the stencils are the walls', the solids are neither read nor given.
  ModelProblems(AnyEos const& gas, double gas_width, ModelOptions options);
  ~ModelProblems();
  ModelProblems(ModelProblems&&) noexcept;

  /// A step of dt [s] of at most `lanes` problems.
  void solve(std::span<ModelStencil const> stencils, double dt, std::span<ModelResult> results);

 private:
  struct Impl;
  template <class Solid>
  struct Against;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
