/// The sweep over a tile: transverse terms row by row, then every face once, with only the rows kept that are still
/// needed. In the order of the axes each direction's fluxes are added to the new averages.
#include "scheme/step/gas_tile.hpp"

#include <algorithm>

namespace g27 {

namespace {

std::size_t line_length(int cells, int halo) noexcept {
  return static_cast<std::size_t>((cells + 2 * halo + 8 + 7) / 8 * 8);
}

}  // namespace

TileWork::TileWork(GridContext const& context, Int3 const& largest)
    : g_(context),
      third_order_(is_third_order(context.predictor)),
      problems_(line_length(largest[0], context.halo) + 16),
      other_problems_(problems_),
      wall_problems_(problems_) {
  for (std::size_t a = 0; a < 3; ++a) halo_[a] = g_.swept[a] ? g_.halo : 0;
  std::size_t const line = line_length(largest[0], halo_[0]);
  std::size_t const rows = static_cast<std::size_t>(largest[1] + 2 * halo_[1]);
  volume_ = line * rows * static_cast<std::size_t>(largest[2] + 2 * halo_[2]);
  for (Padded* q : {&rho_, &p_, &K_, &margin_}) *q = Padded(volume_, 1.0);
  for (Padded& q : u_) q = Padded(volume_);
  if (third_order_) {
    for (Padded* q : {&mean_u_[0], &mean_u_[1], &mean_u_[2], &mean_p_, &dK_dp_}) *q = Padded(volume_, 1.0);
  }
  if (g_.setup.options.cure) cure_.assign(volume_ + 48, 0.0);
  redo_.assign(volume_ + 48, 0.0);
  if (g_.setup.burn.there()) unburnt_ = near_unburnt_ = redo_;
  std::size_t const n = line + 16;
  mirror_line_ = n;
  gathered_ = TermRow(n), x_terms_ = TermRow(n), averaged_ = TermRow(n);
  other_flux_ = FluxRow(n);
  for (auto& row : x_flux_) row = FluxRow(n);
  for (auto& row : y_terms_) row = TermRow(n);
  for (auto& row : y_flux_) row = FluxRow(n);
  bool const muscl = g_.predictor == PredictorKernel::muscl;
  if (g_.swept[2]) {
    std::size_t const plane = 2 * static_cast<std::size_t>(largest[1]);
    z_terms_.assign(muscl ? 0 : plane, TermRow(n));
    z_flux_.assign(plane, FluxRow(n));
    if (muscl) z_edges_.assign(plane, {TermRow(n), TermRow(n)});
  }
  if (muscl) {
    for (auto& row : x_edges_) row = TermRow(n);
    for (auto& rows_of : y_edges_) rows_of = {TermRow(n), TermRow(n)};
  }
  mark_ = Padded(n), map_ = Padded(n), still_ = Padded(n);
  for (Padded& q : mirror_) q = Padded(4 * n, 1.0);
  for (std::size_t a = 0; a < 3; ++a) {
    double const h = g_.h[a];
    width_[a] = Padded(n, h), pair_[a] = Padded(n, 0.5 / h), triple_[a] = Padded(n, 1.0 / (3.0 * h));
  }
}

std::size_t TileWork::bytes() const noexcept {
  return volume_ * sizeof(double) * (7 + (third_order_ ? 5u : 0u) + (cure_.empty() ? 1u : 2u));
}

RowIn TileWork::cells_at(std::ptrdiff_t i) const noexcept {
  RowIn r;
  r.first = rho_.data() + i, r.last = p_.data() + i;
  for (std::size_t a = 0; a < 3; ++a) r.vector[a] = u_[a].data() + i;
  return r;
}

RowOut TileWork::tile_row(CacheLineVector& q, int j, int k) const noexcept {
  double* const at = q.data() + tile_->index(0, j, k);
  std::ptrdiff_t const f = tile_->field;
  return {at, {at + f, at + 2 * f, g_.dims == 3 ? at + 3 * f : nullptr}, at + 4 * f};
}

void TileWork::step(TileId id) {
  id_ = id, tile_ = &g_.tiles[static_cast<std::size_t>(id)];
  GasTile& t = *tile_;
  t.store_state(g_.dims);
  nx_ = t.box.size[0], ny_ = t.box.size[1], nz_ = t.box.size[2];
  sj_ = static_cast<std::ptrdiff_t>(line_length(nx_, halo_[0])), sk_ = sj_ * (ny_ + 2 * halo_[1]);
  origin_ = halo_[0] + sj_ * halo_[1] + sk_ * halo_[2];
  t.worst = 1, t.rate = 0, t.differs = false, t.failures = 0;
  t.faces = t.switched = t.strong = t.cured = t.redone = 0;
  t.through = t.from_source = {};
  planes_ = -halo_[2], mean_planes_ = halo_[2] > 0 ? 1 - halo_[2] : 0;
  find_redo();
  find_unburnt();
  sweep();
}

void TileWork::find_redo() {
  any_redo_ = false;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        TileId const other = beside({dx, dy, dz});
        any_redo_ = any_redo_ || (other >= 0 && !g_.tiles[static_cast<std::size_t>(other)].redo.empty());
      }
    }
  }
  if (!any_redo_) return;
  std::fill(redo_.begin(), redo_.end(), 0.0);
  auto const around = [](int halo, int n) { return std::pair{halo > 0 ? -1 : 0, halo > 0 ? n + 1 : n}; };
  auto const [i0, i1] = around(halo_[0], nx_);
  auto const [j0, j1] = around(halo_[1], ny_);
  auto const [k0, k1] = around(halo_[2], nz_);
  auto const part = [](int i, int n) { return i < 0 ? -1 : i >= n ? 1 : 0; };
  auto const inside = [](int i, int n, int other) { return i < 0 ? other + i : i >= n ? i - n : i; };
  for (int k = k0; k < k1; ++k) {
    for (int j = j0; j < j1; ++j) {
      for (int i = i0; i < i1; ++i) {
        TileId const other = beside({part(i, nx_), part(j, ny_), part(k, nz_)});
        if (other < 0) continue;
        GasTile const& t = g_.tiles[static_cast<std::size_t>(other)];
        if (t.redo.empty()) continue;
        int const x = inside(i, nx_, t.box.size[0]), y = inside(j, ny_, t.box.size[1]),
                  z = inside(k, nz_, t.box.size[2]);
        std::size_t const at = static_cast<std::size_t>(x + t.box.size[0] * (y + t.box.size[1] * z));
        if (t.redo[at] != 0) redo_[static_cast<std::size_t>(origin_ + index(i, j, k))] = 1.0;
      }
    }
  }
}

