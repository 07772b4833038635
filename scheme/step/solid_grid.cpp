#include "scheme/step/solid_grid.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scheme/step/gauss.hpp"
#include "scheme/step/solid_grid_impl.hpp"

namespace g27 {

namespace {

/// Tile sizes that measured fastest: a plane's fluxes and terms stay in the second cache.
constexpr Int3 tile_1d{1024, 1, 1}, tile_2d{64, 64, 1}, tile_3d{64, 8, 32};

}  // namespace

SolidGridSetup SolidGrid::Impl::checked(SolidGridSetup s) {
  using Kind = SolidBoundary::Kind;
  int axes = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (s.cells[a] < 1) throw std::invalid_argument("cell numbers are positive");
    if (s.cells[a] == 1) continue;
    ++axes;
    if (s.cells[a] < 4) throw std::invalid_argument("an axis has one cell or at least 4");
    if (!(s.upper[a] > s.lower[a])) throw std::invalid_argument("the box's upper corner must lie above");
    if ((s.sides[2 * a].kind == Kind::periodic) != (s.sides[2 * a + 1].kind == Kind::periodic)) {
      throw std::invalid_argument("a periodic side needs its partner");
    }
    for (std::size_t low : {0u, 1u}) {
      SolidBoundary const& b = s.sides[2 * a + low];
      if (b.kind == Kind::inflow && !b.state) throw std::invalid_argument("an inflow needs its state");
      if (b.kind == Kind::contact) throw std::invalid_argument("a contact bounds lines of cells that move alone");
    }
  }
  if (axes == 0) throw std::invalid_argument("some axis has at least 4 cells");
  if (!(s.material.mu >= 0)) throw std::invalid_argument("the shear modulus is not negative");
  SolidSchemeOptions& o = s.options;
  if (o.predictor == Predictor::muscl) throw std::invalid_argument("solids have no MUSCL-Hancock predictor");
  Int3 const standard = axes == 1 ? tile_1d : s.cells[2] == 1 ? tile_2d : tile_3d;
  for (std::size_t a = 0; a < 3; ++a) {
    if (o.tile[a] <= 0) o.tile[a] = axes == 1 ? tile_1d[0] : standard[a];
    o.tile[a] = std::max(o.tile[a], 4);
  }
  if (!(o.cfl > 0)) o.cfl = s.material.plastic() ? plastic_cfl : elastic_cfl;
  o.threads = std::max(1, o.threads);
  return s;
}

Tiling SolidGrid::Impl::tiling_of(SolidGridSetup const& s) {
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) periodic[a] = s.sides[2 * a].kind == SolidBoundary::Kind::periodic;
  return {s.cells, s.options.tile, periodic, {}};
}

SolidContext SolidGrid::Impl::context_of(Impl& m) {
  SolidGridSetup const& s = m.setup;
  AnySolid const& solid = s.material;
  SolidKernels const& kernels = solid_kernels();
  SolidContext c{.setup = s,
                 .tiling = m.tiling,
                 .tiles = m.tiles,
                 .kernels = kernels,
                 .law = *kernels.eos[solid.eos.index()],
                 .eos = std::visit([](auto const& e) -> void const* { return &e; }, solid.eos),
                 .strength = {solid.mu, solid.Y0, solid.H},
                 .plastic = solid.plastic(),
                 .swept = swept_axes(s.cells),
                 .lower = s.lower,
                 .h = cell_widths(s.lower, s.upper, s.cells)};
  return c;
}

SolidGrid::Impl::Impl(SolidGridSetup s)
    : setup(checked(std::move(s))), tiling(tiling_of(setup)), context(context_of(*this)) {
  Int3 largest{1, 1, 1};
  for (TileId id = 0; id < tiling.count(); ++id) {
    SolidTile t;
    t.box = tiling.box(id);
    t.row = padded_row(t.box.size[0]);
    t.field = t.row * t.box.size[1] * t.box.size[2];
    std::size_t const size = static_cast<std::size_t>(t.field) * solid_conserved::fields + 16;
    t.now.resize(size), t.next.resize(size);
    for (std::size_t a = 0; a < 3; ++a) largest[a] = std::max(largest[a], t.box.size[a]);
    tiles.push_back(std::move(t));
  }
  for (int k = 0; k < setup.options.threads; ++k) works.push_back(std::make_unique<SolidTileWork>(context, largest));
}

Vec3 SolidGrid::Impl::moduli(SolidPoint const& s) const noexcept {
  auto const [K, f] = std::visit(
      [&](auto const& eos) {
        return std::pair{eos.bulk_modulus(s.rho, s.p), eos.gruneisen(s.rho)};
      },
      setup.material.eos);
  Vec3 M{};
  for (std::size_t a = 0; a < 3; ++a) M[a] = K + 4.0 / 3.0 * setup.material.mu - f * s.S[a];
  return M;
}

