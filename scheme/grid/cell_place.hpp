#pragma once
/// Where the cells of a box lie: in space, in the tiles and in their rows.
#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

inline constexpr std::ptrdiff_t vector_cells = 8;  ///< the widest vector of any instruction set

/// Doubles from one row of a tile to the next: its cells, rounded up to a vector.
inline std::ptrdiff_t padded_row(int cells) noexcept {
  return (cells + vector_cells - 1) / vector_cells * vector_cells;
}

inline std::size_t cells_in(Int3 const& cells) noexcept {
  return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]);
}

/// Number of a cell in an array over a box, x fastest.
inline std::size_t cell_number(Int3 const& cells, Int3 const& cell) noexcept {
  return static_cast<std::size_t>(cell[0]) +
         static_cast<std::size_t>(cells[0]) * (static_cast<std::size_t>(cell[1]) +
                                               static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cell[2]));
}

/// Calls f(Int3) with every cell of a box, x fastest.
template <class F>
void for_each_cell(Int3 const& cells, F const& f) {
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) f(Int3{i, j, k});
    }
  }
}

/// Axes with more than one cell; the others are not swept.
inline std::array<bool, 3> swept_axes(Int3 const& cells) noexcept { return {cells[0] > 1, cells[1] > 1, cells[2] > 1}; }

/// Widths of the cells of a box [m]; 1 along axes that are not there.
inline Vec3 cell_widths(Vec3 const& lower, Vec3 const& upper, Int3 const& cells) noexcept {
  Vec3 h{1, 1, 1};
  for (std::size_t a = 0; a < 3; ++a) {
    if (cells[a] > 1) h[a] = (upper[a] - lower[a]) / static_cast<double>(cells[a]);
  }
  return h;
}

/// Centre of a cell [m]; the lower corner of the box along axes that are not there.
inline Vec3 cell_centre(Vec3 const& lower, Vec3 const& h, std::array<bool, 3> const& swept, Int3 const& cell) noexcept {
  Vec3 x{};
  for (std::size_t a = 0; a < 3; ++a) x[a] = lower[a] + (swept[a] ? static_cast<double>(cell[a]) + 0.5 : 0.0) * h[a];
  return x;
}

/// Where a row or a column of cells lies along an axis on which the tile has n: before it (-1), in it or behind it (1).
inline int region_of(int i, int n) noexcept { return i < 0 ? -1 : i >= n ? 1 : 0; }
/// Index of that cell in the tile of its region, which has other_n.
inline int local_index(int i, int n, int other_n) noexcept { return i < 0 ? other_n + i : i >= n ? i - n : i; }

}  // namespace g27