void TileWork::sweep() {
  bool const three = g_.swept[2], two = g_.swept[1];
  any_cure_ = false;
  int const k0 = three ? -1 : 0, k1 = three ? nz_ + 1 : 1, j0 = two ? -1 : 0, j1 = two ? ny_ + 1 : ny_;
  for (int k = k0; k < k1; ++k) {
    bool const inside_z = k >= 0 && k < nz_;
    gather_up_to(k);
    for (int j = j0; j < j1; ++j) {
      bool const inside_y = j >= 0 && j < ny_;
      if (!inside_y && !inside_z) continue;
      set_terms(j, k);
      for (Int3 const& cell : tile_->edges) {
        if (cell[1] == j && cell[2] == k) plain_cell(cell, y_slot(j), z_slot(j, k));
      }
      if (inside_z && inside_y) x_faces(j, k);
      if (inside_z && two && j >= 0) y_faces(j, k);
      if (three && k >= 0 && inside_y) z_faces(j, k);
      if (inside_z && !three) {
        int const done = two ? j - 1 : j;
        if (done >= 0 && done < ny_) finish(done, k);
      }
    }
  }
}

void TileWork::set_terms(int j, int k) {
  GridSchemeOptions const& o = g_.setup.options;
  bool const inside_y = j >= 0 && j < ny_, inside_z = k >= 0 && k < nz_;
  int const lead = g_.swept[0] ? 1 : 0;
  std::ptrdiff_t const i = origin_ + index(-lead, j, k);
  std::size_t const cells = static_cast<std::size_t>(nx_ + 2 * lead), d = static_cast<std::size_t>(g_.dims - 2);
  std::array<std::ptrdiff_t, 3> const strides{g_.swept[0] ? 1 : 0, g_.swept[1] ? sj_ : 0, g_.swept[2] ? sk_ : 0};
  std::array<double, 3> half{};
  for (std::size_t a = 0; a < 3; ++a) half[a] = g_.swept[a] ? 0.5 * g_.dt / g_.h[a] : 0.0;
  // rows start at the cell before the tile
  auto const from_first = [lead](RowOut r) {
    r.first -= lead, r.last -= lead;
    for (double*& v : r.vector) v -= lead;
    return r;
  };
  bool const sourced = static_cast<bool>(g_.setup.source.primitive_rate);
  bool const terms = g_.predictor != PredictorKernel::godunov && g_.predictor != PredictorKernel::muscl &&
                     (o.transverse != Transverse::none || sourced);
  if (o.cure && !terms) {
    ShockFlagArguments flags{.cells = cells,
                             .primitive = cells_at(i),
                             .K = K_.data() + i,
                             .stride = strides,
                             .flag = cure_.data() + i,
                             .any = false};
    g_.kernels.predict->grid.shock_flags[d](flags);
    any_cure_ = any_cure_ || flags.any;
  }
  if (g_.predictor == PredictorKernel::muscl) {
    GridMusclArguments m{.cells = cells,
                         .primitive = cells_at(i),
                         .K = K_.data() + i,
                         .stride = strides,
                         .half_dt_over_h = half,
                         .lower = {},
                         .upper = {}};
    if (inside_y && inside_z) {
      m.lower[0] = from_first(x_edges_[0].out()), m.upper[0] = from_first(x_edges_[1].out());
    }
    if (inside_z && g_.swept[1]) {
      m.lower[1] = from_first(y_edges_[y_slot(j)][0].out()), m.upper[1] = from_first(y_edges_[y_slot(j)][1].out());
    }
    if (inside_y && g_.swept[2]) {
      m.lower[2] = from_first(z_edges_[z_slot(j, k)][0].out()),
      m.upper[2] = from_first(z_edges_[z_slot(j, k)][1].out());
    }
    g_.kernels.predict->grid.muscl[d](m);
    return;
  }
  if (!terms) return;
  TransverseArguments t{.cells = cells,
                        .primitive = cells_at(i),
                        .K = K_.data() + i,
                        .margin = margin_.data() + i,
                        .stride = strides,
                        .half_dt_over_h = half,
                        .term = {},
                        .flag = o.cure ? cure_.data() + i : nullptr,
                        .any = false};
  if (o.transverse == Transverse::none) t.half_dt_over_h = {0, 0, 0};
  if (inside_y && inside_z) t.term[0] = from_first(x_terms_.out());
  if (inside_z && g_.swept[1]) t.term[1] = from_first(y_terms_[y_slot(j)].out());
  if (inside_y && g_.swept[2]) t.term[2] = from_first(z_terms_[z_slot(j, k)].out());
  g_.kernels.predict->grid.transverse[d](t);
  any_cure_ = any_cure_ || t.any;
  if (sourced) {
    add_sources(
        j, k,
        {t.term[0].first != nullptr ? &x_terms_ : nullptr, t.term[1].first != nullptr ? &y_terms_[y_slot(j)] : nullptr,
         t.term[2].first != nullptr ? &z_terms_[z_slot(j, k)] : nullptr});
  }
}

