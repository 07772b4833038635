#include "fsi/overset/asleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace g27 {

namespace {

namespace field = solid_field_of;

constexpr double reach = 6;  ///< cells of gas beyond the body's box that its local grids and their donors lie in

/// At rest without deviatoric stress, and p within `close` of `pressure`.
bool at_rest(SolidFields const& q, double pressure, double close) noexcept {
  for (std::size_t f = 0; f < q.size(); ++f) {
    bool const zero = (f >= field::u && f < field::p) || (f >= field::S && f < field::ep);
    if (zero && q[f] != 0) return false;
  }
  return std::fabs(q[field::p] - pressure) <= close;
}

}  // namespace

bool asleep(Body const& body) {
  if (body.rigid && body.rigid->driven()) return false;
  double const eps = std::numeric_limits<double>::epsilon();
  GasFields const& gas = body.triangles[0].gas[0];
  SolidFields const& solid = body.triangles[0].solid[0];
  double const p = gas[gas_field::p];
  double const K =
      std::visit([&](auto const& eos) { return eos.bulk_modulus(solid[0], solid[field::p]); }, body.setup.material.eos);
  double const close = 8 * eps * K;
  auto const still = [&](GasFields const& q) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (q[gas_field::u + c] != 0) return false;
    }
    return std::fabs(q[gas_field::rho] - gas[gas_field::rho]) <= 4 * eps * gas[gas_field::rho] &&
           std::fabs(q[gas_field::p] - p) <= 16 * eps * p;
  };
  for (TriangleState const& t : body.triangles) {
    if (length(t.velocity) != 0 || t.pressure != p) return false;
    if (!std::all_of(t.gas.begin(), t.gas.end(), still)) return false;
    if (body.rigid) continue;
    for (SolidFields const& q : t.solid) {
      if (!at_rest(q, p, close)) return false;
    }
  }
  bool quiet = true;
  body.solid.kinds.for_each_near(0, [&](std::size_t i) {
    quiet = quiet && (!body.solid.kinds.valid(i) || at_rest(body.solid.states[i], p, close));
  });
  if (!quiet) return false;
  // What comes, comes through deep cells: there the last bit counts.
  CellKinds const& kinds = body.gas.kinds;
  GasFields const* deep = nullptr;
  auto const [lower, upper] = bounding_box(body.surface);
  Vec3 const around = reach * kinds.box().h * Vec3{1, 1, 1};
  Int3 const first = kinds.cell_of(lower - around), last = kinds.cell_of(upper + around);
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int i = first[0]; i <= last[0]; ++i) {
        std::size_t const n = static_cast<std::size_t>(kinds.index({i, j, k}));
        if (!kinds.valid(n)) continue;
        GasFields const& q = body.gas.states[n];
        if (!still(q)) return false;
        if (kinds.kind(n) != CellKind::deep) continue;
        if (deep == nullptr) deep = &q;
        if (q != *deep) return false;
      }
    }
  }
  // of other bodies as well
  int const most = *std::max_element(kinds.box().size.begin(), kinds.box().size.end());
  body.gas.donors.for_each_near(lower, most, [&](CloudPoint<GasFields> const& c) { quiet = quiet && still(c.q); });
  return quiet;
}

}  // namespace g27
