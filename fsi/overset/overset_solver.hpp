#pragma once
/// Gas and deforming bodies in three dimensions on overset grids: the step of OG section 5.
#include <memory>

#include "fsi/overset/closure.hpp"
#include "fsi/overset/overset_state.hpp"
#include "fsi/overset/remeshing.hpp"

namespace g27 {

struct OversetSetup {
  GasGridSetup gas;  ///< of equal widths along the three axes
  std::vector<BodySetup> bodies{};
  SolidSchemeOptions solid_options{};  ///< its cfl holds for the solids of model problems too; 0: as of the gas
  ModelOptions local{};                ///< of the model problems
  Remeshing remeshing{};
  Literal literal{};     ///< readings of the paper that are compared
  bool skip = true;      ///< bodies that nothing has reached are left alone
  bool closure = false;  ///< momentum and angular momentum of the bodies are those that the pressures gave them
  double cfl = 0;        ///< of the gas; 0: chosen, 0.8, or 0.7 with a body that yields
  double growth = 1.2;   ///< of the time step, at most
  double first = 0.1;    ///< of the first time step, over that which is stable
  double start = 0;      ///< time at the start [s]
  /// averages of the gas's cells at the start; without it the state at their centres
  std::function<GasDensities(Int3 const& cell)> gas_cells{};
};

class OversetSolver {
 public:
  /// The gas's state at the start is that of `initial` where there is no body.
  OversetSolver(OversetSetup setup, std::function<GasPoint(Vec3 const&)> initial);
  /// Goes on, bit by bit, where the solver of the same setup stood that this state comes from.
  OversetSolver(OversetSetup setup, OversetState const& from);
  ~OversetSolver();
  [[nodiscard]] OversetState state() const;

  /// One step, not beyond t_end.
  GridStepReport step(double t_end);

  [[nodiscard]] double time() const noexcept;
  /// Time step that all grids and model problems allow now [s].
  [[nodiscard]] double stable_dt() const;
  [[nodiscard]] GasGrid const& gas() const noexcept;
  [[nodiscard]] std::vector<std::unique_ptr<Body>> const& bodies() const noexcept;
  [[nodiscard]] OversetCounters const& counters() const noexcept;
  /// What each body held at the start and what the pressures on its triangles have given it since.
  [[nodiscard]] std::vector<BodyMomentum> const& momenta() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
