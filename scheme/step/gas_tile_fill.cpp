/// Gathers a tile and the cells around it: conserved averages of the neighbours to primitives, then what lies beyond
/// the box or in solid blocks.
#include <algorithm>
#include <cmath>

#include "scheme/step/gas_tile.hpp"
#include "scheme/step/gauss.hpp"

namespace g27 {

void GasTile::store_state(int dims) {
  if (stored()) return;
  std::size_t const size = static_cast<std::size_t>(field) * 5;
  now.resize(size + 16), next.resize(size + 16);
  for (std::size_t d = 0; d < 5; ++d) {
    if (dims == 2 && d == 3) continue;
    std::fill_n(now.begin() + static_cast<std::ptrdiff_t>(d) * field, field, state[d]);
  }
}

GridBoundary const& GridContext::condition(Side side, Vec3 const& x) const noexcept {
  std::size_t const axis = static_cast<std::size_t>(side) / 2;
  for (BoundaryPatch const& patch : setup.patches) {
    if (patch.side != side) continue;
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a)
      inside = inside && (a == axis || (x[a] >= patch.lower[a] && x[a] < patch.upper[a]));
    if (inside) return patch.condition;
  }
  return setup.sides[static_cast<std::size_t>(side)];
}

Vec3 TileWork::centre(Int3 const& cell) const noexcept {
  Int3 const& first = tile_->box.first;
  return cell_centre(g_.lower, g_.h, g_.swept, {first[0] + cell[0], first[1] + cell[1], first[2] + cell[2]});
}

bool TileWork::gas_ends(int axis, int direction) const noexcept {
  if (!g_.swept[static_cast<std::size_t>(axis)]) return false;
  Int3 d{0, 0, 0};
  d[static_cast<std::size_t>(axis)] = direction;
  return beside(d) < 0;
}

void TileWork::gather_row(int j, int k) {
  int const dy = region_of(j, ny_), dz = region_of(k, nz_), H = halo_[0];
  // each part's last vector runs into the next part, which is written after it
  if (H > 0) gather_part({-1, dy, dz}, j, k, -H, 0);
  gather_part({0, dy, dz}, j, k, 0, nx_);
  std::ptrdiff_t const past = nx_ % vector_cells;
  if (past > 0) {
    // lanes beyond the row repeat its last cell, so that they cost nothing special
    std::ptrdiff_t const end = origin_ + index(nx_, j, k);
    for (Padded* q : {&rho_, &u_[0], &u_[1], &u_[2], &p_, &K_, &margin_}) {
      std::fill_n(q->data() + end, vector_cells - past, (*q)[end - 1]);
    }
  }
  if (H > 0) gather_part({1, dy, dz}, j, k, nx_, nx_ + H);
}

void TileWork::gather_part(Int3 const& region, int j, int k, int begin, int end) {
  TileId const other = beside(region);
  // a placeholder where no gas is: those cells are filled later
  GasTile const& t = g_.tiles[static_cast<std::size_t>(other >= 0 ? other : id_)];
  std::size_t const n = static_cast<std::size_t>(end - begin);
  RowIn from;
  if (other >= 0 && !t.uniform && region[0] == 0) {
    double const* const at =
        t.now.data() + t.index(0, local_index(j, ny_, t.box.size[1]), local_index(k, nz_, t.box.size[2]));
    from = RowIn::of({at, at + t.field, at + 2 * t.field, at + 3 * t.field, at + 4 * t.field});
  } else {
    std::array<double*, 5> const row{gathered_.rho.data(), gathered_.u[0].data(), gathered_.u[1].data(),
                                     gathered_.u[2].data(), gathered_.p.data()};
    for (std::size_t d = 0; d < 5; ++d) {
      if (g_.dims == 2 && d == 3) continue;
      if (other < 0 || t.uniform) {
        std::fill_n(row[d], n, other < 0 ? t.at(t.now, d, 0) : t.state[d]);
      } else {
        std::ptrdiff_t const at = t.index(local_index(begin, nx_, t.box.size[0]), local_index(j, ny_, t.box.size[1]),
                                          local_index(k, nz_, t.box.size[2]));
        std::copy_n(t.now.data() + static_cast<std::ptrdiff_t>(d) * t.field + at, n, row[d]);
      }
      std::fill_n(row[d] + n, vector_cells, row[d][n - 1]);
    }
    from = RowIn::of({row[0], row[1], row[2], row[3], row[4]});
  }
  std::ptrdiff_t const i = origin_ + index(begin, j, k);
  g_.law.grid.primitive[static_cast<std::size_t>(g_.dims - 2)](
      {.cells = n,
       .eos = g_.eos,
       .conserved = from,
       .primitive = {rho_.data() + i, {u_[0].data() + i, u_[1].data() + i, u_[2].data() + i}, p_.data() + i},
       .K = K_.data() + i,
       .margin = margin_.data() + i});
}

