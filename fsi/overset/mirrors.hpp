#pragma once
/// Sides of the domain that are symmetry planes: what lies beyond them is the mirror image of what lies within.
///
/// Only the part of a body within the domain is there: an open surface whose border lies on the planes. What needs
/// neighbours beyond a plane (interpolation, classification of cells) sees images of cells and of cloud points.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fsi/overset/clamps.hpp"
#include "fsi/overset/fields.hpp"
#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

/// Which planes a thing is mirrored at: by axis -1 the lower, 1 the upper one, 0 none.
using Image = std::array<int, 3>;

/// Planes of symmetry, at most two an axis.
struct Mirrors {
  std::array<bool, 3> low{}, high{};
  Vec3 lower{0, 0, 0}, upper{0, 0, 0};  ///< where they are [m]
  Clamps clamps{};                      ///< those among them that bodies are bonded to instead

  [[nodiscard]] bool any() const noexcept { return low[0] || low[1] || low[2] || high[0] || high[1] || high[2]; }
  [[nodiscard]] bool across(std::size_t axis) const noexcept { return low[axis] || high[axis]; }
  /// Where the image of x lies.
  [[nodiscard]] Vec3 image(Vec3 x, Image const& at) const noexcept {
    for (std::size_t a = 0; a < 3; ++a) {
      if (at[a] != 0) x[a] = 2 * (at[a] < 0 ? lower[a] : upper[a]) - x[a];
    }
    return x;
  }
  /// The point of the domain whose image x is; never on an upper plane, where lines would miss what ends on it.
  [[nodiscard]] Vec3 within(Vec3 x) const noexcept {
    for (std::size_t a = 0; a < 3; ++a) {
      if (low[a] && x[a] < lower[a]) x[a] = 2 * lower[a] - x[a];
      if (high[a] && x[a] >= upper[a]) x[a] = std::min(2 * upper[a] - x[a], std::nextafter(upper[a], lower[a]));
    }
    return x;
  }
  /// The image that a point beyond the planes belongs to.
  [[nodiscard]] Image image_at(Vec3 const& x) const noexcept {
    Image at{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a) at[a] = low[a] && x[a] < lower[a] ? -1 : high[a] && x[a] >= upper[a] ? 1 : 0;
    return at;
  }
  /// Calls f(Image) for every image of the domain that touches it.
  template <class F>
  void for_each(F const& f) const {
    for (int z = low[2] ? -1 : 0; z <= (high[2] ? 1 : 0); ++z) {
      for (int y = low[1] ? -1 : 0; y <= (high[1] ? 1 : 0); ++y) {
        for (int x = low[0] ? -1 : 0; x <= (high[0] ? 1 : 0); ++x) {
          if (x != 0 || y != 0 || z != 0) f(Image{x, y, z});
        }
      }
    }
  }
};

/// Components of a vector and of a state in an image.
inline Vec3 reflected(Vec3 v, Image const& at) noexcept {
  for (std::size_t a = 0; a < 3; ++a) v[a] = at[a] != 0 ? -v[a] : v[a];
  return v;
}
GasFields reflected(GasFields q, Image const& at) noexcept;
SolidFields reflected(SolidFields q, Image const& at) noexcept;
/// The same where some of the planes may be clamps: of a body.
Vec3 reflected(Vec3 v, Image const& at, Clamps const& clamps) noexcept;
SolidFields reflected(SolidFields q, Image const& at, Clamps const& clamps) noexcept;
/// Of gas, to which a clamp is a wall as any other.
inline GasFields reflected(GasFields const& q, Image const& at, Clamps const&) noexcept { return reflected(q, at); }

/// Where planes of symmetry cut a body.
struct Cut {
  Mirrors mirrors;                             ///< those planes alone
  std::vector<std::array<bool, 3>> on_planes;  ///< [vertex]: stays where it is along these axes; on clamps along all
};

/// The planes that the border of a surface lies on, within a tolerance [m]; its vertices are moved onto them. Throws
/// SurfaceError for a border that lies elsewhere, for a body that both planes across x cut, and for a clamp that does
/// not cut it.
Cut find_cut(TriangleSurface& surface, Mirrors const& planes, double tolerance);

}  // namespace g27
