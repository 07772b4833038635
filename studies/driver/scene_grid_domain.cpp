/// [domain] of a grid: its box and cells, and the blocks in it.
#include <fmt/format.h>

#include <cmath>

#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

constexpr int fewest_cells = 4, most_along = 8192;
constexpr double most_grid_cells = 2e9;

std::array<int, 3> read_counts(Section const& domain, std::vector<std::array<double, 2>> const& extent) {
  std::array<int, 3> out{1, 1, 1};
  if (domain.has("cells") == domain.has("cell")) {
    throw domain.error("cells", domain.has("cells") ? "and cell are both given" : "is missing",
                       "give either cells = [100, 100, 100] or cell = \"1 mm\"");
  }
  if (domain.has("cells")) {
    return domain.counts("cells", extent.size(), fewest_cells, most_along);
  }
  double const width = domain.positive("cell", dimension::length);
  for (std::size_t d = 0; d < extent.size(); ++d) {
    double const exact = (extent[d][1] - extent[d][0]) / width, count = std::round(exact);
    if (!(count >= fewest_cells && count <= most_along)) {
      throw domain.error("cell", fmt::format("makes {:.4g} cells along {}", count, ray_names()[d]),
                         fmt::format("choose it for {} to {} cells", fewest_cells, most_along));
    }
    if (std::fabs(exact - count) > 1e-6 * count) {
      throw domain.error("cell", fmt::format("makes {:.6g} cells along {}", exact, ray_names()[d]),
                         "choose it for a whole number of cells, or give cells = [...]");
    }
    out[d] = static_cast<int>(count);
  }
  return out;
}

}  // namespace

bool is_grid(Section const& domain) {
  Node const* extent = domain.node().find("extent");
  auto const* list = extent != nullptr ? std::get_if<Node::Array>(&extent->value) : nullptr;
  return list != nullptr && !list->empty() && std::holds_alternative<Node::Array>(list->front().value);
}

int dimensions_of(GridBox const& box) { return box.cells[2] > 1 ? 3 : 2; }

GridBox read_box(Section const& domain) {
  auto const extent = domain.intervals("extent", dimension::length);
  if (extent.size() != 2 && extent.size() != 3) {
    throw domain.error("extent", fmt::format("has {} intervals", extent.size()),
                       "give two or three, or [start, end] for one dimension");
  }
  for (char const* key : {"symmetry", "mesh", "motion"}) {
    if (domain.has(key)) {
      throw domain.error(key, "is for one dimension", "remove it: a grid is Cartesian, uniform and fixed");
    }
  }
  GridBox box{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cells = read_counts(domain, extent)};
  double count = 1;
  for (std::size_t d = 0; d < extent.size(); ++d) {
    box.lower[d] = extent[d][0], box.upper[d] = extent[d][1];
    count *= box.cells[d];
  }
  if (count > most_grid_cells) {
    throw domain.error(domain.has("cells") ? "cells" : "cell", fmt::format("makes {:.3g} cells", count),
                       fmt::format("choose it for {:.0g} cells or fewer", most_grid_cells));
  }
  return box;
}

std::vector<SolidBlock> read_blocks(Section const& root, GridBox const& box) {
  auto const dimensions = static_cast<std::size_t>(dimensions_of(box));
  std::vector<SolidBlock> out;
  for (Section const& section : root.tables("block", {"extent"})) {
    auto const extent = section.intervals("extent", dimension::length);
    if (extent.size() != dimensions) {
      throw section.error("extent", fmt::format("has {} intervals", extent.size()),
                          fmt::format("give {}, one an axis", dimensions));
    }
    SolidBlock block{.first = {0, 0, 0}, .last = {1, 1, 1}};
    for (std::size_t d = 0; d < dimensions; ++d) {
      double const h = (box.upper[d] - box.lower[d]) / box.cells[d];
      auto const face = [&](double x) {
        return static_cast<int>(std::lround(std::clamp((x - box.lower[d]) / h, 0.0, double(box.cells[d]))));
      };
      block.first[d] = face(extent[d][0]), block.last[d] = face(extent[d][1]);
      int const inside = block.last[d] - block.first[d], below = block.first[d], above = box.cells[d] - block.last[d];
      auto const tight = [](int cells) { return cells > 0 && cells < fewest_cells; };
      if (inside < fewest_cells || tight(below) || tight(above)) {
        throw section.error("extent",
                            fmt::format("takes {} cells along {}, with {} before and {} after it", inside,
                                        ray_names()[d], below, above),
                            fmt::format("make it {0} cells ({1:.4g} m) or more, with none or {0} beside it",
                                        fewest_cells, fewest_cells * h));
      }
    }
    out.push_back(block);
  }
  return out;
}

std::vector<std::array<double, 2>> extent_of(SolidBlock const& block, GridBox const& box) {
  std::vector<std::array<double, 2>> out;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_of(box)); ++d) {
    double const h = (box.upper[d] - box.lower[d]) / box.cells[d];
    out.push_back({box.lower[d] + h * block.first[d], box.lower[d] + h * block.last[d]});
  }
  return out;
}

double distance_to_block(SolidBlock const& block, GridBox const& box, Vec3 const& x) {
  auto const extent = extent_of(block, box);
  double squared = 0;
  for (std::size_t d = 0; d < extent.size(); ++d) {
    double const gap = std::max({0.0, extent[d][0] - x[d], x[d] - extent[d][1]});
    squared += gap * gap;
  }
  return std::sqrt(squared);
}

}  // namespace g27
