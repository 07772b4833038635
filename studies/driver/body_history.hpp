#pragma once
/// What a run with bodies records of them as it goes.
#include "fsi/overset/gas_integrals.hpp"
#include "studies/driver/grid_history.hpp"

namespace g27 {

/// Of every body body/NAME/: centre, velocity, momentum, impulse (that the gas gave it), angular_momentum (about its
/// centre of mass) and extent, each _x, _y, _z; mass, volume, kinetic_energy, energy, plastic_strain (the largest). Of
/// every probe on a face probe/NAME/: position and velocity, each _x, _y, _z, speed, pressure: means over the area.
std::vector<HistoryColumn> body_columns(SceneRun const& run);

/// Values of these columns. `held`: each body's integrals; `start`: its momentum at the start.
void add_body_row(SceneRun const& run, OversetSolver const& solver, std::vector<BodyIntegrals> const& held,
                  std::vector<Vec3> const& start, std::vector<double>& row);

/// The gas between the bodies: NaN within them.
class BodyFieldView : public GridFieldView {
 public:
  explicit BodyFieldView(OversetSolver const& solver) : GridFieldView(solver.gas()), solver_(&solver) {}
  [[nodiscard]] GasPoint at(Vec3 const& x) const override;
  [[nodiscard]] double max_pressure() const override;

 private:
  OversetSolver const* solver_;
};

}  // namespace g27
