#pragma once
/// Inside of SolidGrid: tiles, and the stages of a step. solid_grid.cpp has the state and the interface,
/// solid_grid_step.cpp the step's control.
#include <memory>
#include <vector>

#include "scheme/step/accumulator.hpp"
#include "scheme/step/solid_tile.hpp"

namespace g27 {

struct SolidGrid::Impl {
  SolidGridSetup setup;
  Tiling tiling;
  std::vector<SolidTile> tiles;
  SolidContext context;
  std::vector<std::unique_ptr<SolidTileWork>> works;  ///< one a thread
  double rate = 0;
  SolidCounters counters;
  std::array<Accumulator, 5> initial, boundary, source;
  Accumulator plastic_work;
  std::array<double, 5> scale{};

  explicit Impl(SolidGridSetup s);

  /// Checked and completed: tile sizes and the CFL number chosen.
  static SolidGridSetup checked(SolidGridSetup s);
  static Tiling tiling_of(SolidGridSetup const& s);
  static SolidContext context_of(Impl& impl);

  /// Sets every cell from its mean; starts counters and ledger at t.
  void set(std::function<SolidVector(Int3 const&)> const& mean, double t);
  [[nodiscard]] SolidVector conserved(SolidPoint const& s) const noexcept {
    return conserved_of(setup.material.eos, s);
  }
  [[nodiscard]] SolidPoint primitive(SolidVector const& q) const noexcept {
    return primitive_of(setup.material.eos, q);
  }
  /// rho a^2 for waves along each axis [Pa].
  [[nodiscard]] Vec3 moduli(SolidPoint const& s) const noexcept;
  [[nodiscard]] double signal_rate(SolidVector const& q) const noexcept;
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;
  void add_totals(std::array<Accumulator, 5>& total, std::array<double, 5>& magnitude) const;

  GridStepReport step(double t_end);
  void run();
  [[nodiscard]] Int3 first_bad_cell() const noexcept;
  void accept(double dt, double new_rate);
};

}  // namespace g27