void TileWork::plain_cell(Int3 const& cell, std::size_t y_slot, std::size_t z_slot) {
  auto const [i, j, k] = cell;
  bool const inside_y = j >= 0 && j < ny_, inside_z = k >= 0 && k < nz_;
  std::ptrdiff_t const at = origin_ + index(i, j, k);
  if (!cure_.empty()) cure_[static_cast<std::size_t>(at)] = 0.0;
  auto const clear = [&](TermRow& t) {
    t.rho[i] = t.p[i] = 0.0;
    for (Padded& u : t.u) u[i] = 0.0;
  };
  auto const flatten = [&](std::array<TermRow, 2>& both) {
    for (TermRow& t : both) {
      t.rho[i] = rho_[at], t.p[i] = p_[at];
      for (std::size_t a = 0; a < 3; ++a) t.u[a][i] = u_[a][at];
    }
  };
  if (g_.predictor == PredictorKernel::muscl) {
    if (inside_y && inside_z) flatten(x_edges_);
    if (inside_z && g_.swept[1]) flatten(y_edges_[y_slot]);
    if (inside_y && g_.swept[2]) flatten(z_edges_[z_slot]);
  } else {
    if (inside_y && inside_z) clear(x_terms_);
    if (inside_z && g_.swept[1]) clear(y_terms_[y_slot]);
    if (inside_y && g_.swept[2]) clear(z_terms_[z_slot]);
  }
}

