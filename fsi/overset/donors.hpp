#pragma once
/// States at any point of a medium from its cells and from the cloud, the cores of the triangles' local grids.
///
/// Where the eight cells around the point are valid, multilinear; else a weighted linear least-squares fit to the valid
/// cells and the cloud within 1.6 cells. Density, pressure and stress stay within the donors' range, velocities may
/// leave it by one range: bounds that a rotation meets would take its angular momentum.
#include "fsi/overset/window.hpp"

namespace g27 {

template <class Fields>
class Donors {
 public:
  /// The states of the cells are by the window's index.
  Donors(CellKinds const& kinds, std::vector<Fields> const& states) : kinds_(kinds), states_(states) {}

  void set_cloud(std::vector<CloudPoint<Fields>> points);

  /// Which cells give.
  enum class From {
    valid,      ///< all that are of the medium
    own_update  ///< those that the grid's scheme has updated and that still are of the medium
  };
  /// `otherwise`: where nothing is near.
  [[nodiscard]] Fields at(Vec3 const& x, From from, Fields const& otherwise) const;

  /// Donors that are valid about a place, collected once for the many points of a local grid.
  class Around {
   public:
    /// For points up to `radius` cells from `centre`.
    void reset(Donors const& donors, Vec3 const& centre, double radius);
    [[nodiscard]] Fields at(Vec3 const& x, Fields const& otherwise) const;

   private:
    Donors const* donors_ = nullptr;
    Vec3 centre_{0, 0, 0};  ///< in cells of the window
    std::vector<double> x_, y_, z_;
    std::vector<Fields const*> q_;
  };

  /// Calls f with the cloud's points in the cells up to `cells` away from that of x.
  template <class F>
  void for_each_near(Vec3 const& x, int cells, F const& f) const {
    Int3 const c = kinds_.cell_of(x), size = kinds_.box().size;
    auto const from = [&](std::size_t a) { return std::max(0, c[a] - cells); };
    auto const to = [&](std::size_t a) { return std::min(size[a] - 1, c[a] + cells); };
    for (int k = from(2); k <= to(2); ++k) {
      for (int j = from(1); j <= to(1); ++j) {
        for (int i = from(0); i <= to(0); ++i) {
          int p = head_[static_cast<std::size_t>(kinds_.index({i, j, k}))];
          for (; p >= 0; p = cloud_[static_cast<std::size_t>(p)].next) f(cloud_[static_cast<std::size_t>(p)]);
        }
      }
    }
  }

 private:
  struct Donor {
    Vec3 r;  ///< from the point, in cells
    Fields const* q;
  };
  [[nodiscard]] bool gives(std::size_t i, From from) const noexcept {
    return kinds_.valid(i) && (from == From::valid || kinds_.kind_before(i) == CellKind::deep);
  }
  void gather(Vec3 const& x, double radius, From from, std::vector<Donor>& out) const;
  [[nodiscard]] bool multilinear(Vec3 const& x, From from, Fields& out) const;
  [[nodiscard]] static Fields fit(std::vector<Donor> const& donors);
  static void bound(Fields& q, Fields const& low, Fields const& high) noexcept;

  CellKinds const& kinds_;
  std::vector<Fields> const& states_;
  std::vector<CloudPoint<Fields>> cloud_;
  std::vector<int> head_;  ///< first cloud point in each cell of the window
};

extern template class Donors<GasFields>;
extern template class Donors<SolidFields>;

}  // namespace g27
