/// A row of faces of a tile: predictor, Riemann problems, fluxes of all five densities, walls, cure and repair.
#include <algorithm>

#include "scheme/step/gas_tile.hpp"

namespace g27 {

namespace {

/// Fluxes of the marked lanes from another row.
template <class Row>
void take_marked(Padded const& mark, std::size_t n, Row& to, Row const& from) noexcept {
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
    if (!(mark[i] > 0)) continue;
    to.mass[i] = from.mass[i], to.energy[i] = from.energy[i], to.p[i] = from.p[i], to.u[i] = from.u[i];
    for (std::size_t a = 0; a < 3; ++a) to.momentum[a][i] = from.momentum[a][i];
  }
}

}  // namespace

std::pair<std::ptrdiff_t, std::size_t> TileWork::lanes_on_side(FaceRow const& row, bool low) noexcept {
  if (row.axis != 0) return {0, row.n};
  return {low ? 0 : static_cast<std::ptrdiff_t>(row.n) - 1, 1};
}

bool TileWork::is_wall(FaceRow const& row, bool low, std::ptrdiff_t lane) const noexcept {
  std::size_t const a = static_cast<std::size_t>(row.axis);
  if (!g_.tiling.at_side(id_, row.axis, low ? -1 : 1)) return true;
  Side const side = static_cast<Side>(2 * row.axis + (low ? 0 : 1));
  if (g_.setup.sides[static_cast<std::size_t>(side)].kind == GridBoundary::Kind::periodic) return true;
  // the face's place: the cell inside it
  Int3 cell{row.axis == 0 ? 0 : static_cast<int>(lane), row.j, row.k};
  cell[a] = low ? 0 : tile_->box.size[a] - 1;
  return g_.condition(side, centre(cell)).kind == GridBoundary::Kind::wall;
}

TileWork::Increments TileWork::increments(FaceRow const& row, PredictorKernel kernel) {
  GridSchemeOptions const& o = g_.setup.options;
  if (kernel == PredictorKernel::godunov || (o.transverse == Transverse::none && !g_.setup.source.primitive_rate)) {
    return {};
  }
  // along x the left cell of the first face is the one before the tile
  std::ptrdiff_t const left = row.axis == 0 ? -1 : 0;
  auto const at = [](TermRow& t, std::ptrdiff_t i) {
    return RowIn(RowOut{t.rho.data() + i, {t.u[0].data() + i, t.u[1].data() + i, t.u[2].data() + i}, t.p.data() + i});
  };
  if (o.transverse != Transverse::averaged) return {true, at(*row.left, left), at(*row.right, 0)};
  auto const mean = [&](Padded& to, Padded const& l, Padded const& r) {
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(row.n); ++i) to[i] = 0.5 * (l[i + left] + r[i]);
  };
  mean(averaged_.rho, row.left->rho, row.right->rho), mean(averaged_.p, row.left->p, row.right->p);
  for (std::size_t c = 0; c < 3; ++c) mean(averaged_.u[c], row.left->u[c], row.right->u[c]);
  return {true, at(averaged_, 0), at(averaged_, 0)};
}

PredictArguments TileWork::arguments(PredictorKernel kernel, int axis, FaceProblems& b) const noexcept {
  std::size_t const a = static_cast<std::size_t>(axis);
  return {.faces = 0,
          .stride = 0,
          .own_increments = true,
          .rho = nullptr,
          .u = nullptr,
          .p = nullptr,
          .K = nullptr,
          .dK_dp = nullptr,
          .h = width_[a].data(),
          .inv_pair = pair_[a].data(),
          .inv_triple = triple_[a].data(),
          .w = still_.data(),
          .inc_rho = nullptr,
          .inc_u = nullptr,
          .inc_p = nullptr,
          .next_rho = nullptr,
          .next_u = nullptr,
          .next_p = nullptr,
          .foot_shift = nullptr,
          .foot_factor = nullptr,
          .dt = g_.dt,
          .exponent = g_.exponent,
          .linear_star = kernel != PredictorKernel::godunov || g_.predictor == PredictorKernel::godunov
                             ? g_.setup.options.linear_star && g_.setup.options.riemann != RiemannSolver::hllc
                             : false,
          .l_rho = b.l_rho.data(),
          .l_u = b.l_u.data(),
          .l_p = b.l_p.data(),
          .r_rho = b.r_rho.data(),
          .r_u = b.r_u.data(),
          .r_p = b.r_p.data(),
          .s_rho = b.s_rho.data(),
          .s_u = b.s_u.data(),
          .s_p = b.s_p.data(),
          .switched = b.switched.data(),
          .d_rho = b.d_rho.data(),
          .d_u = b.d_u.data(),
          .d_p = b.d_p.data(),
          .strong = b.strong.data()};
}

