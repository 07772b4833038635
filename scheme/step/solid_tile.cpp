/// The sweep over a tile: half-step terms row by row, then every face once, with only the rows kept that are still
/// needed; a row of cells is corrected as soon as its last faces are there.
#include "scheme/step/solid_tile.hpp"

#include <algorithm>

#include "scheme/step/solid_boundary.hpp"

namespace g27 {

namespace {

std::size_t line_length(int cells, int halo) noexcept {
  return static_cast<std::size_t>((cells + 2 * halo + 8 + 7) / 8 * 8);
}

}  // namespace

SolidTileWork::SolidTileWork(SolidContext const& context, Int3 const& largest) : g_(context) {
  SolidSchemeOptions const& o = g_.setup.options;
  int axes = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    halo_[a] = g_.swept[a] ? solid_halo : 0;
    axes += g_.swept[a] ? 1 : 0;
  }
  terms_ = o.predictor != Predictor::godunov &&
           ((axes > 1 && o.transverse != Transverse::none) || static_cast<bool>(g_.setup.source.primitive_rate));
  std::size_t const n = line_length(largest[0], halo_[0]);
  volume_ = static_cast<std::ptrdiff_t>(n) * (largest[1] + 2 * halo_[1]) * (largest[2] + 2 * halo_[2]);
  cells_ = Padded(static_cast<std::size_t>(volume_) * solid_cell::fields, 1.0);
  auto const terms = [&] { return RowBlock(solid_cell::terms, n); };
  auto const flux = [&] { return RowBlock(solid_face::fields, n); };
  gathered_ = RowBlock(solid_conserved::fields, n, 1.0), source_ = RowBlock(solid_conserved::fields, n);
  averaged_left_ = terms(), x_terms_ = terms(), z_new_terms_ = terms(), y_terms_ = {terms(), terms()};
  given_ = RowBlock(3, n), one_face_ = flux(), z_new_flux_ = flux();
  std::size_t const rows = g_.swept[2] ? static_cast<std::size_t>(largest[1]) + 1 : 2;
  x_flux_.assign(rows, flux()), y_flux_.assign(rows, flux());
  if (g_.swept[2]) z_terms_.assign(rows, terms()), z_flux_.assign(rows, flux());
}

std::size_t SolidTileWork::bytes() const noexcept {
  std::size_t sum = static_cast<std::size_t>(volume_) * solid_cell::fields * sizeof(double);
  for (auto const* rows : {&z_terms_, &x_flux_, &y_flux_, &z_flux_}) {
    for (RowBlock const& b : *rows) sum += b.bytes();
  }
  return sum;
}

void SolidTileWork::step(TileId id) {
  id_ = id, tile_ = &g_.tiles[static_cast<std::size_t>(id)];
  SolidTile& t = *tile_;
  nx_ = t.box.size[0], ny_ = t.box.size[1], nz_ = t.box.size[2];
  sj_ = static_cast<std::ptrdiff_t>(line_length(nx_, halo_[0])), sk_ = sj_ * (ny_ + 2 * halo_[1]);
  origin_ = halo_[0] + sj_ * halo_[1] + sk_ * halo_[2];
  t.least = 1, t.rate = 0;
  t.faces = t.switched = t.tangents = t.yielded = t.plastic_work = 0;
  t.through = t.from_source = {};
  for (int k = -halo_[2]; k < nz_ + halo_[2]; ++k) {
    for (int j = -halo_[1]; j < ny_ + halo_[1]; ++j) gather_row(j, k);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (bool low : {true, false}) {
      if (box_ends(axis, low)) fill_side(axis, low);
    }
  }
  sweep();
}

void SolidTileWork::sweep() {
  int const ey = g_.swept[1] ? 1 : 0, ez = g_.swept[2] ? 1 : 0;
  for (int k = -ez; k < nz_ + ez; ++k) {
    bool const inside_z = k >= 0 && k < nz_;
    for (int j = -ey; j < ny_ + ey; ++j) {
      bool const inside_y = j >= 0 && j < ny_;
      if (!inside_y && !inside_z) continue;
      if (terms_) set_terms(j, k);
      if (inside_y && ez > 0) z_faces(j, k);
      if (!inside_z) continue;
      if (inside_y && g_.swept[0]) x_faces(j, k);
      if (ey > 0 && j >= 0) y_faces(j, k);
      if (ez == 0 && j - ey >= 0) correct(j - ey, k, nullptr, nullptr);
    }
  }
}

