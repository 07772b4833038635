/// Whether the cells hold the mass of a charge: where they are few, they do not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scheme/grid/cell_place.hpp"
#include "scheme/step/gauss.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

constexpr double worth_telling = 0.05;

std::vector<std::string> remarks(Charge const& charge, double held, double exact) {
  if (std::fabs(held - exact) <= worth_telling * exact) return {};
  return {fmt::format("{}.radius: the cells hold {:.3g} times the mass of the charge; take smaller cells",
                      charge.section.path(), held / exact)};
}

/// Part of the points of a lattice over the cells [first, last), `parts` a cell along each axis, that lie in the shape.
double share(std::function<double(Vec3 const&)> const& shape, GasGridSetup const& grid, Int3 const& first,
             Int3 const& last, int parts) {
  Vec3 h = cell_widths(grid.lower, grid.upper, grid.cells), corner{};
  auto const swept = swept_axes(grid.cells);
  Int3 count{1, 1, 1};
  for (std::size_t a = 0; a < 3; ++a) {
    corner[a] = grid.lower[a] + (swept[a] ? first[a] * h[a] : 0);
    if (swept[a]) count[a] = (last[a] - first[a]) * parts, h[a] /= parts;
  }
  std::size_t inside = 0;
  for_each_cell(count, [&](Int3 const& c) { inside += shape(cell_centre(corner, h, swept, c)) <= 0 ? 1 : 0; });
  return static_cast<double>(inside) / static_cast<double>(cells_in(count));
}

}  // namespace

std::vector<std::string> mass_remarks(Charge const& charge, Symmetry symmetry, std::vector<double> const& faces) {
  double held = 0, exact = 0;
  for (std::size_t i = 0; i + 1 < faces.size() && faces[i] < charge.radius; ++i) {
    auto const mass = [&](double from, double to) {
      double sum = 0;
      double const weights = cell_quadrature(symmetry, from, to, 5, [&](double x, double weight) {
        if (x >= 0 && x <= charge.radius) sum += weight * charge.state(x).rho;
      });
      return sum / weights * measure_between(symmetry, from, to);
    };
    held += mass(faces[i], faces[i + 1]);
    constexpr int parts = 20;  // of a cell, up to the surface
    double const from = std::max(faces[i], 0.0), width = (std::min(faces[i + 1], charge.radius) - from) / parts;
    for (int k = 0; k < parts && width > 0; ++k) exact += mass(from + k * width, from + (k + 1) * width);
  }
  return remarks(charge, held, exact);
}

std::vector<std::string> mass_remarks(Charge const& charge, std::function<double(Vec3 const&)> const& shape,
                                      GasGridSetup const& grid) {
  constexpr double many = 20;  // cells a radius, of which the mass is right
  constexpr int points = 64;   // along the longest axis
  Vec3 const h = cell_widths(grid.lower, grid.upper, grid.cells);
  Int3 first{0, 0, 0}, last{1, 1, 1};
  int most = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    if (grid.cells[a] == 1) continue;
    if (charge.radius > many * h[a]) return {};
    auto const cell = [&](double x) { return std::clamp((x - grid.lower[a]) / h[a], 0.0, double(grid.cells[a])); };
    first[a] = static_cast<int>(std::floor(cell(charge.centre[a] - charge.radius)));
    last[a] = static_cast<int>(std::ceil(cell(charge.centre[a] + charge.radius)));
    most = std::max(most, last[a] - first[a]);
  }
  // what has burnt is there by the mean over points of each cell
  int const parts = !charge.burn.there() ? (grid.cells[2] > 1 ? 8 : 16) : 1;
  return remarks(charge, share(shape, grid, first, last, parts),
                 share(shape, grid, first, last, std::max(points / most, 1)));
}

}  // namespace g27
