#pragma once
/// A tile of a gas grid: what it stores between steps, and the work of one step on it. gas_tile_fill.cpp gathers the
/// tile and its surroundings, gas_tile.cpp sweeps the faces, gas_tile_faces.cpp solves a row of them, gas_tile_burn.cpp
/// adds what a detonation releases.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "scheme/grid/cell_place.hpp"
#include "scheme/grid/tiling.hpp"
#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/gas_fields.hpp"
#include "scheme/step/gas_grid.hpp"

namespace g27 {

/// Five conserved densities: mass, momentum along x, y, z, energy.
using FiveDensities = std::array<double, 5>;

using CacheLineVector = std::vector<double, CacheLineAllocator<double>>;

/// Conserved averages of a tile now and after the step; nothing is stored while the tile is one uniform state.
struct GasTile {
  TileBox box;
  std::ptrdiff_t row = 0;    ///< doubles from one row to the next: the cells of a row, rounded up to a vector
  std::ptrdiff_t field = 0;  ///< doubles from one density to the next
  bool uniform = false;      ///< all cells hold `state`
  FiveDensities state{};
  std::vector<Int3> edges;    ///< cells beside the edges of solid blocks, one around the tile included (see plain_cell)
  CacheLineVector now, next;  ///< empty: not stored
  std::vector<float> maps;    ///< steps in which switch, cure and repair acted, [3][cells]; empty: not wanted
  double last_lit = -1e300, first_lit = 1e300;  ///< when the detonation front has left it, and comes to it [s]
  std::vector<unsigned char> redo;  ///< cells whose faces are redone at first order in this step; empty: none

  /// Results of a step.
  double worst = 1, rate = 0;
  bool differs = false;
  std::size_t failures = 0;
  double faces = 0, switched = 0, strong = 0, cured = 0, redone = 0;
  FiveDensities through{}, from_source{};

  [[nodiscard]] bool stored() const noexcept { return !now.empty(); }
  [[nodiscard]] std::size_t cells() const noexcept { return cells_in(box.size); }
  [[nodiscard]] std::ptrdiff_t index(int i, int j, int k) const noexcept {
    return i + row * (j + static_cast<std::ptrdiff_t>(box.size[1]) * k);
  }
  [[nodiscard]] double at(CacheLineVector const& q, std::size_t density, std::ptrdiff_t i) const noexcept {
    return stored() ? q[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(density) * field + i)] : state[density];
  }
  void store_state(int dims);
};

/// What all tiles of a grid share during a step.
struct GridContext {
  GasGridSetup const& setup;
  Tiling const& tiling;
  std::vector<GasTile>& tiles;
  GasKernels const& kernels;
  EosKernels const& law;
  PredictorKernel predictor;
  void const* eos;
  double exponent;
  std::array<double, 2> energy_line;  ///< see EosKernels
  int dims;
  std::array<bool, 3> swept;  ///< axes with more than one cell
  Vec3 lower, h;              ///< corner of the box; widths, 1 along axes that are not there
  int halo;                   ///< cells around a tile that its step reads
  double time = 0, dt = 0;

  /// Largest width of a cell [m].
  [[nodiscard]] double width() const noexcept {
    double widest = 0;
    for (std::size_t a = 0; a < 3; ++a) widest = swept[a] ? std::max(widest, h[a]) : widest;
    return widest;
  }
  [[nodiscard]] GridBoundary const& condition(Side side, Vec3 const& x) const noexcept;
};

/// Arrays for the work on one tile at a time: one a thread.
class TileWork {
 public:
  /// `largest`: cells of the largest tile along each axis.
  TileWork(GridContext const& context, Int3 const& largest);