bool TileWork::at_once() const noexcept {
  return g_.energy_line[0] > 0 && g_.setup.options.riemann != RiemannSolver::hllc;
}

void TileWork::predict(FaceRow const& row, PredictorKernel kernel, Increments const& inc, FaceProblems& b,
                       FluxRow& out) {
  std::size_t const a = static_cast<std::size_t>(row.axis);
  bool const averaged = is_third_order(kernel);
  PredictArguments g = arguments(kernel, row.axis, b);
  g.faces = row.n, g.stride = stride(row.axis);
  g.rho = rho_.data() + row.cell, g.K = K_.data() + row.cell;
  g.u = (averaged ? mean_u_[a] : u_[a]).data() + row.cell;
  g.p = (averaged ? mean_p_ : p_).data() + row.cell;
  if (averaged) g.dK_dp = dK_dp_.data() + row.cell;
  if (inc.there) {
    g.inc_rho = inc.left.first, g.inc_u = inc.left.vector[a], g.inc_p = inc.left.last;
    g.next_rho = inc.right.first, g.next_u = inc.right.vector[a], g.next_p = inc.right.last;
  }
  if (at_once()) {
    g.at_once = {.per_pressure = g_.energy_line[0],
                 .at_zero = g_.energy_line[1],
                 .keep_states = false,
                 .mass = out.mass.data(),
                 .momentum = out.momentum[a].data(),
                 .energy = out.energy.data()};
  }
  g_.kernels.predict->table[static_cast<std::size_t>(kernel)][1](g);
}

void TileWork::image_in_wall(FaceRow const& row, PredictorKernel kernel, Increments const& inc, bool low,
                             FaceProblems& b) {
  auto const [first, n] = lanes_on_side(row, low);
  std::size_t const a = static_cast<std::size_t>(row.axis);
  bool const averaged = is_third_order(kernel);
  // Rows of the cells beside the wall as the gas on the left sees them: at a low wall the cells f + 1, f | f - 1, f - 2
  // become -1, 0 | 1, 2, with the normal velocity turned round.
  std::ptrdiff_t const s = stride(row.axis), line = static_cast<std::ptrdiff_t>(mirror_line_);
  double const turn = low ? -1.0 : 1.0;
  for (std::ptrdiff_t k = -1; k <= 2; ++k) {
    std::ptrdiff_t const from = row.cell + first + (low ? (1 - k) * s : k * s);
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
      std::ptrdiff_t const to = (k + 1) * line + i, cell = from + i;
      mirror_[0][to] = rho_[cell], mirror_[1][to] = turn * (averaged ? mean_u_[a] : u_[a])[cell];
      mirror_[2][to] = (averaged ? mean_p_ : p_)[cell], mirror_[3][to] = K_[cell];
      if (averaged) mirror_[4][to] = dK_dp_[cell];
    }
  }
  PredictArguments g = arguments(kernel, row.axis, wall_problems_);
  g.faces = n, g.stride = line, g.linear_star = false;
  g.rho = mirror_[0].data() + line, g.u = mirror_[1].data() + line, g.p = mirror_[2].data() + line;
  g.K = mirror_[3].data() + line, g.dK_dp = mirror_[4].data() + line;
  if (inc.there) {
    RowIn const &l = low ? inc.right : inc.left, &r = low ? inc.left : inc.right;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
      mirror_[5][i] = l.first[first + i], mirror_[6][i] = turn * l.vector[a][first + i],
      mirror_[7][i] = l.last[first + i];
      mirror_[5][line + i] = r.first[first + i], mirror_[6][line + i] = turn * r.vector[a][first + i];
      mirror_[7][line + i] = r.last[first + i];
    }
    g.inc_rho = mirror_[5].data(), g.inc_u = mirror_[6].data(), g.inc_p = mirror_[7].data();
    g.next_rho = g.inc_rho + line, g.next_u = g.inc_u + line, g.next_p = g.inc_p + line;
  }
  g_.kernels.predict->table[static_cast<std::size_t>(kernel)][1](g);
  // the image carries the same density and pressure and the opposite velocity
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
    if (!is_wall(row, low, first + i)) continue;
    std::ptrdiff_t const f = first + i;
    double const rho = wall_problems_.l_rho[i], u = turn * wall_problems_.l_u[i], p = wall_problems_.l_p[i];
    b.l_rho[f] = b.r_rho[f] = rho, b.l_p[f] = b.r_p[f] = p;
    b.l_u[f] = low ? -u : u, b.r_u[f] = low ? u : -u;
    b.d_rho[f] = b.d_u[f] = b.d_p[f] = 0.0;
    b.strong[f] = 1.0;
  }
}

