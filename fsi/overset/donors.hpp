#pragma once
/// States at any point of a medium from its cells and from the cloud, the cores of the triangles' local grids.
///
/// Of gas, and of solids at tips and in rims (CellKinds::resolved): where the eight cells around the point are valid,
/// multilinear; else a weighted linear least-squares fit to the valid cells and the cloud within 1.6 cells. Density,
/// pressure and stress stay within the donors' range, velocities may leave it by one range: bounds that a rotation
/// meets would take its angular momentum.
///
/// Of solids elsewhere, and for local grids within an elastic body: a quadratic fit to them, and all but the plastic
/// strain may leave the donors' range by one range; beside what is crushed a linear one.
///
/// Of gas the densities of mass, momentum and energy are interpolated, which is what cells and cores hold: halfway
/// across a shock the momentum of the mean density and the mean velocity is not the mean momentum.
#include "fsi/overset/fit_kernels.hpp"
#include "fsi/overset/literal.hpp"
#include "fsi/overset/window.hpp"

namespace g27 {

/// Plastic strain from which on a solid's fields are taken to change from cell to cell, as where a charge crushes a
/// cube: such donors are fitted linearly, and the switch of the model problems acts on small bends. See fsi/README.md.
inline constexpr double crushed = 0.3;

template <class Fields>
class Donors {
 public:
  static constexpr bool of_gas = std::tuple_size_v<Fields> == gas_field::count;
  using Law = std::conditional_t<of_gas, AnyEos, AnySolid>;

  /// The states of the cells are by the window's index. They may change, but not move once there is a cloud.
  Donors(CellKinds const& kinds, std::vector<Fields> const& states, Law const& law, Literal const& literal = {})
      : kinds_(kinds), states_(states), law_(law), literal_(literal) {}

  [[nodiscard]] Law const& law() const noexcept { return law_; }
  /// To be called when the states of cells have changed.
  void update(int threads);
  /// To be called when the kinds of cells have changed, as well. `dense`: many points of gas in a cell, so that those
  /// in one octant of it become one.
  void set_cloud(std::vector<CloudPoint<Fields>> const& points, bool dense);

  /// Which cells give.
  enum class From {
    valid,      ///< all that are of the medium
    own_update  ///< those that the grid's scheme has updated and that still are of the medium
  };
  /// `otherwise`: where nothing is near.
  [[nodiscard]] Fields at(Vec3 const& x, From from, Fields const& otherwise) const {
    return at(x, from, otherwise, curved(x));
  }
  /// The same, linear everywhere.
  [[nodiscard]] Fields linear_at(Vec3 const& x, From from, Fields const& otherwise) const {
    return at(x, from, otherwise, false);
  }

  /// Donors about a place: where they are, in cells of the window, and their states, which must not change meanwhile.
  class Gathered {
   public:
    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    /// Those within `radius` of a cube of half width `half` about `middle` along the frame's axes, in cells.
    void take(Donors const& donors, From from, Vec3 const& middle, Frame const& frame, double half, double radius);
    struct Kind {
      Law const& law;
      bool quadratic;  ///< of solids alone
      double excess;   ///< what may leave the donors' range does so on either side by this part of its width, at most
    };
    /// The fit at x to all of them.
    void fit(Vec3 const& x, Kind const& kind, Fields& out);
    /// To those within `radius`; false if these are fewer than `fewest`.
    bool fit(Vec3 const& x, double radius, std::size_t fewest, Kind const& kind, Fields& out);

   private:
    bool fit(std::span<DonorRange const> ranges, Vec3 const& x, double radius, std::size_t fewest, Kind const& kind,
             Fields& out);
    std::size_t count_ = 0;
    std::vector<double> x_, y_, z_, energy_;
    std::vector<double const*> row_;
    int first_j_ = 0, last_j_ = -1, first_k_ = 0, last_k_ = -1;  ///< rows of cells that they lie in
    std::vector<std::size_t> ends_;                              ///< [row] of the donors in it
    std::vector<DonorRange> ranges_;
    std::vector<int> near_;
    std::vector<double> weight_, rx_, ry_, rz_, bend_;  ///< scratch of the kernels
  };