void TileWork::add_sources(int j, int k, std::array<TermRow*, 3> const& terms) const {
  // the mean over the step of what has accumulated along a characteristic is half a step of the rate a third on
  for (int i = -1; i <= nx_; ++i) {
    GasPoint const r = g_.setup.source.primitive_rate(centre({i, j, k}), g_.time + g_.dt / 3.0);
    for (TermRow* term : terms) {
      if (term == nullptr) continue;
      term->rho[i] += 0.5 * g_.dt * r.rho, term->p[i] += 0.5 * g_.dt * r.p;
      for (std::size_t a = 0; a < 3; ++a) term->u[a][i] += 0.5 * g_.dt * r.u[a];
    }
  }
}

void TileWork::x_faces(int j, int k) {
  bool const low = gas_ends(0, -1), high = gas_ends(0, 1), muscl = g_.predictor == PredictorKernel::muscl;
  FluxRow& flux = x_flux_[static_cast<std::size_t>(j % 2)];
  solve_row({.axis = 0,
             .cell = origin_ + index(-1, j, k),
             .n = static_cast<std::size_t>(nx_ + 1),
             .left = muscl ? &x_edges_[1] : &x_terms_,
             .right = muscl ? &x_edges_[0] : &x_terms_,
             .wall_low = low,
             .wall_high = high,
             .j = j,
             .k = k},
            flux);
  if (low) account(0, true, flux, 0, 1);
  if (high) account(0, false, flux, nx_, 1);
  if (!g_.swept[1]) update_xy(j, k);
}

void TileWork::update_xy(int j, int k) {
  GasTile& t = *tile_;
  std::size_t const row = static_cast<std::size_t>(j % 2);
  RowOut const x = x_flux_[row].out();
  RowOut x_upper = x;
  ++x_upper.first, ++x_upper.last;
  for (double*& v : x_upper.vector) ++v;
  GridUpdateArguments u{.cells = static_cast<std::size_t>(nx_),
                        .axes = g_.swept[1] ? 2u : 1u,
                        .from = tile_row(t.now, j, k),
                        .lower = {x, y_flux_[row].out()},
                        .upper = {x_upper, y_flux_[1 - row].out()},
                        .lambda = {g_.dt / g_.h[0], g_.dt / g_.h[1]},
                        .to = tile_row(t.next, j, k)};
  g_.kernels.predict->grid.update[static_cast<std::size_t>(g_.dims - 2)](u);
}

void TileWork::update_z(int j, int k, FluxRow& lower, FluxRow& upper) {
  GasTile& t = *tile_;
  RowOut const row = tile_row(t.next, j, k);
  g_.kernels.predict->grid.update[static_cast<std::size_t>(g_.dims - 2)]({.cells = static_cast<std::size_t>(nx_),
                                                                          .axes = 1,
                                                                          .from = row,
                                                                          .lower = {lower.out(), {}},
                                                                          .upper = {upper.out(), {}},
                                                                          .lambda = {g_.dt / g_.h[2], 0},
                                                                          .to = row});
}

void TileWork::y_faces(int j, int k) {
  std::size_t const now = static_cast<std::size_t>(j % 2), before = 1 - now;
  bool const low = j == 0 && gas_ends(1, -1), high = j == ny_ && gas_ends(1, 1);
  bool const muscl = g_.predictor == PredictorKernel::muscl;
  FluxRow& flux = y_flux_[now];
  solve_row({.axis = 1,
             .cell = origin_ + index(0, j - 1, k),
             .n = static_cast<std::size_t>(nx_),
             .left = muscl ? &y_edges_[before][1] : &y_terms_[before],
             .right = muscl ? &y_edges_[now][0] : &y_terms_[now],
             .wall_low = low,
             .wall_high = high,
             .j = j,
             .k = k},
            flux);
  if (low || high) account(1, low, flux, 0, static_cast<std::size_t>(nx_));
  if (j > 0) update_xy(j - 1, k);
}