void TileWork::solve_problems(FaceRow const& row, FaceProblems& b, bool averaged, bool weak_done, FluxRow& out) {
  std::size_t const a = static_cast<std::size_t>(row.axis);
  SolveArguments g{.faces = row.n,
                   .stride = stride(row.axis),
                   .eos = g_.eos,
                   .rho = rho_.data() + row.cell,
                   .u = u_[a].data() + row.cell,
                   .p = p_.data() + row.cell,
                   .margin = margin_.data() + row.cell,
                   .w = still_.data(),
                   .lagrangian = false,
                   .l_rho = b.l_rho.data(),
                   .l_u = b.l_u.data(),
                   .l_p = b.l_p.data(),
                   .r_rho = b.r_rho.data(),
                   .r_u = b.r_u.data(),
                   .r_p = b.r_p.data(),
                   .s_rho = b.s_rho.data(),
                   .s_u = b.s_u.data(),
                   .s_p = b.s_p.data(),
                   .strong = b.strong.data(),
                   .f_mass = out.mass.data(),
                   .f_momentum = out.momentum[a].data(),
                   .f_energy = out.energy.data(),
                   .face_p = row.wall_low || row.wall_high ? out.p.data() : nullptr,
                   .face_u = out.u.data(),
                   .d_rho = averaged ? b.d_rho.data() : nullptr,
                   .d_u = b.d_u.data(),
                   .d_p = b.d_p.data(),
                   .weak_done = weak_done,
                   .failures = 0};
  g_.law.solve[static_cast<std::size_t>(at_unburnt_ ? RiemannSolver::hllc : g_.setup.options.riemann)](g);
  tile_->failures += g.failures;
}

void TileWork::seal(FaceRow const& row, FluxRow& out) noexcept {
  for (bool low : {true, false}) {
    if (!(low ? row.wall_low : row.wall_high)) continue;
    auto const [first, n] = lanes_on_side(row, low);
    for (std::ptrdiff_t f = first; f < first + static_cast<std::ptrdiff_t>(n); ++f) {
      if (!is_wall(row, low, f)) continue;
      out.mass[f] = 0.0, out.momentum[row.axis][f] = out.p[f], out.energy[f] = 0.0, out.u[f] = 0.0;
    }
  }
}

