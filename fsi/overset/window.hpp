#pragma once
/// The part of a Cartesian grid around the bodies' surfaces: which medium its cells belong to, and their states.
#include <algorithm>
#include <span>

#include "fsi/overset/mirrors.hpp"

namespace g27 {

/// Kinds of the cells of one medium's grid (OG section 5, the four kinds).
enum class CellKind : unsigned char {
  foreign,  ///< the centre lies in the other medium, and no triangle crosses the cell
  cut,      ///< a triangle crosses it
  shallow,  ///< of the medium, beside a cell that is not: its state is interpolated
  deep      ///< all of its 26 neighbours are of the medium, and it is not one of those that cores compute as well: the
            ///< grid's own scheme updates it
};

/// Uniform cells of one width.
struct WindowBox {
  Vec3 lower{0, 0, 0};  ///< corner of the grid's cell (0, 0, 0) [m]
  double h = 1;         ///< [m]
  Int3 grid{1, 1, 1};   ///< cells of the grid
  Int3 first{0, 0, 0};  ///< first cell of the window, in the grid; negative: an image beyond a mirror
  Int3 size{0, 0, 0};   ///< cells
  Mirrors mirrors{};    ///< on sides of the grid

  /// Lower corner of the window [m].
  [[nodiscard]] Vec3 corner() const noexcept {
    return {lower[0] + first[0] * h, lower[1] + first[1] * h, lower[2] + first[2] * h};
  }
};

/// Points of which the cloud's states are known.
template <class Fields>
struct CloudPoint {
  Vec3 x;
  Fields q;
  int triangle = 0;  ///< whose core it is
  Vec3 foot{};       ///< that triangle's centre
  Image image{0, 0, 0};
};

/// A cell of a window beyond mirrors, and that whose image it is.
struct ImageCell {
  std::size_t cell, of;
  Image image;
};

/// Cells around the surfaces within which are all that interpolation reads, and all images beyond mirrors.
inline constexpr int cells_around = 8;

/// Cells from the first to the last.
struct CellBlock {
  Int3 first{0, 0, 0}, last{-1, -1, -1};

  [[nodiscard]] std::size_t count() const noexcept {
    std::size_t n = 1;
    for (std::size_t a = 0; a < 3; ++a) n *= static_cast<std::size_t>(std::max(0, last[a] - first[a] + 1));
    return n;
  }
};

/// Geometry: kinds of the cells.
class CellKinds {
 public:
  /// `inside`: the medium lies within the surfaces.
  CellKinds(WindowBox const& box, bool inside);

  /// Kinds by where the surfaces are now. The window must reach two cells beyond them, or to the grid's side. A surface
  /// may be open on mirrors.
  void classify(std::span<TriangleSurface const* const> surfaces);

