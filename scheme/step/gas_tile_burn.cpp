/// Programmed burn in a tile.
#include <algorithm>

#include "scheme/step/gas_tile.hpp"

namespace g27 {

void TileWork::find_unburnt() {
  ProgrammedBurn const& burn = g_.setup.burn;
  burns_ = burn.there() && g_.time < tile_->last_lit;
  if (!burns_) return;
  std::array<int, 3> const n{nx_, ny_, nz_};
  double const h = g_.width();
  // a face's stencil holds two cells a side
  auto const each = [&](int layers, auto const& f) {
    std::array<int, 3> from{}, to = n;
    for (std::size_t a = 0; a < 3; ++a) {
      if (g_.swept[a]) from[a] = -layers, to[a] += layers;
    }
    for (int k = from[2]; k < to[2]; ++k) {
      for (int j = from[1]; j < to[1]; ++j) {
        for (int i = from[0]; i < to[0]; ++i) f(Int3{i, j, k}, origin_ + index(i, j, k));
      }
    }
  };
  each(2, [&](Int3 const& cell, std::ptrdiff_t at) {
    unburnt_[static_cast<std::size_t>(at)] = burn.unburnt(burn.lighting(centre(cell)), g_.time, h);
  });
  std::array<std::ptrdiff_t, 3> const strides{1, sj_, sk_};
  each(1, [&](Int3 const&, std::ptrdiff_t at) {
    bool near = unburnt_[static_cast<std::size_t>(at)] > 0;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!g_.swept[a]) continue;
      near = near || unburnt_[static_cast<std::size_t>(at - strides[a])] > 0 ||
             unburnt_[static_cast<std::size_t>(at + strides[a])] > 0;
    }
    near_unburnt_[static_cast<std::size_t>(at)] = near ? 1 : 0;
  });
}

void TileWork::leave_unburnt(FaceRow const& row, FaceProblems& b) {
  std::size_t marked = 0;
  mark(near_unburnt_, row, marked);
  std::size_t const a = static_cast<std::size_t>(row.axis);
  for (std::ptrdiff_t f = 0; marked > 0 && f < static_cast<std::ptrdiff_t>(row.n); ++f) {
    if (!(mark_[f] > 0)) continue;
    std::ptrdiff_t const cell = row.cell + f;
    b.s_rho[f] = rho_[cell], b.s_u[f] = u_[a][cell], b.s_p[f] = p_[cell], b.strong[f] = 0.0;
  }
}

void TileWork::burn_row(FaceRow const& row, FluxRow& out) {
  at_unburnt_ = true;
  redo_row(near_unburnt_, row, out);
  at_unburnt_ = false;
  std::size_t const left = static_cast<std::size_t>(row.cell),
                    right = left + static_cast<std::size_t>(stride(row.axis));
  for (std::size_t f = 0; f < row.n; ++f) {
    double& mass = out.mass[static_cast<std::ptrdiff_t>(f)];
    double const fresh = mass > 0 ? unburnt_[left + f] : unburnt_[right + f];
    out.energy[static_cast<std::ptrdiff_t>(f)] += g_.setup.burn.energy * fresh * mass;
  }
}

void TileWork::release(int j, int k) {
  ProgrammedBurn const& burn = g_.setup.burn;
  RowOut const row = tile_row(tile_->next, j, k);
  std::ptrdiff_t const at = origin_ + index(0, j, k);
  double const h = g_.width(), volume = g_.h[0] * g_.h[1] * g_.h[2];
  for (int i = 0; i < nx_; ++i) {
    double const before = unburnt_[static_cast<std::size_t>(at + i)];
    if (!(before > 0)) continue;
    double const after = burn.unburnt(burn.lighting(centre({i, j, k})), g_.time + g_.dt, h);
    double const released = burn.energy * (rho_[at + i] * before - row.first[i] * after);
    row.last[i] += released;
    tile_->from_source[4] += volume * released;
  }
}

}  // namespace g27