void TileWork::fluxes(FaceRow const& row, PredictorKernel kernel, FaceProblems& b, FluxRow& out) {
  Increments const inc = increments(row, kernel);
  predict(row, kernel, inc, b, out);
  if (row.wall_low) image_in_wall(row, kernel, inc, true, b);
  if (row.wall_high) image_in_wall(row, kernel, inc, false, b);
  bool const averaged = is_third_order(kernel);
  if (burns_ && !at_unburnt_) leave_unburnt(row, b);
  solve_problems(row, b, averaged, at_once(), out);
  seal(row, out);
  std::size_t const a = static_cast<std::size_t>(row.axis);
  TangentialArguments t{.faces = row.n,
                        .fields = static_cast<std::size_t>(g_.dims - 1),
                        .stride = stride(row.axis),
                        .rho = rho_.data() + row.cell,
                        .u = (averaged ? mean_u_[a] : u_[a]).data() + row.cell,
                        .p = p_.data() + row.cell,
                        .K = K_.data() + row.cell,
                        .velocity = {},
                        .increment = {},
                        .next = {},
                        .h = g_.h[a],
                        .dt = g_.dt,
                        .f_mass = out.mass.data(),
                        .f_energy = out.energy.data(),
                        .f_velocity = {}};
  for (std::size_t k = 0; k < t.fields; ++k) {
    std::size_t const c = other_axis(a, k);
    t.velocity[k] = (averaged ? mean_u_[c] : u_[c]).data() + row.cell;
    t.increment[k] = inc.there ? inc.left.vector[c] : nullptr;
    t.next[k] = inc.there ? inc.right.vector[c] : nullptr;
    t.f_velocity[k] = out.momentum[c].data();
  }
  g_.kernels.predict->grid.tangential[static_cast<std::size_t>(kernel)](t);
}

std::size_t TileWork::other_axis(std::size_t axis, std::size_t k) const noexcept {
  return (axis + 1 + k) % static_cast<std::size_t>(g_.dims);
}

void TileWork::muscl_row(FaceRow const& row, FluxRow& out) {
  std::size_t const a = static_cast<std::size_t>(row.axis);
  // along x the upper edge of a cell is the left side of the face behind it
  std::ptrdiff_t const left = row.axis == 0 ? -1 : 0;
  FaceProblems& b = problems_;
  auto const copy = [&](Padded& to, Padded const& from, std::ptrdiff_t shift) {
    std::copy_n(from.data() + shift, row.n, to.data());
  };
  copy(b.l_rho, row.left->rho, left), copy(b.l_u, row.left->u[a], left), copy(b.l_p, row.left->p, left);
  copy(b.r_rho, row.right->rho, 0), copy(b.r_u, row.right->u[a], 0), copy(b.r_p, row.right->p, 0);
  std::fill_n(b.strong.data(), row.n, 1.0), std::fill_n(b.switched.data(), row.n, 0.0);
  for (std::ptrdiff_t f = 0; f < static_cast<std::ptrdiff_t>(row.n); ++f) {
    bool const low = row.wall_low && (row.axis != 0 || f == 0) && is_wall(row, true, f);
    bool const high =
        row.wall_high && (row.axis != 0 || f + 1 == static_cast<std::ptrdiff_t>(row.n)) && is_wall(row, false, f);
    if (low) b.l_rho[f] = b.r_rho[f], b.l_p[f] = b.r_p[f], b.l_u[f] = -b.r_u[f];
    if (high) b.r_rho[f] = b.l_rho[f], b.r_p[f] = b.l_p[f], b.r_u[f] = -b.l_u[f];
  }
  solve_problems(row, b, false, false, out);
  seal(row, out);
  UpwindArguments t{.faces = row.n,
                    .fields = static_cast<std::size_t>(g_.dims - 1),
                    .left = {},
                    .right = {},
                    .f_mass = out.mass.data(),
                    .f_energy = out.energy.data(),
                    .f_velocity = {}};
  for (std::size_t k = 0; k < t.fields; ++k) {
    std::size_t const c = other_axis(a, k);
    t.left[k] = row.left->u[c].data() + left, t.right[k] = row.right->u[c].data();
    t.f_velocity[k] = out.momentum[c].data();
  }
  g_.kernels.predict->grid.upwind(t);
}