  [[nodiscard]] WindowBox const& box() const noexcept { return box_; }
  [[nodiscard]] std::size_t count() const noexcept { return kinds_.size(); }
  [[nodiscard]] bool holds(Int3 const& cell) const noexcept {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cell[a] < 0 || cell[a] >= box_.size[a]) return false;
    }
    return true;
  }
  /// Cells are numbered from the window's first.
  [[nodiscard]] std::ptrdiff_t index(Int3 const& cell) const noexcept {
    return cell[0] +
           static_cast<std::ptrdiff_t>(box_.size[0]) * (cell[1] + static_cast<std::ptrdiff_t>(box_.size[1]) * cell[2]);
  }
  [[nodiscard]] Int3 cell(std::size_t index) const noexcept;
  [[nodiscard]] Int3 in_grid(Int3 const& cell) const noexcept {
    return {cell[0] + box_.first[0], cell[1] + box_.first[1], cell[2] + box_.first[2]};
  }
  /// Cells of the window that are not of the grid.
  [[nodiscard]] std::span<ImageCell const> images() const noexcept { return images_; }
  [[nodiscard]] bool is_image(std::size_t i) const noexcept { return is_image_[i] != 0; }
  [[nodiscard]] Vec3 centre(Int3 const& cell) const noexcept;
  /// The cell that a point lies in, or the nearest one of the window.
  [[nodiscard]] Int3 cell_of(Vec3 const& x) const noexcept;
  [[nodiscard]] CellKind kind(std::size_t i) const noexcept { return kinds_[i]; }
  [[nodiscard]] CellKind kind_before(std::size_t i) const noexcept { return before_[i]; }
  [[nodiscard]] bool valid(std::size_t i) const noexcept { return kinds_[i] >= CellKind::shallow; }
  /// Whether a point belongs to the medium: by its cell, in a cut one by counting the surfaces along a ray.
  [[nodiscard]] bool in_medium(Vec3 const& x) const noexcept;
  /// Where the line along x through (y, z) crosses the surfaces, and the mirror that closes them: ascending.
  void crossings(double y, double z, std::vector<double>& x) const;
  /// Those of the window that are up to `more` cells away from the box around the surfaces and the cells beside it,
  /// which hold all that is valid and not deep.
  [[nodiscard]] CellBlock near(int more) const noexcept;
  /// Calls f with their indices, ascending.
  template <class F>
  void for_each_near(int more, F const& f) const {
    CellBlock const block = near(more);
    for (int k = block.first[2]; k <= block.last[2]; ++k) {
      for (int j = block.first[1]; j <= block.last[1]; ++j) {
        std::size_t i = static_cast<std::size_t>(index({block.first[0], j, k}));
        for (int n = block.first[0]; n <= block.last[0]; ++n) f(i++);
      }
    }
  }
  /// Of what lies within surfaces: whether the grid's scheme updates a cell up to two away from that of x. Elsewhere,
  /// at tips and in rims, nothing but the cores of the triangles has the medium.
  [[nodiscard]] bool resolved(Vec3 const& x) const noexcept {
    return resolved_[static_cast<std::size_t>(index(cell_of(x)))] != 0;
  }
  /// A foreign or cut cell with a valid one around it.
  [[nodiscard]] bool fringe(std::size_t i) const noexcept { return fringe_[i] != 0; }

 private:
  static constexpr int columns_in_cell = 3;  ///< along y and along z: the fewer triangles over one, the sooner searched
  /// A triangle that lines along x may cross.
  struct Sheet {
    double low_y, high_y, low_z, high_z;  ///< [m]
    std::array<Vec3, 3> corners;
    int surface;
    [[nodiscard]] bool over(double y, double z) const noexcept {
      return y >= low_y && y <= high_y && z >= low_z && z <= high_z;
    }
  };
  /// Number of the column over a point, across the axis a.
  [[nodiscard]] int column_along(std::size_t a, double x) const noexcept {
    return interval((x - box_.lower[a]) * (columns_in_cell / box_.h), columns_in_cell * box_.first[a],
                    columns_in_cell * box_.size[a]);
  }
  /// Which of `count` intervals of length 1 from `first` on x lies in, or the nearest.
  [[nodiscard]] static int interval(double x, int first, int count) noexcept {
    double const at = std::clamp(x, static_cast<double>(first), static_cast<double>(first + count - 1));
    int const n = static_cast<int>(at);
    return n - (at < n ? 1 : 0) - first;
  }
  [[nodiscard]] std::size_t column(int j, int k) const noexcept {
    return static_cast<std::size_t>(j) +
           static_cast<std::size_t>(columns_in_cell * box_.size[1]) * static_cast<std::size_t>(k);
  }
  template <class F>
  void for_each_column(Sheet const& sheet, F const& f) const {
    for (int k = column_along(2, sheet.low_z); k <= column_along(2, sheet.high_z); ++k) {
      for (int j = column_along(1, sheet.low_y); j <= column_along(1, sheet.high_y); ++j) f(column(j, k));
    }
  }
  /// Calls f(x) where the line along x through (y, z) crosses the surfaces, and the mirror that closes them.
  template <class F>
  void for_each_crossing(double y, double z, F const& f) const;
  void mark_cut();
  void mark_sides();
  void mark_depth();
  void leave_to_cores();
  void reflect_kinds();
  void mark_resolved();

  Int3 near_first_{0, 0, 0}, near_last_{-1, -1, -1};  ///< cells of the box around the surfaces and those beside it
  WindowBox box_;
  bool inside_;
  std::vector<CellKind> kinds_, before_;
  std::vector<unsigned char> fringe_, is_image_, resolved_;
  std::vector<ImageCell> images_;
  std::vector<TriangleSurface const*> surfaces_;
  std::vector<double> lids_;               ///< [surface]: the mirror across x that closes it, where one does
  std::vector<Sheet> sheets_;              ///< by surfaces
  std::vector<std::size_t> column_start_;  ///< of the sheets over each column along x, and one more
  std::vector<int> over_;                  ///< their numbers
};

/// Where a line along x through (y, z) crosses a triangle. Lines through an edge or a corner cross exactly one of the
/// triangles that share it (edges are half open), so that counting them is exact.
bool crosses_line(std::array<Vec3, 3> const& triangle, double y, double z, double& x) noexcept;

/// Whether a triangle and a cube of half width `half` about `centre` have a point in common (Akenine-Moeller, J.
/// Graphics Tools 6 (2001) 29: separating axes).
bool touches_cube(std::array<Vec3, 3> const& triangle, Vec3 const& centre, double half) noexcept;

}  // namespace g27