double SolidGrid::Impl::signal_rate(SolidVector const& q) const noexcept {
  SolidPoint const s = primitive(q);
  Vec3 const M = moduli(s);
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (context.swept[a]) sum += (std::fabs(s.u[a]) + std::sqrt(std::max(M[a], 0.0) / s.rho)) * (1.0 / context.h[a]);
  }
  return sum;
}

Vec3 SolidGrid::Impl::centre(Int3 const& cell) const noexcept {
  return cell_centre(context.lower, context.h, context.swept, cell);
}

void SolidGrid::Impl::set(std::function<SolidVector(Int3 const&)> const& mean, double t) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(tiles.size());
#pragma omp parallel for num_threads(setup.options.threads) schedule(dynamic, 1)
  for (std::ptrdiff_t id = 0; id < n; ++id) {
    SolidTile& tile = tiles[static_cast<std::size_t>(id)];
    tile.rate = 0;
    for (int k = 0; k < tile.box.size[2]; ++k) {
      for (int j = 0; j < tile.box.size[1]; ++j) {
        for (int i = 0; i < tile.box.size[0]; ++i) {
          SolidVector const q = mean({tile.box.first[0] + i, tile.box.first[1] + j, tile.box.first[2] + k});
          FieldRows const to = tile.at(tile.now, i, j, k);
          for (std::size_t d = 0; d < q.size(); ++d) *to[static_cast<int>(d)] = q[d];
          double const r = signal_rate(q);
          if (!(r <= tile.rate)) tile.rate = r;
        }
      }
    }
  }
  context.time = t;
  counters = {};
  initial = boundary = source = {};
  plastic_work = {};
  scale = {};
  add_totals(initial, scale);
  rate = 0;
  for (SolidTile const& tile : tiles) {
    if (!(tile.rate <= rate)) rate = tile.rate;
  }
}

void SolidGrid::Impl::add_totals(std::array<Accumulator, 5>& total, std::array<double, 5>& magnitude) const {
  double const v = context.volume();
  for (SolidTile const& t : tiles) {
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          SolidVector const q = t.densities(t.index(i, j, k));
          double const M = std::max(moduli(primitive(q))[0], 0.0);
          for (std::size_t d = 0; d < 5; ++d) total[d].add(v * q[d]);
          magnitude[0] += v * std::fabs(q[0]), magnitude[4] += v * (std::fabs(q[4]) + M);
          for (std::size_t d = 1; d < 4; ++d) magnitude[d] += v * (std::fabs(q[d]) + std::sqrt(M * q[0]));
        }
      }
    }
  }
}

SolidGrid::SolidGrid(SolidGridSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
SolidGrid::~SolidGrid() = default;
SolidGrid::SolidGrid(SolidGrid&&) noexcept = default;
SolidGrid& SolidGrid::operator=(SolidGrid&&) noexcept = default;

void SolidGrid::set_state(std::function<SolidPoint(Vec3 const& x)> const& state, int points) {
  auto const gauss = gauss_points(points);
  Impl const& m = *impl_;
  auto const loops = [&](std::size_t a) { return m.context.swept[a] ? points : 1; };
  set_averages([&](Vec3 const& centre, Vec3 const& h) {
    SolidVector sum{};
    for (int c = 0; c < loops(2); ++c) {
      for (int b = 0; b < loops(1); ++b) {
        for (int a = 0; a < loops(0); ++a) {
          std::array<int, 3> const at{a, b, c};
          Vec3 x = centre;
          double weight = 1;
          for (std::size_t d = 0; d < 3; ++d) {
            if (!m.context.swept[d]) continue;
            GaussPoint const& g = gauss[static_cast<std::size_t>(at[d])];
            x[d] += 0.5 * h[d] * g.x, weight *= 0.5 * g.weight;
          }
          SolidVector const q = m.conserved(state(x));
          for (std::size_t d = 0; d < q.size(); ++d) sum[d] += weight * q[d];
        }
      }
    }
    return densities_of(sum);
  });
}

void SolidGrid::set_averages(std::function<SolidDensities(Vec3 const& centre, Vec3 const& widths)> const& mean,
                             double time) {
  set_cells([&](Int3 const& cell) { return mean(impl_->centre(cell), impl_->context.h); }, time);
}

void SolidGrid::set_cells(std::function<SolidDensities(Int3 const& cell)> const& mean, double time) {
  impl_->set([&](Int3 const& cell) { return vector_of(mean(cell)); }, time);
}

void SolidGrid::replace(std::span<Int3 const> cells, std::span<SolidDensities const> averages) {
  Impl& m = *impl_;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    SolidTile& t = m.tiles[static_cast<std::size_t>(m.tiling.at(cells[n]))];
    SolidVector const q = vector_of(averages[n]);
    FieldRows const to =
        t.at(t.now, cells[n][0] - t.box.first[0], cells[n][1] - t.box.first[1], cells[n][2] - t.box.first[2]);
    for (std::size_t d = 0; d < q.size(); ++d) *to[static_cast<int>(d)] = q[d];
    t.rate = std::max(t.rate, m.signal_rate(q));
    m.rate = std::max(m.rate, t.rate);
  }
}

