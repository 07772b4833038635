#include "scheme/grid/tiling.hpp"

#include <algorithm>
#include <numeric>

namespace g27 {

namespace {

/// Cuts [0, cells) at `stops` and each piece into tiles of about `tile` cells; lengths are multiples of 8 where they
/// can.
std::vector<int> cut(int cells, int tile, std::vector<int> stops) {
  stops.push_back(0), stops.push_back(cells);
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  std::vector<int> edges;
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    int const length = stops[s + 1] - stops[s], pieces = std::max(1, (length + tile - 1) / tile);
    int const even = (length + pieces - 1) / pieces, step = even >= 16 ? (even + 7) / 8 * 8 : even;
    // a last piece of less than four cells joins the one before it
    for (int x = stops[s]; x < stops[s + 1]; x += step) {
      if (x == stops[s] || stops[s + 1] - x >= 4) edges.push_back(x);
    }
  }
  edges.push_back(cells);
  return edges;
}

/// Interleaves the bits of the three columns.
std::uint64_t morton(Int3 const& c) noexcept {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 21; ++bit) {
    for (int a = 0; a < 3; ++a) {
      code |= ((static_cast<std::uint64_t>(c[static_cast<std::size_t>(a)]) >> bit) & 1u) << (3 * bit + a);
    }
  }
  return code;
}

int column_of(std::vector<int> const& edges, int cell) noexcept {
  return static_cast<int>(std::upper_bound(edges.begin(), edges.end(), cell) - edges.begin()) - 1;
}

}  // namespace

Tiling::Tiling(Int3 const& cells, Int3 const& tile, std::array<bool, 3> const& periodic,
               std::span<SolidBlock const> blocks) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<int> stops;
    for (SolidBlock const& b : blocks) {
      for (int x : {b.first[a], b.last[a]}) {
        if (x > 0 && x < cells[a]) stops.push_back(x);
      }
    }
    edges_[a] = cut(cells[a], tile[a], stops);
    counts_[a] = static_cast<int>(edges_[a].size()) - 1;
  }
  for (int k = 0; k < counts_[2]; ++k) {
    for (int j = 0; j < counts_[1]; ++j) {
      for (int i = 0; i < counts_[0]; ++i) position_.push_back({i, j, k});
    }
  }
  auto const first_of = [&](Int3 const& c) {
    return Int3{edges_[0][static_cast<std::size_t>(c[0])], edges_[1][static_cast<std::size_t>(c[1])],
                edges_[2][static_cast<std::size_t>(c[2])]};
  };
  std::erase_if(position_, [&](Int3 const& c) {
    Int3 const at = first_of(c);
    return std::any_of(blocks.begin(), blocks.end(), [&](SolidBlock const& b) {
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) inside = inside && at[a] >= b.first[a] && at[a] < b.last[a];
      return inside;
    });
  });
  std::sort(position_.begin(), position_.end(), [](Int3 const& a, Int3 const& b) { return morton(a) < morton(b); });
  columns_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]), -1);
  for (std::size_t id = 0; id < position_.size(); ++id) {
    Int3 const& c = position_[id];
    columns_[static_cast<std::size_t>(c[0] + counts_[0] * (c[1] + counts_[1] * c[2]))] = static_cast<TileId>(id);
    TileBox box{first_of(c), {}};
    for (std::size_t a = 0; a < 3; ++a) box.size[a] = edges_[a][static_cast<std::size_t>(c[a] + 1)] - box.first[a];
    boxes_.push_back(box);
  }
  for (Int3 const& c : position_) {
    std::array<TileId, 27> around{};
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          Int3 to{c[0] + i, c[1] + j, c[2] + k};
          bool inside = true;
          for (std::size_t a = 0; a < 3; ++a) {
            if (to[a] >= 0 && to[a] < counts_[a]) continue;
            if (periodic[a]) to[a] = (to[a] + counts_[a]) % counts_[a];
            inside = inside && periodic[a];
          }
          around[slot({i, j, k})] = inside ? in_column(to) : -1;
        }
      }
    }
    beside_.push_back(around);
  }
}

TileId Tiling::at(Int3 const& cell) const noexcept {
  return in_column({column_of(edges_[0], cell[0]), column_of(edges_[1], cell[1]), column_of(edges_[2], cell[2])});
}

bool Tiling::at_side(TileId id, int axis, int direction) const noexcept {
  std::size_t const a = static_cast<std::size_t>(axis);
  int const column = position_[static_cast<std::size_t>(id)][a];
  return direction < 0 ? column == 0 : column == counts_[a] - 1;
}

std::vector<TileNeighbour> Tiling::neighbours(TileId id) const {
  std::vector<TileNeighbour> list;
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        TileId const other = beside(id, {i, j, k});
        if (other >= 0 && (i != 0 || j != 0 || k != 0)) list.push_back({other, {i, j, k}, 0});
      }
    }
  }
  std::stable_sort(list.begin(), list.end(), [](auto const& a, auto const& b) { return a.id < b.id; });
  return list;
}

std::vector<TileId> Tiling::partition(std::span<double const> weights, int parts) {
  double const total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<TileId> first{0};
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    while (static_cast<int>(first.size()) < parts &&
           sum + 0.5 * weights[i] >= total * static_cast<double>(first.size()) / parts) {
      first.push_back(static_cast<TileId>(i));
    }
    sum += weights[i];
  }
  while (static_cast<int>(first.size()) < parts + 1) first.push_back(static_cast<TileId>(weights.size()));
  return first;
}

int Tiling::owner(std::span<TileId const> first, TileId id) noexcept {
  return static_cast<int>(std::upper_bound(first.begin(), first.end(), id) - first.begin()) - 1;
}

}  // namespace g27