void SolidTileWork::set_terms(int j, int k) {
  bool const inside_y = j >= 0 && j < ny_, inside_z = k >= 0 && k < nz_;
  int const lead = g_.swept[0] ? 1 : 0;
  bool const crossed = g_.setup.options.transverse != Transverse::none;
  SolidTransverseArguments t{.cells = static_cast<std::size_t>(nx_ + 2 * lead),
                             .cell = cells_at(index(-lead, j, k)),
                             .stride = {1, sj_, sk_},
                             .quarter_dt_over_h = {},
                             .mu = g_.strength.mu,
                             .term = {}};
  for (std::size_t a = 0; a < 3; ++a) t.quarter_dt_over_h[a] = g_.swept[a] && crossed ? 0.25 * g_.dt / g_.h[a] : 0.0;
  auto const from_first = [lead](RowBlock& b) { return b.rows().from(-lead); };
  if (inside_y && inside_z && g_.swept[0]) t.term[0] = from_first(x_terms_);
  if (inside_z && g_.swept[1]) t.term[1] = from_first(y_terms_[static_cast<std::size_t>((j + 2) % 2)]);
  if (inside_y && g_.swept[2]) t.term[2] = from_first(z_new_terms_);
  g_.kernels.loops->transverse(t);
  if (!g_.setup.source.primitive_rate) return;
  for (FieldRows const& term : t.term) {
    if (term.data != nullptr) add_sources(term.from(lead), j, k);
  }
}

void SolidTileWork::add_sources(FieldRows const& term, int j, int k) const {
  namespace cell = solid_cell;
  int const lead = g_.swept[0] ? 1 : 0;
  // the mean over the step of what has accumulated along a characteristic is half a step of the rate a third on
  for (int i = -lead; i < nx_ + lead; ++i) {
    SolidRate const r = g_.setup.source.primitive_rate(centre({i, j, k}), g_.time + g_.dt / 3.0);
    double const half = 0.5 * g_.dt;
    term[cell::rho][i] += half * r.rho, term[cell::p][i] += half * r.p, term[cell::e][i] += half * r.e;
    term[cell::ep][i] += half * r.ep;
    for (int a = 0; a < 3; ++a) term[cell::u + a][i] += half * r.u[static_cast<std::size_t>(a)];
    for (int a = 0; a < 6; ++a) term[cell::S + a][i] += half * r.S[static_cast<std::size_t>(a)];
  }
}

void SolidTileWork::faces(int axis, std::ptrdiff_t cell, std::size_t n, FieldRows left, FieldRows right,
                          FieldRows out) {
  SolidSchemeOptions const& o = g_.setup.options;
  if (terms_ && o.transverse == Transverse::averaged) {
    FieldRows const mean = averaged_left_.rows();
    for (int d = 0; d < solid_cell::terms; ++d) {
      for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) mean[d][i] = 0.5 * (left[d][i] + right[d][i]);
    }
    left = right = mean;
  }
  SolidFaceArguments f{.faces = n,
                       .stride = stride(axis),
                       .axis = axis,
                       .cells = cells_at(cell),
                       .left = terms_ ? left : FieldRows{},
                       .right = terms_ ? right : FieldRows{},
                       .dt = g_.dt,
                       .h = g_.h[static_cast<std::size_t>(axis)],
                       .strength = g_.strength,
                       .plastic = g_.plastic,
                       .tangent = o.tangent,
                       .monotonicity = o.monotonicity,
                       .out = out,
                       .switched = 0,
                       .tangents = 0};
  g_.kernels.faces[static_cast<std::size_t>(o.predictor)](f);
  tile_->faces += static_cast<double>(n), tile_->switched += f.switched, tile_->tangents += f.tangents;
}

void SolidTileWork::boundary_faces(int axis, bool low, Int3 const& cell, std::size_t n, FieldRows terms,
                                   FieldRows out) {
  SolidBoundary const& b = side(axis, low);
  std::size_t const a = static_cast<std::size_t>(axis);
  FieldRows const given = given_.rows();
  for (int i = 0; i < static_cast<int>(n); ++i) {
    Vec3 x = centre(axis == 0 ? cell : Int3{cell[0] + i, cell[1], cell[2]});
    x[a] += low ? -0.5 * g_.h[a] : 0.5 * g_.h[a];
    Vec3 const value = given_value(b, a, x, g_.time, g_.dt);
    for (int c = 0; c < 3; ++c) given[c][i] = value[static_cast<std::size_t>(c)];
  }
  SolidSchemeOptions const& o = g_.setup.options;
  SolidBoundaryArguments f{.faces = n,
                           .inward = low ? stride(axis) : -stride(axis),
                           .axis = axis,
                           .side = low ? -1.0 : 1.0,
                           .kind = condition_of(b.kind),
                           .given = given,
                           .cells = cells_at(index(cell[0], cell[1], cell[2])),
                           .terms = terms_ ? terms : FieldRows{},
                           .dt = g_.dt,
                           .h = g_.h[a],
                           .strength = g_.strength,
                           .plastic = g_.plastic,
                           .tangent = o.tangent,
                           .predictor = o.predictor,
                           .limited = o.monotonicity != Switch::off,
                           .out = out};
  g_.kernels.loops->boundary(f);
}

void SolidTileWork::x_faces(int j, int k) {
  FieldRows const flux = x_flux_[slot(j)].rows(), term = x_terms_.rows();
  faces(0, index(-1, j, k), static_cast<std::size_t>(nx_ + 1), term.from(-1), term, flux);
  for (bool low : {true, false}) {
    if (!box_ends(0, low)) continue;
    int const cell = low ? 0 : nx_ - 1, face = low ? 0 : nx_;
    if (bounded(0, low)) {
      FieldRows const one = one_face_.rows();
      boundary_faces(0, low, {cell, j, k}, 1, term.from(cell), one);
      for (int d = 0; d < solid_face::fields; ++d) flux[d][face] = one[d][0];
    }
    account(0, low, flux, face, 1);
  }
}