  /// Donors that are valid about a place, collected once for the many points of a local grid. As long as donors and
  /// cloud stay as they are.
  class Around {
   public:
    explicit Around(Donors const& donors) : donors_(donors) {}
    /// For points up to a cell from `centre` along each of the frame's axes.
    void reset(Vec3 const& centre, Frame const& frame);
    /// `inner`: no side of the medium but the contact is near; fitted as where the medium is resolved.
    [[nodiscard]] Fields at(Vec3 const& x, Fields const& otherwise, bool inner = false);

   private:
    Donors const& donors_;
    Gathered near_;
  };

  /// Calls f with the cloud's points in the cells up to `cells` away from that of x.
  template <class F>
  void for_each_near(Vec3 const& x, int cells, F const& f) const {
    Int3 const c = kinds_.cell_of(x), size = kinds_.box().size;
    auto const from = [&](std::size_t a) { return std::max(0, c[a] - cells); };
    auto const to = [&](std::size_t a) { return std::min(size[a] - 1, c[a] + cells); };
    for (int k = from(2); k <= to(2); ++k) {
      for (int j = from(1); j <= to(1); ++j) {
        auto const [first, last] = in_row(from(0), to(0), j, k);
        for (std::size_t p = first; p < last; ++p) f(cloud_[p]);
      }
    }
  }

 private:
  void list_by_cells();
  /// Points in one octant of a cell become one, their mean by densities.
  void merge_cloud() requires of_gas;
  [[nodiscard]] bool gives(std::size_t i, From from) const noexcept {
    if (from == From::own_update) return kinds_.valid(i) && kinds_.kind_before(i) == CellKind::deep;
    return literal_.deep_donors ? kinds_.kind(i) == CellKind::deep : kinds_.valid(i);
  }
  [[nodiscard]] bool curved(Vec3 const& x) const noexcept { return !of_gas && kinds_.resolved(x); }
  [[nodiscard]] typename Gathered::Kind kind(bool curved) const noexcept {
    return {.law = law_, .quadratic = curved, .excess = literal_.clipped_velocities ? 0.0 : 1.0};
  }
  [[nodiscard]] Fields at(Vec3 const& x, From from, Fields const& otherwise, bool curved) const;
  /// The cloud's points in the cells (i0..i1, j, k): from the first to before the second.
  [[nodiscard]] std::array<std::size_t, 2> in_row(int i0, int i1, int j, int k) const noexcept {
    CellBlock const& b = block_;
    i0 = std::max(i0, b.first[0]), i1 = std::min(i1, b.last[0]);
    if (i0 > i1 || j < b.first[1] || j > b.last[1] || k < b.first[2] || k > b.last[2]) return {0, 0};
    return {first_[in_block({i0, j, k})], first_[in_block({i1, j, k}) + 1]};
  }
  [[nodiscard]] std::size_t in_block(Int3 const& c) const noexcept {
    auto const along = [&](std::size_t a) { return static_cast<std::size_t>(c[a] - block_.first[a]); };
    auto const size = [&](std::size_t a) { return static_cast<std::size_t>(block_.last[a] - block_.first[a] + 1); };
    return along(0) + size(0) * (along(1) + size(1) * along(2));
  }
  [[nodiscard]] Vec3 in_cells(Vec3 const& x) const noexcept {
    WindowBox const& box = kinds_.box();
    Vec3 at{};
    for (std::size_t a = 0; a < 3; ++a) at[a] = (x[a] - box.lower[a]) / box.h - box.first[a];
    return at;
  }
  [[nodiscard]] bool multilinear(Vec3 const& x, From from, Fields& out) const;

  CellKinds const& kinds_;
  std::vector<Fields> const& states_;
  Law law_;
  Literal literal_;
  std::vector<double> energy_, cloud_energy_;  ///< of gas, total per mass, of the valid cells and of the cloud [J/kg]
  std::vector<CloudPoint<Fields>> cloud_;      ///< in the order of the cells they lie in
  CellBlock block_;                            ///< cells of the window that the cloud can lie in
  std::vector<std::size_t> first_;             ///< of the points in each cell of the block, and one more
  /// Cells that give and the cloud's points in one list, by the cells that they lie in: places in cells of the window,
  /// along x by From, where those that do not give are far away; states, and of gas where their energies are.
  std::array<std::vector<double>, 2> x_;
  std::vector<double> y_, z_;
  std::vector<double const*> row_, energy_at_;
  std::vector<std::size_t> start_;  ///< of the donors in each cell of the window, and one more
};

extern template class Donors<GasFields>;
extern template class Donors<SolidFields>;

}  // namespace g27
