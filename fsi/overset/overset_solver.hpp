#pragma once
/// Gas and deforming bodies in three dimensions on overset grids: the step of OG section 5.
#include <memory>

#include "fsi/overset/closure.hpp"
#include "fsi/overset/remeshing.hpp"

namespace g27 {

struct OversetSetup {
  GasGridSetup gas;  ///< of equal widths along the three axes
  std::vector<BodySetup> bodies;
  SolidSchemeOptions solid_options{};
  ModelOptions local{};  ///< of the model problems
  Remeshing remeshing{};
  bool skip = true;      ///< bodies that nothing has reached are left alone
  bool closure = false;  ///< momentum and angular momentum of the bodies are those that the pressures gave them
  double cfl = 0;        ///< 0: chosen, 0.8, or 0.7 with a body that yields
  double growth = 1.2;   ///< of the time step, at most
  double first = 0.1;    ///< of the first time step, over that which is stable
};

struct OversetCounters {
  std::uint64_t steps = 0, problems = 0;  ///< model problems solved
  std::uint64_t skipped = 0;              ///< model problems of bodies that nothing had reached
  std::uint64_t first_order = 0;          ///< of them redone by Godunov's scheme
  std::uint64_t failed = 0;               ///< of those kept as they were
  LocalRemeshCounts remeshing{};
  double seconds_local = 0, seconds_gas = 0, seconds_solid = 0, seconds_geometry = 0, seconds_fill = 0;
};

class OversetSolver {
 public:
  /// The gas's state at the start is that of `initial` where there is no body.
  OversetSolver(OversetSetup setup, std::function<GasPoint(Vec3 const&)> initial);
  ~OversetSolver();

  /// One step, not beyond t_end.
  GridStepReport step(double t_end);

  [[nodiscard]] double time() const noexcept;
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