void TileWork::z_faces(int j, int k) {
  std::size_t const row = static_cast<std::size_t>(j), plane = static_cast<std::size_t>(ny_);
  std::size_t const now = static_cast<std::size_t>(k % 2) * plane + row,
                    before = (1 - static_cast<std::size_t>(k % 2)) * plane + row;
  bool const low = k == 0 && gas_ends(2, -1), high = k == nz_ && gas_ends(2, 1);
  bool const muscl = g_.predictor == PredictorKernel::muscl;
  FluxRow& flux = z_flux_[now];
  solve_row({.axis = 2,
             .cell = origin_ + index(0, j, k - 1),
             .n = static_cast<std::size_t>(nx_),
             .left = muscl ? &z_edges_[before][1] : &z_terms_[before],
             .right = muscl ? &z_edges_[now][0] : &z_terms_[now],
             .wall_low = low,
             .wall_high = high,
             .j = j,
             .k = k},
            flux);
  if (low || high) account(2, low, flux, 0, static_cast<std::size_t>(nx_));
  if (k > 0) {
    update_z(j, k - 1, z_flux_[before], flux);
    finish(j, k - 1);
  }
}

void TileWork::finish(int j, int k) {
  GasTile& t = *tile_;
  RowOut const row = tile_row(t.next, j, k);
  if (g_.setup.source.mean) {
    double const volume = g_.h[0] * g_.h[1] * g_.h[2];
    for (int i = 0; i < nx_; ++i) {
      GasDensities const s = g_.setup.source.mean(centre({i, j, k}), g_.h, g_.time, g_.dt);
      std::array<double, 5> const q{s.mass, s.momentum[0], s.momentum[1], s.momentum[2], s.energy};
      std::array<double*, 5> const to{row.first, row.vector[0], row.vector[1], row.vector[2], row.last};
      for (std::size_t d = 0; d < 5; ++d) {
        if (to[d] == nullptr) continue;
        to[d][i] += g_.dt * q[d];
        t.from_source[d] += volume * g_.dt * q[d];
      }
    }
  }
  if (burns_) release(j, k);
  std::ptrdiff_t const i = origin_ + index(0, j, k);
  GridFinishArguments f{.cells = static_cast<std::size_t>(nx_),
                        .eos = g_.eos,
                        .conserved = row,
                        .rho_old = rho_.data() + i,
                        .margin_old = margin_.data() + i,
                        .inv_h = {},
                        .max_rule = g_.setup.options.max_rule,
                        .like = {},
                        .worst = t.worst,
                        .rate = t.rate,
                        .differs = t.differs || !t.uniform};
  for (std::size_t a = 0; a < 3; ++a) f.inv_h[a] = g_.swept[a] ? 1.0 / g_.h[a] : 0.0;
  for (std::size_t d = 0; d < 5; ++d) f.like[d] = t.state[d];
  g_.law.grid.finish[static_cast<std::size_t>(g_.dims - 2)](f);
  t.worst = f.worst, t.rate = f.rate, t.differs = f.differs;
}

void TileWork::account(int axis, bool low, FluxRow& flux, std::ptrdiff_t first, std::size_t n) noexcept {
  std::size_t const a = static_cast<std::size_t>(axis);
  double const area = g_.h[0] * g_.h[1] * g_.h[2] / g_.h[a], sign = low ? 1.0 : -1.0;
  RowOut const row = flux.out();
  std::array<double const*, 5> const q{row.first, row.vector[0], row.vector[1], row.vector[2], row.last};
  for (std::size_t d = 0; d < 5; ++d) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += q[d][first + static_cast<std::ptrdiff_t>(i)];
    tile_->through[d] += sign * area * g_.dt * sum;
  }
}

}  // namespace g27
