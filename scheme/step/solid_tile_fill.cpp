/// Gathers a tile and the cells around it: conserved averages of the neighbours to primitives, then what lies beyond
/// the box.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "scheme/step/gauss.hpp"
#include "scheme/step/solid_tile.hpp"

namespace g27 {

namespace {

constexpr double extrapolated_share = 0.5;  ///< of the density, that an extrapolation may take off or add

}  // namespace

Vec3 SolidTileWork::centre(Int3 const& cell) const noexcept {
  Int3 const& first = tile_->box.first;
  return cell_centre(g_.lower, g_.h, g_.swept, {first[0] + cell[0], first[1] + cell[1], first[2] + cell[2]});
}

bool SolidTileWork::box_ends(int axis, bool low) const noexcept {
  return g_.swept[static_cast<std::size_t>(axis)] && g_.tiling.at_side(id_, axis, low ? -1 : 1) &&
         side(axis, low).kind != SolidBoundary::Kind::periodic;
}

bool SolidTileWork::bounded(int axis, bool low) const noexcept {
  using Kind = SolidBoundary::Kind;
  Kind const k = side(axis, low).kind;
  return k == Kind::wall || k == Kind::fixed || k == Kind::traction || k == Kind::free;
}

void SolidTileWork::gather_row(int j, int k) {
  int const dy = region_of(j, ny_), dz = region_of(k, nz_), H = halo_[0];
  FieldRows const row = gathered_.rows().from(H);
  for (int dx = -1; dx <= 1; ++dx) {
    int const begin = dx < 0 ? -H : dx == 0 ? 0 : nx_, end = dx < 0 ? 0 : dx == 0 ? nx_ : nx_ + H;
    if (begin == end) continue;
    TileId const other = g_.tiling.beside(id_, {dx, dy, dz});
    std::size_t const n = static_cast<std::size_t>(end - begin);
    // a placeholder beyond the box: those cells are filled later
    SolidTile& t = g_.tiles[static_cast<std::size_t>(other >= 0 ? other : id_)];
    for (int d = 0; d < solid_conserved::fields; ++d) {
      double* const to = row[d] + begin;
      if (other < 0) {
        std::fill_n(to, n, t.now[static_cast<std::size_t>(d * t.field)]);
      } else {
        std::ptrdiff_t const at = t.index(local_index(begin, nx_, t.box.size[0]), local_index(j, ny_, t.box.size[1]),
                                          local_index(k, nz_, t.box.size[2]));
        std::memcpy(to, t.now.data() + d * t.field + at, n * sizeof(double));
      }
    }
  }
  // lanes beyond the row repeat its last cell, so that they cost nothing special
  for (int d = 0; d < solid_conserved::fields; ++d) std::fill_n(row[d] + nx_ + H, 8, row[d][nx_ + H - 1]);
  g_.law.primitive({.cells = static_cast<std::size_t>(nx_ + 2 * H),
                    .eos = g_.eos,
                    .conserved = row.from(-H),
                    .cell = cells_at(index(-H, j, k))});
}

void SolidTileWork::extrapolate(std::ptrdiff_t to, std::ptrdiff_t first, std::ptrdiff_t second, int depth) noexcept {
  double* const q = cells_.data();
  double const change = depth * (q[first] - q[second]);
  double const by = std::fabs(change) <= extrapolated_share * q[first] ? depth : 0.0;
  for (int d = 0; d < solid_cell::fields; ++d) {
    double const* const row = q + d * volume_;
    q[d * volume_ + to] = row[first] + by * (row[first] - row[second]);
  }
  double& ep = q[solid_cell::ep * volume_ + to];
  ep = std::max(ep, 0.0);
}

void SolidTileWork::fill_side(int axis, bool low) {
  using Kind = SolidBoundary::Kind;
  SolidBoundary const& b = side(axis, low);
  std::size_t const a = static_cast<std::size_t>(axis);
  Int3 const size{nx_, ny_, nz_};
  Int3 begin{}, end{};
  for (std::size_t c = 0; c < 3; ++c) begin[c] = -halo_[c], end[c] = size[c] + halo_[c];
  std::ptrdiff_t const inward = low ? stride(axis) : -stride(axis);
  for (int depth = 1; depth <= solid_halo; ++depth) {
    begin[a] = low ? -depth : size[a] + depth - 1, end[a] = begin[a] + 1;
    for (int k = begin[2]; k < end[2]; ++k) {
      for (int j = begin[1]; j < end[1]; ++j) {
        for (int i = begin[0]; i < end[0]; ++i) {
          std::ptrdiff_t const to = index(i, j, k), first = to + depth * inward;
          if (b.kind == Kind::inflow) {
            set_inflow(b, {i, j, k});
          } else if (b.kind == Kind::symmetry) {
            std::ptrdiff_t const from = to + (2 * depth - 1) * inward;
            for (int d = 0; d < solid_cell::fields; ++d) cells_[d * volume_ + to] = cells_[d * volume_ + from];
            auto const turn = [&](int d) { cells_[d * volume_ + to] = -cells_[d * volume_ + to]; };
            turn(solid_cell::u + axis);
            turn(solid_cell::S + frame_component(axis, 3)), turn(solid_cell::S + frame_component(axis, 4));
          } else {
            extrapolate(to, first, first + inward, b.kind == Kind::outflow ? 0 : depth);
          }
        }
      }
    }
  }
}

void SolidTileWork::set_inflow(SolidBoundary const& b, Int3 const& cell) {
  namespace to = solid_cell;
  // two Gauss points along every axis; pairs are averaged, so that equal states keep every bit
  auto const gauss = gauss_points(2);
  Vec3 const x = centre(cell);
  std::array<std::array<double, to::state>, 8> s{};
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    if (g_.swept[a]) axes.push_back(a);
  }
  std::size_t count = std::size_t{1} << axes.size();
  for (std::size_t m = 0; m < count; ++m) {
    Vec3 at = x;
    for (std::size_t n = 0; n < axes.size(); ++n) at[axes[n]] += 0.5 * g_.h[axes[n]] * gauss[(m >> n) & 1u].x;
    SolidPoint const p = b.state(at, g_.time);
    auto& q = s[m];
    q[to::rho] = p.rho, q[to::p] = p.p, q[to::ep] = p.ep;
    for (std::size_t c = 0; c < 3; ++c) q[to::u + c] = p.u[c];
    for (std::size_t c = 0; c < 6; ++c) q[to::S + c] = p.S[c];
    std::visit(
        [&](auto const& eos) {
          q[to::e] = eos.energy(p.rho, p.p);
          q[to::p] = eos.pressure(p.rho, q[to::e]);
        },
        g_.setup.material.eos);
  }
  for (; count > 1; count /= 2) {
    for (std::size_t m = 0; m < count / 2; ++m) {
      for (std::size_t d = 0; d < to::state; ++d) s[m][d] = 0.5 * s[2 * m][d] + 0.5 * s[2 * m + 1][d];
    }
  }
  std::ptrdiff_t const i = index(cell[0], cell[1], cell[2]);
  for (int d = 0; d < to::state; ++d) cells_[d * volume_ + i] = s[0][static_cast<std::size_t>(d)];
  std::visit(
      [&](auto const& eos) {
        cells_[to::K * volume_ + i] = eos.bulk_modulus(s[0][to::rho], s[0][to::p]);
        cells_[to::f * volume_ + i] = eos.gruneisen(s[0][to::rho]);
      },
      g_.setup.material.eos);
}

}  // namespace g27
