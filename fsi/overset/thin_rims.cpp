#include "fsi/overset/thin_rims.hpp"

namespace g27 {

namespace {

/// Of the way, each step. Three cubes of 7 cells an edge in a detonation's blast lose their rims after 30 us without;
/// with a share of .3 they hold to 55 us. Tying density and stress as well doubles what the mass gains.
constexpr double share = 0.3;
/// Where the second layer is there and the third is not: this keeps the tips of a tetrahedron stable (a tenth hardly
/// does); more draws the corners of a crushed cube out into fins.
constexpr double share_of_thicker = 0.15;

}  // namespace

bool tie_thin_rims(Body& body) {
  using Velocities = std::array<Vec3, core_layers>;
  double const h = body.setup.cell;
  std::vector<std::pair<std::size_t, Velocities>> tied;
  for (std::size_t n = 0; n < body.triangles.size(); ++n) {
    TriangleState const& t = body.triangles[n];
    if (body.solid.kinds.in_medium(core_centre(t, core_layers, -h))) continue;
    double const part = body.solid.kinds.in_medium(core_centre(t, 1, -h)) ? share_of_thicker : share;
    Velocities u{};
    for (std::size_t k = 0; k < core_layers; ++k) {
      Vec3 const x = core_centre(t, k, -h), own = velocity_of(t.solid[k]);
      u[k] =
          own + part * (velocity_of(body.solid.donors.at(x, Donors<SolidFields>::From::own_update, t.solid[k])) - own);
    }
    tied.push_back({n, u});
  }
  for (auto const& [n, u] : tied) {
    for (std::size_t k = 0; k < core_layers; ++k) {
      for (std::size_t a = 0; a < 3; ++a) body.triangles[n].solid[k][solid_field_of::u + a] = u[k][a];
    }
  }
  return !tied.empty();
}

}  // namespace g27