  /// The new state of the tile into `next`, its results beside it.
  void step(TileId id);

  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  struct Fields {
    RowOut q;  ///< at cell (0, 0, 0) of the tile
    double *K = nullptr, *margin = nullptr;
  };
  struct FluxRow {
    Padded mass, momentum[3], energy, p, u;
    FluxRow() = default;
    explicit FluxRow(std::size_t n) : mass(n), momentum{Padded(n), Padded(n), Padded(n)}, energy(n), p(n), u(n) {}
    [[nodiscard]] RowOut out() noexcept {
      return {mass.data(), {momentum[0].data(), momentum[1].data(), momentum[2].data()}, energy.data()};
    }
  };
  struct TermRow {
    Padded rho, u[3], p;
    TermRow() = default;
    explicit TermRow(std::size_t n) : rho(n), u{Padded(n), Padded(n), Padded(n)}, p(n) {}
    [[nodiscard]] RowOut out() noexcept { return {rho.data(), {u[0].data(), u[1].data(), u[2].data()}, p.data()}; }
  };
  /// A row of faces: left cells start at `cell`, n faces across `axis`; terms of the left and the right cells, by the
  /// cell's place in its row.
  struct FaceRow {
    int axis;
    std::ptrdiff_t cell;
    std::size_t n;
    TermRow *left, *right;
    bool wall_low, wall_high;  ///< the row lies on that side of the tile, and gas ends there
    int j, k;                  ///< of the row, in the tile
  };

  // gas_tile_fill.cpp
  void gather_row(int j, int k);
  /// Its cells [begin, end), which lie in the tile of that direction.
  void gather_part(Int3 const& region, int j, int k, int begin, int end);
  /// Planes of primitives, and of their averages, that the sweep needs up to plane `k` of faces: as late as can be, so
  /// that they are still in the cache.
  void gather_up_to(int k);
  /// Ghosts of the planes [k0, k1) beyond the box and in solid blocks, from the cells beside them, `depth` deep; means
  /// of the primitives when `means`, else the primitives themselves.
  void fill_outside(int k0, int k1, int depth, bool means);
  void fill_region(Int3 const& region, std::array<bool, 3> const& across, int k0, int k1, int depth, bool means);
  void set_inflow(GridBoundary const& condition, std::ptrdiff_t i, Int3 const& cell);
  void average_plane(int k);
  [[nodiscard]] TileId beside(Int3 const& direction) const noexcept { return g_.tiling.beside(id_, direction); }
  [[nodiscard]] bool gas_ends(int axis, int direction) const noexcept;
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;
  [[nodiscard]] std::ptrdiff_t index(int i, int j, int k) const noexcept { return i + sj_ * j + sk_ * k; }

  // gas_tile.cpp
  void sweep();
  void set_terms(int j, int k);
  void add_sources(int j, int k, std::array<TermRow*, 3> const& terms) const;
  /// Cells beside an edge of a solid block have ghosts that depend on the side from which they are seen: two tiles
  /// would not agree on what crosses their common face. There nothing is taken from across: no transverse term, no
  /// cure, no slope of MUSCL, no correction of the averages.
  void plain_cell(Int3 const& cell, std::size_t y_slot, std::size_t z_slot);
  /// Where the rows of an odd or even j, and of an odd or even k, are kept.
  [[nodiscard]] static std::size_t y_slot(int j) noexcept { return static_cast<std::size_t>(((j % 2) + 2) % 2); }
  [[nodiscard]] std::size_t z_slot(int j, int k) const noexcept {
    int const row = j < 0 ? 0 : j >= ny_ ? ny_ - 1 : j;
    return y_slot(k) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(row);
  }
  void x_faces(int j, int k);
  void y_faces(int j, int k);
  void z_faces(int j, int k);
  void update_xy(int j, int k);
  void update_z(int j, int k, FluxRow& lower, FluxRow& upper);
  void finish(int j, int k);
  void account(int axis, bool low, FluxRow& flux, std::ptrdiff_t first, std::size_t n) noexcept;
  void find_redo();
  [[nodiscard]] RowOut tile_row(CacheLineVector& q, int j, int k) const noexcept;

