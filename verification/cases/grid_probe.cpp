#include "verification/cases/grid_probe.hpp"

#include <algorithm>
#include <cmath>

#include "scheme/grid/cell_place.hpp"

namespace g27 {

double GridProbe::cell(Int3 const& at) const { return values_[cell_number(grid_.cells(), at)]; }

double GridProbe::at(Vec3 const& x) const {
  Int3 const n = grid_.cells();
  Vec3 const first = grid_.centre({0, 0, 0}), widths = grid_.widths();
  Int3 low{};
  Vec3 share{};
  for (std::size_t d = 0; d < 3; ++d) {
    if (n[d] < 2) continue;
    double const place = std::clamp((x[d] - first[d]) / widths[d], 0.0, n[d] - 1.0);
    low[d] = std::min(static_cast<int>(place), n[d] - 2);
    share[d] = place - low[d];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Int3 at = low;
    double weight = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      int const up = (corner >> d) & 1;
      weight *= up ? share[d] : 1 - share[d];
      at[d] += up;
    }
    if (weight > 0) sum += weight * cell(at);
  }
  return sum;
}

double GridProbe::least() const { return *std::min_element(values_.begin(), values_.end()); }

double GridProbe::most() const { return *std::max_element(values_.begin(), values_.end()); }

double GridProbe::front(Vec3 const& origin, Vec3 const& direction, double length, double level) const {
  Vec3 const h = grid_.widths();
  double const step = 0.25 * std::min(h[0], h[1]);
  auto const value = [&](double s) {
    return at({origin[0] + s * direction[0], origin[1] + s * direction[1], origin[2] + s * direction[2]});
  };
  double outer = length, beyond = value(outer);
  while (outer > 0) {
    double const inner = outer - step, here = value(inner);
    if (here > level && beyond <= level) return inner + step * (here - level) / (here - beyond);
    outer = inner, beyond = here;
  }
  return 0;
}

}  // namespace g27
