#pragma once
/// A tile of a solid grid: what it stores between steps, and the work of one step on it. solid_tile_fill.cpp gathers
/// the tile and its surroundings, solid_tile.cpp sweeps the faces.
#include <array>
#include <span>
#include <vector>

#include "scheme/grid/cell_place.hpp"
#include "scheme/grid/line.hpp"
#include "scheme/grid/tiling.hpp"
#include "scheme/kernel/solid_kernels.hpp"
#include "scheme/step/row_block.hpp"
#include "scheme/step/solid_grid.hpp"
#include "scheme/step/solid_state.hpp"

namespace g27 {

inline constexpr int solid_halo = 2;  ///< cells around a tile that its step reads

struct SolidTile {
  TileBox box;
  std::ptrdiff_t row = 0;    ///< doubles from one row to the next: the cells of a row, rounded up to a vector
  std::ptrdiff_t field = 0;  ///< doubles from one density to the next
  std::vector<double, CacheLineAllocator<double>> now, next;
  bool active = true;  ///< steps update it

  /// Results of a step.
  double least = 1, rate = 0;
  double faces = 0, switched = 0, tangents = 0, yielded = 0, plastic_work = 0;
  std::array<double, 5> through{}, from_source{};  ///< mass, momentum, energy

  [[nodiscard]] std::size_t cells() const noexcept { return cells_in(box.size); }
  [[nodiscard]] std::ptrdiff_t index(int i, int j, int k) const noexcept {
    return i + row * (j + static_cast<std::ptrdiff_t>(box.size[1]) * k);
  }
  [[nodiscard]] FieldRows at(std::vector<double, CacheLineAllocator<double>>& q, int i, int j, int k) const noexcept {
    return {q.data() + index(i, j, k), field};
  }
  [[nodiscard]] SolidVector densities(std::ptrdiff_t i) const noexcept {
    SolidVector q{};
    for (std::size_t d = 0; d < q.size(); ++d)
      q[d] = now[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * field + i)];
    return q;
  }
};

/// What all tiles of a grid share during a step.
struct SolidContext {
  SolidGridSetup const& setup;
  Tiling const& tiling;
  std::vector<SolidTile>& tiles;
  SolidKernels const& kernels;
  SolidEosKernels law;
  void const* eos;
  Strength strength;
  bool plastic;
  std::array<bool, 3> swept;  ///< axes with more than one cell
  Vec3 lower, h;              ///< corner of the box; widths, 1 along axes that are not there
  double time = 0, dt = 0;

  [[nodiscard]] double volume() const noexcept { return h[0] * h[1] * h[2]; }
};

/// Arrays for the work on one tile at a time: one a thread.
class SolidTileWork {
 public:
  /// `largest`: cells of the largest tile along each axis.
  SolidTileWork(SolidContext const& context, Int3 const& largest);

  /// The new state of the tile into `next`, its results beside it.
  void step(TileId id);

  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  // solid_tile_fill.cpp
  void gather_row(int j, int k);
  /// Ghosts beyond the box, axis by axis, each from cells that are filled already.
  void fill_side(int axis, bool low);
  void set_inflow(SolidBoundary const& side, Int3 const& cell);
  void extrapolate(std::ptrdiff_t to, std::ptrdiff_t first, std::ptrdiff_t second, int depth) noexcept;
  [[nodiscard]] bool box_ends(int axis, bool low) const noexcept;
  [[nodiscard]] SolidBoundary const& side(int axis, bool low) const noexcept {
    return g_.setup.sides[static_cast<std::size_t>(2 * axis + (low ? 0 : 1))];
  }
  /// Whether the faces there take the boundary's own solution instead of that between two cells.
  [[nodiscard]] bool bounded(int axis, bool low) const noexcept;
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;

  // solid_tile.cpp
  void sweep();
  void set_terms(int j, int k);
  void add_sources(FieldRows const& term, int j, int k) const;
  void faces(int axis, std::ptrdiff_t cell, std::size_t n, FieldRows left, FieldRows right, FieldRows out);
  void boundary_faces(int axis, bool low, Int3 const& cell, std::size_t n, FieldRows terms, FieldRows out);
  void x_faces(int j, int k);
  void y_faces(int j, int k);
  void z_faces(int j, int k);
  void correct(int j, int k, RowBlock* z_lower, RowBlock* z_upper);
  void account(int axis, bool low, FieldRows const& flux, std::ptrdiff_t lane, std::size_t n) noexcept;
  [[nodiscard]] std::size_t slot(int j) const noexcept {
    return static_cast<std::size_t>(g_.swept[2] ? j : ((j % 2) + 2) % 2);
  }
  [[nodiscard]] std::ptrdiff_t index(int i, int j, int k) const noexcept { return origin_ + i + sj_ * j + sk_ * k; }
  [[nodiscard]] FieldRows cells_at(std::ptrdiff_t i) noexcept { return {cells_.data() + i, volume_}; }
  [[nodiscard]] std::ptrdiff_t stride(int axis) const noexcept { return axis == 0 ? 1 : axis == 1 ? sj_ : sk_; }

  SolidContext const& g_;
  bool terms_;  ///< half-step terms are there
  TileId id_ = -1;
  SolidTile* tile_ = nullptr;
  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::array<int, 3> halo_{};
  std::ptrdiff_t sj_ = 0, sk_ = 0, origin_ = 0, volume_ = 0;

  Padded cells_;
  RowBlock gathered_, averaged_left_, averaged_right_, given_, one_face_, source_;
  RowBlock x_terms_, z_new_terms_, z_new_flux_;
  std::array<RowBlock, 2> y_terms_;
  std::vector<RowBlock> z_terms_, x_flux_, y_flux_, z_flux_;  ///< of the rows of a plane
};

}  // namespace g27