  // gas_tile_faces.cpp
  /// Half-step terms of a row of faces, by the face.
  struct Increments {
    bool there = false;
    RowIn left, right;
  };
  void solve_row(FaceRow const& row, FluxRow& out);
  Increments increments(FaceRow const& row, PredictorKernel kernel);
  [[nodiscard]] PredictArguments arguments(PredictorKernel kernel, int axis, FaceProblems& b) const noexcept;
  /// Fluxes of weak faces come with their prediction.
  [[nodiscard]] bool at_once() const noexcept;
  void predict(FaceRow const& row, PredictorKernel kernel, Increments const& inc, FaceProblems& b, FluxRow& out);
  void image_in_wall(FaceRow const& row, PredictorKernel kernel, Increments const& inc, bool low, FaceProblems& b);
  void fluxes(FaceRow const& row, PredictorKernel kernel, FaceProblems& b, FluxRow& out);
  void muscl_row(FaceRow const& row, FluxRow& out);
  void solve_problems(FaceRow const& row, FaceProblems& b, bool averaged, bool weak_done, FluxRow& out);
  void seal(FaceRow const& row, FluxRow& out) noexcept;
  void seal_cured(FaceRow const& row, FluxRow& out) noexcept;
  /// Faces with a flagged cell on either side are redone at first order; how many. The marks are in mark_.
  std::size_t redo_row(std::vector<double> const& flags, FaceRow const& row, FluxRow& out);
  /// Faces with a flagged cell on either side into mark_; how many.
  void mark(std::vector<double> const& flags, FaceRow const& row, std::size_t& count);
  void count_in_map(std::size_t map, FaceRow const& row, Padded const& acted) noexcept;
  [[nodiscard]] bool is_wall(FaceRow const& row, bool low, std::ptrdiff_t lane) const noexcept;
  /// The k-th of the other axes.
  [[nodiscard]] std::size_t other_axis(std::size_t axis, std::size_t k) const noexcept;
  /// Lanes of a row that lie on the low or the high side of the tile: first and number.
  static std::pair<std::ptrdiff_t, std::size_t> lanes_on_side(FaceRow const& row, bool low) noexcept;
  [[nodiscard]] RowIn cells_at(std::ptrdiff_t i) const noexcept;
  [[nodiscard]] std::ptrdiff_t stride(int axis) const noexcept { return axis == 0 ? 1 : axis == 1 ? sj_ : sk_; }

  // gas_tile_burn.cpp
  /// Unburnt fractions of the tile and of two layers of cells around it.
  void find_unburnt();
  /// Faces beside unburnt explosive have no Riemann problem in other runs.
  void leave_unburnt(FaceRow const& row, FaceProblems& b);
  /// Those faces at first order and by HLLC, since unburnt explosive has no pressure margin, without which there is no
  /// exact solution beside a vacuum; and the energy that rides with the mass of every face.
  void burn_row(FaceRow const& row, FluxRow& out);
  /// What the cells of a row have released.
  void release(int j, int k);

  GridContext const& g_;
  bool third_order_;
  TileId id_ = -1;
  GasTile* tile_ = nullptr;
  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::array<int, 3> halo_{};
  std::ptrdiff_t sj_ = 0, sk_ = 0, origin_ = 0;
  std::size_t volume_ = 0, mirror_line_ = 0;

  Padded rho_, u_[3], p_, K_, margin_, mean_u_[3], mean_p_, dK_dp_;
  TermRow gathered_;
  std::vector<double> cure_, redo_;  ///< flags of cells, as the primitives
  bool any_cure_ = false, any_redo_ = false, burns_ = false, at_unburnt_ = false;
  std::vector<double> unburnt_, near_unburnt_;  ///< fractions and flags of cells, as the primitives; empty: no burn
  int planes_ = 0, mean_planes_ = 0;            ///< gathered so far: up to these
  TermRow x_terms_, averaged_;
  std::array<TermRow, 2> y_terms_;
  std::vector<TermRow> z_terms_;  ///< of two planes
  FluxRow other_flux_;
  std::array<FluxRow, 2> x_flux_, y_flux_;
  std::vector<FluxRow> z_flux_;  ///< of two planes
  FaceProblems problems_, other_problems_, wall_problems_;
  Padded mark_, map_, mirror_[8];
  Padded width_[3], pair_[3], triple_[3], still_;
  std::array<TermRow, 2> x_edges_;                 ///< MUSCL: lower and upper edges
  std::array<std::array<TermRow, 2>, 2> y_edges_;  ///< [row][lower, upper]
  std::vector<std::array<TermRow, 2>> z_edges_;    ///< of two planes
};

}  // namespace g27