void TileWork::mark(std::vector<double> const& flags, FaceRow const& row, std::size_t& count) {
  std::size_t const cell = static_cast<std::size_t>(row.cell), s = static_cast<std::size_t>(stride(row.axis));
  count = 0;
  for (std::size_t f = 0; f < row.n; ++f) {
    bool const marked = flags[cell + f] > 0 || flags[cell + f + s] > 0;
    mark_[static_cast<std::ptrdiff_t>(f)] = marked ? 1.0 : 0.0;
    count += marked ? 1u : 0u;
  }
}

void TileWork::count_in_map(std::size_t map, FaceRow const& row, Padded const& acted) noexcept {
  GasTile& t = *tile_;
  if (t.maps.empty()) return;
  // to the cell behind the face, where the tile has it
  Int3 const size = t.box.size;
  if ((row.axis == 1 && row.j == size[1]) || (row.axis == 2 && row.k == size[2])) return;
  std::size_t const base = map * t.cells() + static_cast<std::size_t>(size[0] * (row.j + size[1] * row.k));
  for (std::size_t i = 0; i < static_cast<std::size_t>(size[0]); ++i) {
    if (acted[static_cast<std::ptrdiff_t>(i)] > 0) t.maps[base + i] += 1.0f;
  }
}

void TileWork::solve_row(FaceRow const& row, FluxRow& out) {
  GasTile& t = *tile_;
  if (g_.predictor == PredictorKernel::muscl) {
    muscl_row(row, out);
  } else {
    fluxes(row, g_.predictor, problems_, out);
  }
  CountArguments counts{.faces = row.n,
                        .switched = problems_.switched.data(),
                        .strong = problems_.strong.data(),
                        .map = map_.data(),
                        .faces_switched = 0,
                        .faces_strong = 0};
  g_.kernels.predict->count(counts);
  t.faces += static_cast<double>(row.n), t.switched += counts.faces_switched, t.strong += counts.faces_strong;
  count_in_map(0, row, problems_.switched);
  std::size_t marked = 0;
  if (any_cure_) mark(cure_, row, marked);
  if (marked > 0) {
    g_.law.grid.hlle[static_cast<std::size_t>(g_.dims - 2)]({.faces = row.n,
                                                             .eos = g_.eos,
                                                             .stride = stride(row.axis),
                                                             .axis = row.axis,
                                                             .primitive = cells_at(row.cell),
                                                             .mark = mark_.data(),
                                                             .flux = out.out()});
    seal_cured(row, out);
    t.cured += static_cast<double>(marked);
    count_in_map(1, row, mark_);
  }
  if (any_redo_) {
    std::size_t const redone = redo_row(redo_, row, out);
    t.redone += static_cast<double>(redone);
    if (redone > 0) count_in_map(2, row, mark_);
  }
  if (burns_) burn_row(row, out);
}

std::size_t TileWork::redo_row(std::vector<double> const& flags, FaceRow const& row, FluxRow& out) {
  std::size_t marked = 0;
  mark(flags, row, marked);
  if (marked == 0) return 0;
  fluxes(row, PredictorKernel::godunov, other_problems_, other_flux_);
  take_marked(mark_, row.n, out, other_flux_);
  return marked;
}

void TileWork::seal_cured(FaceRow const& row, FluxRow& out) noexcept {
  // between a state and its image HLLE's mass and energy cancel to round-off only
  for (bool low : {true, false}) {
    if (!(low ? row.wall_low : row.wall_high)) continue;
    auto const [first, n] = lanes_on_side(row, low);
    for (std::ptrdiff_t f = first; f < first + static_cast<std::ptrdiff_t>(n); ++f) {
      if (!(mark_[f] > 0) || !is_wall(row, low, f)) continue;
      out.mass[f] = 0.0, out.energy[f] = 0.0;
      for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(g_.dims); ++k) {
        out.momentum[other_axis(static_cast<std::size_t>(row.axis), k)][f] = 0.0;
      }
    }
  }
}

}  // namespace g27
