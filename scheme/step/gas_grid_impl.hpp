#pragma once
/// Inside of GasGrid: tiles, and the stages of a step. gas_grid.cpp has the state and the interface, gas_grid_step.cpp
/// the step's control.
#include <memory>
#include <vector>

#include "scheme/step/accumulator.hpp"
#include "scheme/step/gas_tile.hpp"

namespace g27 {

inline constexpr double grid_repair_share = 1e-3;  ///< least rho and margin a step may leave, over the old ones

struct GasGrid::Impl {
  GasGridSetup setup;
  Tiling tiling;
  std::vector<GasTile> tiles;
  GridContext context;
  std::vector<std::unique_ptr<TileWork>> works;  ///< one a thread
  double rate = 0, largest_density = 0;
  GridCounters counters;
  std::array<Accumulator, 5> initial, boundary, source, floor;
  FiveDensities scale{};

  explicit Impl(GasGridSetup s);

  /// Checked and completed: tile sizes chosen.
  static GasGridSetup checked(GasGridSetup s);
  static Tiling tiling_of(GasGridSetup const& s);
  static GridContext context_of(Impl& impl);
  /// Cells of the tile and of the layers around it that lie beside an edge of a solid block.
  [[nodiscard]] std::vector<Int3> block_edges(TileBox const& box) const;

  /// When the detonation front comes to each tile and its neighbours, and leaves them.
  void set_lighting();
  /// Sets every cell from its mean; starts counters and ledger at t.
  void set(std::function<FiveDensities(Int3 const&)> const& mean, double t);
  void start(double t);
  [[nodiscard]] FiveDensities densities(GasTile const& t, std::ptrdiff_t i) const noexcept;
  [[nodiscard]] FiveDensities conserved(GasPoint const& s) const noexcept;
  [[nodiscard]] GasPoint primitive(FiveDensities const& q) const noexcept;
  [[nodiscard]] double bulk_modulus(GasPoint const& s) const noexcept;
  [[nodiscard]] double margin(GasPoint const& s) const noexcept;
  [[nodiscard]] double signal_rate(FiveDensities const& q) const noexcept;
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;
  [[nodiscard]] double volume() const noexcept { return context.h[0] * context.h[1] * context.h[2]; }
  void add_totals(std::array<Accumulator, 5>& total, FiveDensities* magnitude) const;

  /// Tiles whose new state differs from the old one, or might.
  [[nodiscard]] std::vector<TileId> active() const;
  [[nodiscard]] bool stays(TileId id) const;
  GridStepReport step(double t_end);
  /// One attempt: the new state in `next`; false where it is not admissible. `cell`: where.
  bool try_step(double dt, std::vector<TileId> const& ids, double& new_rate, Int3& cell);
  void run(std::vector<TileId> const& ids);
  /// Faces of cells that lost nearly all of their density or pressure margin are redone at first order.
  void repair(std::vector<TileId> const& ids);
  /// The cell holds unburnt explosive.
  [[nodiscard]] bool fresh(GasTile const& t, std::ptrdiff_t i) const;
  [[nodiscard]] bool bad(GasTile const& t, std::ptrdiff_t i, double share) const;
  bool floor_vacuum(std::vector<TileId> const& ids, Int3& cell);
  void accept(double dt, std::vector<TileId> const& ids, double new_rate);
  /// What passes the outer sides of tiles that are left out: the flux of their uniform state.
  void account_for_skipped(double dt, std::vector<TileId> const& ids);
};

}  // namespace g27