void TileWork::gather_up_to(int k) {
  int const H = halo_[2], end = nz_ + H;
  auto const gather_plane = [&](int plane) {
    for (int j = -halo_[1]; j < ny_ + halo_[1]; ++j) gather_row(j, plane);
  };
  int const wanted = std::min(k + (third_order_ ? 3 : 2), end);
  if (planes_ == -H) {
    // the planes below the tile may be images of the first ones in it
    int const first = std::min(std::max(H, 1), nz_);
    for (int plane = -H; plane < first; ++plane) gather_plane(plane);
    fill_outside(0, first, g_.halo, false);
    fill_outside(-H, 0, g_.halo, false);
    planes_ = first;
  }
  for (; planes_ < std::min(wanted, nz_); ++planes_) {
    gather_plane(planes_);
    fill_outside(planes_, planes_ + 1, g_.halo, false);
  }
  if (wanted > nz_ && planes_ == nz_) {
    for (int plane = nz_; plane < end; ++plane) gather_plane(plane);
    fill_outside(nz_, end, g_.halo, false);
    planes_ = end;
  }
  if (!third_order_) return;
  int const depth = H > 0 ? H - 1 : 0, last = nz_ + depth, wanted_means = std::min(k + 2, last);
  if (mean_planes_ == -depth) {
    int const first = std::min(std::max(depth, 1), nz_);
    for (int plane = -depth; plane < first; ++plane) average_plane(plane);
    fill_outside(0, first, g_.halo - 1, true);
    fill_outside(-depth, 0, g_.halo - 1, true);
    mean_planes_ = first;
  }
  for (; mean_planes_ < std::min(wanted_means, nz_); ++mean_planes_) {
    average_plane(mean_planes_);
    fill_outside(mean_planes_, mean_planes_ + 1, g_.halo - 1, true);
  }
  if (wanted_means > nz_ && mean_planes_ == nz_) {
    for (int plane = nz_; plane < last; ++plane) average_plane(plane);
    fill_outside(nz_, last, g_.halo - 1, true);
    mean_planes_ = last;
  }
}

void TileWork::fill_outside(int k0, int k1, int depth, bool means) {
  if (k0 >= k1) return;
  int const plane = region_of(k0, nz_);
  // faces of the tile first, then its edges and corners, each from a region that is filled already
  for (int order = 1; order <= 3; ++order) {
    for (int dz = plane; dz <= plane; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          Int3 const d{dx, dy, dz};
          if (std::abs(dx) + std::abs(dy) + std::abs(dz) != order || beside(d) >= 0) continue;
          // the axes across which gas lies; where there is none, any: those cells are filled already
          std::array<bool, 3> across{};
          bool exists = true, found = false;
          for (std::size_t a = 0; a < 3; ++a) {
            if (d[a] == 0) continue;
            exists = exists && halo_[a] > 0;
            Int3 from = d;
            from[a] = 0;
            across[a] = beside(from) >= 0, found = found || across[a];
          }
          for (std::size_t a = 0; a < 3 && !found; ++a) across[a] = d[a] != 0, found = across[a];
          if (exists) fill_region(d, across, k0, k1, depth, means);
        }
      }
    }
  }
}