void SolidTileWork::y_faces(int j, int k) {
  std::size_t const n = static_cast<std::size_t>(nx_);
  FieldRows const flux = y_flux_[slot(j)].rows();
  FieldRows const left = y_terms_[static_cast<std::size_t>((j + 1) % 2)].rows(),
                  right = y_terms_[static_cast<std::size_t>(j % 2)].rows();
  bool const low = j == 0 && box_ends(1, true), high = j == ny_ && box_ends(1, false);
  if ((low || high) && bounded(1, low)) {
    boundary_faces(1, low, {0, low ? 0 : ny_ - 1, k}, n, low ? right : left, flux);
  } else {
    faces(1, index(0, j - 1, k), n, left, right, flux);
  }
  if (low || high) account(1, low, flux, 0, n);
}

void SolidTileWork::z_faces(int j, int k) {
  std::size_t const n = static_cast<std::size_t>(nx_), row = static_cast<std::size_t>(j);
  if (k >= 0) {
    FieldRows const flux = z_new_flux_.rows(), left = z_terms_[row].rows(), right = z_new_terms_.rows();
    bool const low = k == 0 && box_ends(2, true), high = k == nz_ && box_ends(2, false);
    if ((low || high) && bounded(2, low)) {
      boundary_faces(2, low, {0, j, low ? 0 : nz_ - 1}, n, low ? right : left, flux);
    } else {
      faces(2, index(0, j, k - 1), n, left, right, flux);
    }
    if (low || high) account(2, low, flux, 0, n);
    if (k > 0) correct(j, k - 1, &z_flux_[row], &z_new_flux_);
    std::swap(z_flux_[row], z_new_flux_);
  }
  std::swap(z_terms_[row], z_new_terms_);
}

void SolidTileWork::correct(int j, int k, RowBlock* z_lower, RowBlock* z_upper) {
  SolidTile& t = *tile_;
  SolidGridSetup const& s = g_.setup;
  SolidCorrectArguments c{.cells = static_cast<std::size_t>(nx_),
                          .now = t.at(t.now, 0, j, k),
                          .next = t.at(t.next, 0, j, k),
                          .source = {},
                          .lower = {},
                          .upper = {},
                          .lambda = {},
                          .strength = g_.strength,
                          .plastic = g_.plastic,
                          .midpoint = s.options.midpoint,
                          .yielded = 0,
                          .plastic_work = 0};
  for (std::size_t a = 0; a < 3; ++a) c.lambda[a] = g_.dt / g_.h[a];
  if (g_.swept[0]) c.lower[0] = x_flux_[slot(j)].rows(), c.upper[0] = c.lower[0].from(1);
  if (g_.swept[1]) c.lower[1] = y_flux_[slot(j)].rows(), c.upper[1] = y_flux_[slot(j + 1)].rows();
  if (z_lower != nullptr) c.lower[2] = z_lower->rows(), c.upper[2] = z_upper->rows();
  if (s.source.mean) {
    c.source = source_.rows();
    for (int i = 0; i < nx_; ++i) {
      SolidDensities const q = s.source.mean(centre({i, j, k}), g_.h, g_.time, g_.dt);
      SolidVector const v = vector_of(q);
      for (std::size_t d = 0; d < v.size(); ++d) {
        c.source[static_cast<int>(d)][i] = g_.dt * v[d];
        if (d < t.from_source.size()) t.from_source[d] += g_.volume() * g_.dt * v[d];
      }
    }
  }
  g_.kernels.loops->correct(c);
  t.yielded += c.yielded, t.plastic_work += g_.volume() * c.plastic_work;
  SolidFinishArguments f{.cells = static_cast<std::size_t>(nx_),
                         .eos = g_.eos,
                         .mu = g_.strength.mu,
                         .conserved = c.next,
                         .rho_old = cells_.data() + index(0, j, k),
                         .inv_h = {},
                         .least = t.least,
                         .rate = t.rate};
  for (std::size_t a = 0; a < 3; ++a) f.inv_h[a] = g_.swept[a] ? 1.0 / g_.h[a] : 0.0;
  g_.law.finish(f);
  t.least = f.least, t.rate = f.rate;
}

void SolidTileWork::account(int axis, bool low, FieldRows const& flux, std::ptrdiff_t lane, std::size_t n) noexcept {
  double const area = g_.volume() / g_.h[static_cast<std::size_t>(axis)], sign = low ? 1.0 : -1.0;
  for (int d = 0; d < 5; ++d) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += flux[d][lane + static_cast<std::ptrdiff_t>(i)];
    tile_->through[static_cast<std::size_t>(d)] += sign * area * g_.dt * sum;
  }
}

}  // namespace g27
