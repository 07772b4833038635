#pragma once
/// The split of a Cartesian box into tiles, along the Morton curve: who is next to whom, and who owns which. Knows
/// nothing of what the tiles hold.
#include <cstdint>
#include <span>
#include <vector>

#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

/// Position of a tile on the curve.
using TileId = std::int64_t;

struct TileBox {
  Int3 first{0, 0, 0}, size{0, 0, 0};  ///< cells
};

struct TileNeighbour {
  TileId id;
  Int3 direction;        ///< -1, 0 or 1 along each axis
  int level_difference;  ///< of refinement; 0 on a uniform grid
};

class Tiling {
 public:
  /// `tile`: cells of a tile along each axis, where the box allows; sides of solid blocks are sides of tiles. Tiles in
  /// blocks do not exist.
  Tiling(Int3 const& cells, Int3 const& tile, std::array<bool, 3> const& periodic, std::span<SolidBlock const> blocks);

  [[nodiscard]] TileId count() const noexcept { return static_cast<TileId>(boxes_.size()); }
  [[nodiscard]] TileBox const& box(TileId id) const noexcept { return boxes_[static_cast<std::size_t>(id)]; }
  /// Tile of a cell of the box, -1 in a solid block.
  [[nodiscard]] TileId at(Int3 const& cell) const noexcept;
  /// Tile beside `id`, -1 where the box or a block ends; `direction` in -1, 0, 1 along each axis.
  [[nodiscard]] TileId beside(TileId id, Int3 const& direction) const noexcept {
    return beside_[static_cast<std::size_t>(id)][slot(direction)];
  }
  /// Whether the box ends in that direction along the axis; otherwise a block or a tile is there.
  [[nodiscard]] bool at_side(TileId id, int axis, int direction) const noexcept;
  /// All tiles that touch `id`, in the order of (id, direction); a small periodic box lists one several times.
  [[nodiscard]] std::vector<TileNeighbour> neighbours(TileId id) const;

  /// Cuts the curve into `parts` runs of about equal weight: run r holds [first[r], first[r + 1]).
  [[nodiscard]] static std::vector<TileId> partition(std::span<double const> weights, int parts);
  [[nodiscard]] static int owner(std::span<TileId const> first, TileId id) noexcept;

 private:
  static std::size_t slot(Int3 const& d) noexcept {
    return static_cast<std::size_t>((d[0] + 1) + 3 * (d[1] + 1) + 9 * (d[2] + 1));
  }
  [[nodiscard]] TileId in_column(Int3 const& column) const noexcept {
    return columns_[static_cast<std::size_t>(column[0] + counts_[0] * (column[1] + counts_[1] * column[2]))];
  }

  std::array<std::vector<int>, 3> edges_;  ///< first cell of every column of tiles, and the end
  Int3 counts_{0, 0, 0};
  std::vector<TileId> columns_;  ///< by column, x fastest; -1: solid
  std::vector<TileBox> boxes_;
  std::vector<Int3> position_;  ///< columns of a tile
  std::vector<std::array<TileId, 27>> beside_;
};

}  // namespace g27