void TileWork::fill_region(Int3 const& region, std::array<bool, 3> const& across, int k0, int k1, int depth,
                           bool means) {
  using Kind = GridBoundary::Kind;
  Int3 const size{nx_, ny_, nz_};
  Int3 begin{}, end{};
  for (std::size_t a = 0; a < 3; ++a) {
    int const H = std::min(depth, halo_[a]);
    begin[a] = region[a] < 0 ? -H : region[a] == 0 ? 0 : size[a];
    end[a] = region[a] < 0 ? 0 : region[a] == 0 ? size[a] : size[a] + H;
  }
  begin[2] = std::max(begin[2], k0), end[2] = std::min(end[2], k1);
  static GridBoundary const block{.kind = Kind::wall, .state = {}};
  for (int k = begin[2]; k < end[2]; ++k) {
    for (int j = begin[1]; j < end[1]; ++j) {
      for (int i = begin[0]; i < end[0]; ++i) {
        Int3 const cell{i, j, k};
        // In the corner of a block the nearest gas is that which sees this ghost: the axis of the least depth.
        std::size_t s = 3;
        int least = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          int const down = region[a] < 0 ? -1 - cell[a] : cell[a] - size[a];
          if (across[a] && (s == 3 || down < least)) s = a, least = down;
        }
        bool const low = region[s] < 0;
        Side const side = static_cast<Side>(2 * s + (low ? 0 : 1));
        bool const at_box = g_.tiling.at_side(id_, static_cast<int>(s), region[s]) &&
                            g_.setup.sides[static_cast<std::size_t>(side)].kind != Kind::periodic;
        GridBoundary const& c = at_box ? g_.condition(side, centre(cell)) : block;
        std::ptrdiff_t const to = origin_ + index(i, j, k);
        if (c.kind == Kind::inflow) {
          if (!means) {
            set_inflow(c, to, cell);
          } else {
            for (std::size_t a = 0; a < 3; ++a) mean_u_[a][to] = u_[a][to];
            mean_p_[to] = p_[to],
            dK_dp_[to] = dK_dp_[origin_ +
                                index(std::clamp(i, 0, nx_ - 1), std::clamp(j, 0, ny_ - 1), std::clamp(k, 0, nz_ - 1))];
          }
          continue;
        }
        bool const wall = c.kind == Kind::wall;
        Int3 inner = cell;
        if (wall) {
          inner[s] = low ? -1 - cell[s] : 2 * size[s] - 1 - cell[s];
        } else {
          inner[s] = low ? 0 : size[s] - 1;
        }
        std::ptrdiff_t const from = origin_ + index(inner[0], inner[1], inner[2]);
        if (means) {
          for (std::size_t a = 0; a < 3; ++a) mean_u_[a][to] = wall && a == s ? -mean_u_[a][from] : mean_u_[a][from];
          mean_p_[to] = mean_p_[from], dK_dp_[to] = dK_dp_[from];
        } else {
          for (std::size_t a = 0; a < 3; ++a) u_[a][to] = wall && a == s ? -u_[a][from] : u_[a][from];
          rho_[to] = rho_[from], p_[to] = p_[from], K_[to] = K_[from], margin_[to] = margin_[from];
        }
      }
    }
  }
}

void TileWork::set_inflow(GridBoundary const& condition, std::ptrdiff_t i, Int3 const& cell) {
  // two Gauss points along every axis; pairs are averaged, so that equal states keep every bit
  Vec3 const x = centre(cell);
  auto const gauss = gauss_points(2);
  std::array<GasPoint, 8> s{};
  std::size_t count = 1;
  for (int a = 0; a < g_.dims; ++a) count *= 2;
  for (std::size_t m = 0; m < count; ++m) {
    Vec3 at = x;
    for (std::size_t a = 0; a < static_cast<std::size_t>(g_.dims); ++a) at[a] += 0.5 * g_.h[a] * gauss[(m >> a) & 1u].x;
    s[m] = condition.state(at, g_.time);
  }
  for (; count > 1; count /= 2) {
    for (std::size_t m = 0; m < count / 2; ++m) {
      GasPoint const &a = s[2 * m], &b = s[2 * m + 1];
      s[m] = {0.5 * a.rho + 0.5 * b.rho,
              {0.5 * a.u[0] + 0.5 * b.u[0], 0.5 * a.u[1] + 0.5 * b.u[1], 0.5 * a.u[2] + 0.5 * b.u[2]},
              0.5 * a.p + 0.5 * b.p};
    }
  }
  GasPoint const& mean = s[0];
  rho_[i] = mean.rho, p_[i] = mean.p;
  for (std::size_t d = 0; d < 3; ++d) u_[d][i] = mean.u[d];
  std::visit(
      [&](auto const& eos) {
        K_[i] = eos.bulk_modulus(mean.rho, mean.p);
        margin_[i] = eos.pressure_margin(mean.rho, mean.p);
      },
      g_.setup.eos);
}

void TileWork::average_plane(int k) {
  std::array<int, 2> const H{halo_[0] > 0 ? halo_[0] - 1 : 0, halo_[1] > 0 ? halo_[1] - 1 : 0};
  for (int j = -H[1]; j < ny_ + H[1]; ++j) {
    std::ptrdiff_t const i = origin_ + index(-H[0], j, k);
    g_.law.grid.average[static_cast<std::size_t>(g_.dims - 2)](
        {.cells = static_cast<std::size_t>(nx_ + 2 * H[0]),
         .eos = g_.eos,
         .primitive = cells_at(i),
         .K = K_.data() + i,
         .stride = {g_.swept[0] ? 1 : 0, g_.swept[1] ? sj_ : 0, g_.swept[2] ? sk_ : 0},
         .velocity = {mean_u_[0].data() + i, mean_u_[1].data() + i, mean_u_[2].data() + i},
         .p = mean_p_.data() + i,
         .dK_dp = dK_dp_.data() + i});
  }
  for (Int3 const& cell : tile_->edges) {
    if (cell[2] != k) continue;
    std::ptrdiff_t const i = origin_ + index(cell[0], cell[1], k);
    for (std::size_t a = 0; a < 3; ++a) mean_u_[a][i] = u_[a][i];
    mean_p_[i] = p_[i];
  }
}

}  // namespace g27
