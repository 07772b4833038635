#include "fsi/overset/cut_cells.hpp"

#include <algorithm>
#include <utility>

namespace g27 {

std::vector<CellPart> parts_within(CellKinds const& kinds, int rays) {
  WindowBox const& box = kinds.box();
  CellBlock const near = kinds.near(0);
  std::vector<CellPart> parts, row(static_cast<std::size_t>(box.size[0]));
  std::vector<double> crossings;
  double const piece = 1.0 / (rays * rays), inverse = 1 / box.h;
  for (int k = near.first[2]; k <= near.last[2]; ++k) {
    for (int j = near.first[1]; j <= near.last[1]; ++j) {
      if (kinds.is_image(static_cast<std::size_t>(kinds.index({std::max(0, -box.first[0]), j, k})))) continue;
      Vec3 const middle = kinds.centre({0, j, k});
      for (int ray = 0; ray < rays * rays; ++ray) {
        double const y = middle[1] + ((ray % rays + 0.5) / rays - 0.5) * box.h;
        double const z = middle[2] + ((ray / rays + 0.5) / rays - 0.5) * box.h;
        kinds.crossings(y, z, crossings);
        for (std::size_t n = 0; n + 1 < crossings.size(); n += 2) {
          double const from = crossings[n], to = crossings[n + 1];
          int const last = kinds.cell_of({to, y, z})[0];
          for (int i = kinds.cell_of({from, y, z})[0]; i <= last; ++i) {
            double const x = box.lower[0] + (box.first[0] + i) * box.h;
            double const low = std::max(from, x), high = std::min(to, x + box.h);
            if (high <= low) continue;
            CellPart& p = row[static_cast<std::size_t>(i)];
            double const w = (high - low) * inverse * piece;
            p.share += w, p.moment = p.moment + w * Vec3{0.5 * (low + high), y, z};
          }
        }
      }
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (!(row[i].share > 0)) continue;
        row[i].cell = static_cast<std::size_t>(kinds.index({static_cast<int>(i), j, k}));
        parts.push_back(std::exchange(row[i], {}));
      }
    }
  }
  return parts;
}

}  // namespace g27