void SolidGrid::compute_only(std::span<Int3 const> cells) {
  Impl& m = *impl_;
  for (SolidTile& t : m.tiles) t.active = false;
  for (Int3 const& c : cells) m.tiles[static_cast<std::size_t>(m.tiling.at(c))].active = true;
  for (SolidTile& t : m.tiles) {
    if (!t.active) t.rate = 0, t.least = 1;
  }
}

bool SolidGrid::computes(Int3 const& cell) const noexcept {
  return impl_->tiles[static_cast<std::size_t>(impl_->tiling.at(cell))].active;
}

GridStepReport SolidGrid::step(double t_end) { return impl_->step(t_end); }
void SolidGrid::rest(double t_end) noexcept { impl_->context.time += t_end - impl_->context.time; }
int SolidGrid::dimensions() const noexcept {
  int axes = 0;
  for (bool swept : impl_->context.swept) axes += swept ? 1 : 0;
  return axes;
}
Int3 SolidGrid::cells() const noexcept { return impl_->setup.cells; }
std::size_t SolidGrid::cell_count() const noexcept {
  std::size_t n = 0;
  for (SolidTile const& t : impl_->tiles) n += t.cells();
  return n;
}
Vec3 SolidGrid::widths() const noexcept { return impl_->context.h; }
Vec3 SolidGrid::centre(Int3 const& cell) const noexcept { return impl_->centre(cell); }
double SolidGrid::time() const noexcept { return impl_->context.time; }
double SolidGrid::stable_dt() const noexcept { return impl_->setup.options.cfl / impl_->rate; }
double SolidGrid::signal_rate() const noexcept { return impl_->rate; }
double SolidGrid::signal_rate_of(SolidDensities const& cell) const noexcept {
  return impl_->signal_rate(vector_of(cell));
}
void SolidGrid::set_signal_rate(double rate) noexcept { impl_->rate = rate; }
SolidDensities SolidGrid::conserved(SolidPoint const& s) const noexcept { return densities_of(impl_->conserved(s)); }

SolidDensities SolidGrid::average(Int3 const& cell) const noexcept {
  SolidTile const& t = impl_->tiles[static_cast<std::size_t>(impl_->tiling.at(cell))];
  return densities_of(
      t.densities(t.index(cell[0] - t.box.first[0], cell[1] - t.box.first[1], cell[2] - t.box.first[2])));
}

SolidPoint SolidGrid::primitive(Int3 const& cell) const noexcept { return impl_->primitive(vector_of(average(cell))); }

std::vector<double> SolidGrid::field(Field which) const {
  Int3 const n = cells();
  std::vector<double> out(cell_count());
  for (SolidTile const& t : impl_->tiles) {
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          SolidVector const q = t.densities(t.index(i, j, k));
          SolidPoint const s = impl_->primitive(q);
          std::size_t const to = cell_number(n, {t.box.first[0] + i, t.box.first[1] + j, t.box.first[2] + k});
          out[to] = solid_field(which, s, internal_energy(q));
        }
      }
    }
  }
  return out;
}

SolidCounters const& SolidGrid::counters() const noexcept { return impl_->counters; }

SolidLedger SolidGrid::ledger() const {
  std::array<Accumulator, 5> total{};
  std::array<double, 5> magnitude{};
  Impl const& m = *impl_;
  m.add_totals(total, magnitude);
  return solid_ledger(m.initial, total, m.boundary, m.source, m.scale, magnitude, m.plastic_work);
}

SolidGridSetup const& SolidGrid::setup() const noexcept { return impl_->setup; }

std::size_t SolidGrid::bytes() const noexcept {
  std::size_t sum = 0;
  for (SolidTile const& t : impl_->tiles) sum += (t.now.size() + t.next.size()) * sizeof(double) + sizeof(SolidTile);
  for (auto const& work : impl_->works) sum += work->bytes();
  return sum;
}

}  // namespace g27
