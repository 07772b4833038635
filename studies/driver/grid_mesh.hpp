#pragma once
/// What a run on a grid advances: a grid of gas, alone or with bodies in it.
#include <memory>

#include "studies/driver/grid_history.hpp"
#include "studies/driver/run_record.hpp"

namespace g27 {

class GridMesh {
 public:
  virtual ~GridMesh() = default;

  /// Without a state before start() or resume().
  [[nodiscard]] virtual GasGrid const& gas() const = 0;
  /// Averages of the cells at `time`, and the state at a point.
  virtual void start(std::function<GasDensities(Int3 const& cell)> const& cells,
                     std::function<GasPoint(Vec3 const& x)> const& point, double time) = 0;
  virtual void resume(GridRestart const& from) = 0;
  virtual GridStepReport step(double t_end) = 0;
  [[nodiscard]] virtual double time() const { return gas().time(); }
  [[nodiscard]] virtual double stable_dt() const { return gas().stable_dt(); }
  /// Why the run must end, whatever the grid's report says; empty: it need not.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
  [[nodiscard]] virtual double bytes() const { return static_cast<double>(gas().bytes()); }

  [[nodiscard]] virtual std::unique_ptr<GridView> view() const { return std::make_unique<GridFieldView>(gas()); }
  /// Mass [kg] and energy [J] of the gas.
  [[nodiscard]] virtual std::pair<double, double> totals() const;
  /// Values that follow those of the gas in a row of the history.
  virtual void complete(std::vector<double>& /*row*/) {}
  virtual void complete(GridSnapshot& /*shot*/) const {}
  /// Totals since the start: those `before` this process, if it resumed, and its own.
  virtual void capture_totals(GridRestart const& before, bool resumed, GridRestart& now) const;
  /// What resume() needs.
  virtual void capture_state(GridRestart& now) const = 0;
};

/// Throws InputError for a setup that the scheme refuses.
std::unique_ptr<GridMesh> make_mesh(SceneRun const& run);

/// With bodies: body_mesh.cpp.
std::unique_ptr<GridMesh> make_body_mesh(SceneRun const& run);

}  // namespace g27
