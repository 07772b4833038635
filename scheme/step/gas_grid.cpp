#include "scheme/step/gas_grid.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scheme/step/gas_grid_impl.hpp"
#include "scheme/step/gauss.hpp"

namespace g27 {

namespace {

/// Tile sizes that measured fastest: rows of many vectors, and arrays that stay in the second cache. A small grid takes
/// smaller ones, or there would be nothing to skip and nothing to share among threads.
constexpr Int3 tile_2d{128, 64, 1}, tile_3d{128, 16, 32}, small_2d{32, 32, 1}, small_3d{32, 16, 16};
constexpr int small_grid = 96;  ///< cells along x up to which tiles are small

}  // namespace

GasGridSetup GasGrid::Impl::checked(GasGridSetup s) {
  if (s.cells[2] < 1 || s.cells[1] < 1 || s.cells[0] < 1) throw std::invalid_argument("cell numbers are positive");
  for (std::size_t a = 0; a < 3; ++a) {
    if (s.cells[a] > 1 && s.cells[a] < 4) throw std::invalid_argument("an axis has one cell or at least 4");
    if (s.cells[a] > 1 && !(s.upper[a] > s.lower[a]))
      throw std::invalid_argument("the box's upper corner must lie above");
    if ((s.sides[2 * a].kind == GridBoundary::Kind::periodic) !=
        (s.sides[2 * a + 1].kind == GridBoundary::Kind::periodic)) {
      throw std::invalid_argument("a periodic side needs its partner");
    }
  }
  if (s.cells[0] < 4) throw std::invalid_argument("x has at least 4 cells");
  for (GridBoundary const& b : s.sides) {
    if (b.kind == GridBoundary::Kind::inflow && !b.state) throw std::invalid_argument("an inflow needs its state");
  }
  for (SolidBlock const& b : s.blocks) {
    for (std::size_t a = 0; a < 3; ++a) {
      bool const sound = b.first[a] >= 0 && b.last[a] <= s.cells[a] && b.last[a] > b.first[a];
      bool const roomy =
          s.cells[a] == 1 || ((b.first[a] == 0 || b.first[a] >= 4) &&
                              (b.last[a] == s.cells[a] || s.cells[a] - b.last[a] >= 4) && b.last[a] - b.first[a] >= 4);
      if (!sound || !roomy)
        throw std::invalid_argument("a block is at least 4 cells wide and leaves none or 4 beside it");
    }
  }
  if (s.burn.there() && s.source.mean) throw std::invalid_argument("a burn goes without other sources");
  if (s.options.predictor == Predictor::muscl && s.source.primitive_rate) {
    throw std::invalid_argument("MUSCL-Hancock knows no sources here");
  }
  bool const small = s.cells[0] <= small_grid, space = s.cells[2] > 1;
  Int3 const standard = space ? (small ? small_3d : tile_3d) : (small ? small_2d : tile_2d);
  for (std::size_t a = 0; a < 3; ++a) {
    if (s.options.tile[a] <= 0) s.options.tile[a] = standard[a];
    s.options.tile[a] = std::max(s.options.tile[a], 4);
  }
  s.options.threads = std::max(1, s.options.threads);
  return s;
}

Tiling GasGrid::Impl::tiling_of(GasGridSetup const& s) {
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) periodic[a] = s.sides[2 * a].kind == GridBoundary::Kind::periodic;
  return {s.cells, s.options.tile, periodic, s.blocks};
}

GridContext GasGrid::Impl::context_of(Impl& m) {
  GasGridSetup const& s = m.setup;
  GridSchemeOptions const& o = s.options;
  GasKernels const& kernels = gas_kernels();
  PredictorKernel const predictor = predictor_kernel(o.predictor, o.monotonicity, FootPoints::conservative, false);
  GridContext c{.setup = s,
                .tiling = m.tiling,
                .tiles = m.tiles,
                .kernels = kernels,
                .law = *kernels.eos[s.eos.index()],
                .predictor = predictor,
                .eos = std::visit([](auto const& e) -> void const* { return &e; }, s.eos),
                .exponent = std::visit([](auto const& e) { return e.isentropic_exponent(); }, s.eos),
                .energy_line = {},
                .dims = s.cells[2] > 1 ? 3 : 2,
                .swept = swept_axes(s.cells),
                .lower = s.lower,
                .h = cell_widths(s.lower, s.upper, s.cells),
                .halo = is_third_order(predictor) ? 3 : 2};
  c.energy_line = c.law.energy_line(c.eos);
  return c;
}

GasGrid::Impl::Impl(GasGridSetup s)
    : setup(checked(std::move(s))), tiling(tiling_of(setup)), context(context_of(*this)) {
  Int3 largest{1, 1, 1};
  for (TileId id = 0; id < tiling.count(); ++id) {
    GasTile t;
    t.box = tiling.box(id);
    t.row = padded_row(t.box.size[0]);
    t.field = t.row * t.box.size[1] * t.box.size[2];
    if (!setup.blocks.empty()) t.edges = block_edges(t.box);
    if (setup.options.maps) t.maps.assign(3 * t.cells(), 0.0f);
    for (std::size_t a = 0; a < 3; ++a) largest[a] = std::max(largest[a], t.box.size[a]);
    tiles.push_back(std::move(t));
  }
  if (setup.burn.there()) set_lighting();
  for (int k = 0; k < setup.options.threads; ++k) works.push_back(std::make_unique<TileWork>(context, largest));
}

void GasGrid::Impl::set_lighting() {
  double const crossing = setup.burn.crossing(context.width());
#pragma omp parallel for num_threads(setup.options.threads) schedule(dynamic, 1)
  for (std::size_t id = 0; id < tiles.size(); ++id) {
    GasTile& t = tiles[id];
    std::array<int, 3> halo{};
    for (std::size_t a = 0; a < 3; ++a) halo[a] = context.swept[a] ? 2 : 0;
    for (int k = -halo[2]; k < t.box.size[2] + halo[2]; ++k) {
      for (int j = -halo[1]; j < t.box.size[1] + halo[1]; ++j) {
        for (int i = -halo[0]; i < t.box.size[0] + halo[0]; ++i) {
          double const lit = setup.burn.lighting(centre({t.box.first[0] + i, t.box.first[1] + j, t.box.first[2] + k}));
          if (lit == ProgrammedBurn::no_explosive) continue;
          t.first_lit = std::min(t.first_lit, lit - crossing), t.last_lit = std::max(t.last_lit, lit + crossing);
        }
      }
    }
  }
}

std::vector<Int3> GasGrid::Impl::block_edges(TileBox const& box) const {
  std::vector<Int3> cells;
  enum class What { gas, solid, outside };
  auto const what = [&](Int3 cell) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cell[a] >= 0 && cell[a] < setup.cells[a]) continue;
      if (setup.sides[2 * a].kind != GridBoundary::Kind::periodic) return What::outside;
      cell[a] = (cell[a] + setup.cells[a]) % setup.cells[a];
    }
    return tiling.at(cell) < 0 ? What::solid : What::gas;
  };
  auto const moved = [](Int3 cell, std::size_t axis, int by) {
    cell[axis] += by;
    return cell;
  };
  // a block's cell that gas touches along two axes
  auto const edge = [&](Int3 const& cell) {
    if (what(cell) != What::solid) return false;
    int axes = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      bool const touched = what(moved(cell, a, -1)) == What::gas || what(moved(cell, a, 1)) == What::gas;
      if (context.swept[a] && touched) ++axes;
    }
    return axes > 1;
  };
  std::array<int, 3> reach{};
  for (std::size_t a = 0; a < 3; ++a) reach[a] = context.swept[a] ? context.halo - 1 : 0;
  for (int k = -reach[2]; k < box.size[2] + reach[2]; ++k) {
    for (int j = -reach[1]; j < box.size[1] + reach[1]; ++j) {
      for (int i = -reach[0]; i < box.size[0] + reach[0]; ++i) {
        Int3 const cell{box.first[0] + i, box.first[1] + j, box.first[2] + k};
        bool beside = false;
        for (std::size_t a = 0; a < 3; ++a) {
          if (context.swept[a]) beside = beside || edge(moved(cell, a, -1)) || edge(moved(cell, a, 1));
        }
        if (beside && what(cell) == What::gas) cells.push_back({i, j, k});
      }
    }
  }
  return cells;
}

FiveDensities GasGrid::Impl::densities(GasTile const& t, std::ptrdiff_t i) const noexcept {
  FiveDensities q{};
  for (std::size_t d = 0; d < 5; ++d) {
    if (context.dims == 3 || d != 3) q[d] = t.at(t.now, d, i);
  }
  return q;
}

GasPoint GasGrid::Impl::primitive(FiveDensities const& q) const noexcept {
  GasPoint s{q[0], {q[1] / q[0], q[2] / q[0], q[3] / q[0]}, 0};
  double const e = q[4] / q[0] - 0.5 * s.u[0] * s.u[0] - 0.5 * s.u[1] * s.u[1] - 0.5 * s.u[2] * s.u[2];
  s.p = std::visit([&](auto const& eos) { return eos.pressure(q[0], e); }, setup.eos);
  return s;
}

FiveDensities GasGrid::Impl::conserved(GasPoint const& s) const noexcept {
  double const e = std::visit([&](auto const& eos) { return eos.energy(s.rho, s.p); }, setup.eos);
  double kinetic = 0;
  for (double u : s.u) kinetic += 0.5 * s.rho * u * u;
  return {s.rho, s.rho * s.u[0], s.rho * s.u[1], s.rho * s.u[2], s.rho * e + kinetic};
}

double GasGrid::Impl::bulk_modulus(GasPoint const& s) const noexcept {
  return std::visit([&](auto const& eos) { return eos.bulk_modulus(s.rho, s.p); }, setup.eos);
}

double GasGrid::Impl::margin(GasPoint const& s) const noexcept {
  return std::visit([&](auto const& eos) { return eos.pressure_margin(s.rho, s.p); }, setup.eos);
}

double GasGrid::Impl::signal_rate(FiveDensities const& q) const noexcept {
  // by the loop that gives it after a step, so that a grid set from stored averages takes the same steps, bit by bit
  std::array<std::array<double, vector_cells>, 5> lanes;
  for (std::size_t d = 0; d < 5; ++d) lanes[d].fill(q[d]);
  GridFinishArguments f{
      .cells = 1,
      .eos = context.eos,
      .conserved = RowIn::of({lanes[0].data(), lanes[1].data(), lanes[2].data(), lanes[3].data(), lanes[4].data()}),
      .rho_old = lanes[0].data(),
      .margin_old = lanes[0].data(),
      .inv_h = {},
      .max_rule = setup.options.max_rule,
      .like = {},
      .worst = 1,
      .rate = 0,
      .differs = true};
  for (std::size_t a = 0; a < 3; ++a) f.inv_h[a] = context.swept[a] ? 1.0 / context.h[a] : 0.0;
  context.law.grid.finish[static_cast<std::size_t>(context.dims - 2)](f);
  return f.rate;
}

Vec3 GasGrid::Impl::centre(Int3 const& cell) const noexcept {
  return cell_centre(context.lower, context.h, context.swept, cell);
}

void GasGrid::Impl::set(std::function<FiveDensities(Int3 const&)> const& mean, double t) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(tiles.size());
#pragma omp parallel for num_threads(setup.options.threads) schedule(dynamic, 1)
  for (std::ptrdiff_t id = 0; id < n; ++id) {
    GasTile& tile = tiles[static_cast<std::size_t>(id)];
    tile.now = {}, tile.next = {}, tile.uniform = true, tile.rate = 0;
    Int3 const& size = tile.box.size;
    bool begun = false;
    for (int k = 0; k < size[2]; ++k) {
      for (int j = 0; j < size[1]; ++j) {
        for (int i = 0; i < size[0]; ++i) {
          FiveDensities const q = mean({tile.box.first[0] + i, tile.box.first[1] + j, tile.box.first[2] + k});
          if (!begun) tile.state = q, begun = true;
          if (tile.uniform && q != tile.state) {
            tile.store_state(context.dims);
            tile.uniform = false;
          }
          if (!tile.uniform) {
            for (std::size_t d = 0; d < 5; ++d) {
              if (context.dims == 2 && d == 3) continue;
              tile.now[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * tile.field + tile.index(i, j, k))] =
                  q[d];
            }
          }
          tile.rate = std::max(tile.rate, signal_rate(q));
        }
      }
    }
    if (!setup.options.skip) tile.store_state(context.dims);
  }
  start(t);
}

void GasGrid::Impl::start(double t) {
  context.time = t;
  counters = {};
  initial = boundary = source = floor = {};
  scale = {};
  add_totals(initial, &scale);
  rate = 0, largest_density = 0;
  for (GasTile const& tile : tiles) {
    rate = std::max(rate, tile.rate);
    for (int k = 0; k < tile.box.size[2]; ++k) {
      for (int j = 0; j < tile.box.size[1]; ++j) {
        for (int i = 0; i < tile.box.size[0]; ++i) {
          largest_density = std::max(largest_density, tile.at(tile.now, 0, tile.index(i, j, k)));
          if (tile.uniform) break;
        }
      }
    }
  }
}

void GasGrid::Impl::add_totals(std::array<Accumulator, 5>& total, FiveDensities* magnitude) const {
  double const v = volume();
  struct Sums {
    std::array<Accumulator, 5> sum{};
    FiveDensities size{};
  };
  std::vector<Sums> of_tiles(tiles.size());
#pragma omp parallel for num_threads(setup.options.threads) schedule(dynamic, 1)
  for (std::size_t id = 0; id < tiles.size(); ++id) {
    GasTile const& t = tiles[id];
    auto& [sum, size] = of_tiles[id];
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          FiveDensities const q = densities(t, t.index(i, j, k));
          for (std::size_t d = 0; d < 5; ++d) sum[d].add(v * q[d]);
          if (magnitude == nullptr) continue;
          double const K = bulk_modulus(primitive(q));
          size[0] += v * std::fabs(q[0]);
          for (std::size_t d = 1; d < 4; ++d) size[d] += v * (std::fabs(q[d]) + std::sqrt(K * q[0]));
          size[4] += v * (std::fabs(q[4]) + K);
        }
      }
    }
  }
  for (Sums const& tile : of_tiles) {
    for (std::size_t d = 0; d < 5; ++d) {
      total[d].add(tile.sum[d].value());
      if (magnitude != nullptr) (*magnitude)[d] += tile.size[d];
    }
  }
}

GasGrid::GasGrid(GasGridSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
GasGrid::~GasGrid() = default;
GasGrid::GasGrid(GasGrid&&) noexcept = default;
GasGrid& GasGrid::operator=(GasGrid&&) noexcept = default;

void GasGrid::set_state(std::function<GasPoint(Vec3 const& x)> const& state, int points) {
  auto const gauss = gauss_points(points);
  Impl const& m = *impl_;
  auto const loops = [&](std::size_t a) { return a < static_cast<std::size_t>(m.context.dims) ? points : 1; };
  set_averages([&](Vec3 const& centre, Vec3 const& h) {
    FiveDensities sum{};
    for (int c = 0; c < loops(2); ++c) {
      for (int b = 0; b < loops(1); ++b) {
        for (int a = 0; a < loops(0); ++a) {
          std::array<int, 3> const at{a, b, c};
          Vec3 x = centre;
          double weight = 1;
          for (std::size_t d = 0; d < static_cast<std::size_t>(m.context.dims); ++d) {
            GaussPoint const& g = gauss[static_cast<std::size_t>(at[d])];
            x[d] += 0.5 * h[d] * g.x, weight *= 0.5 * g.weight;
          }
          FiveDensities const q = m.conserved(state(x));
          for (std::size_t d = 0; d < 5; ++d) sum[d] += weight * q[d];
        }
      }
    }
    return GasDensities{sum[0], {sum[1], sum[2], sum[3]}, sum[4]};
  });
}

void GasGrid::set_averages(std::function<GasDensities(Vec3 const& centre, Vec3 const& widths)> const& mean,
                           double time) {
  set_cells([&](Int3 const& cell) { return mean(impl_->centre(cell), impl_->context.h); }, time);
}

void GasGrid::set_cells(std::function<GasDensities(Int3 const& cell)> const& mean, double time) {
  impl_->set(
      [&](Int3 const& cell) -> FiveDensities {
        GasDensities const q = mean(cell);
        return {q.mass, q.momentum[0], q.momentum[1], impl_->context.dims == 3 ? q.momentum[2] : 0.0, q.energy};
      },
      time);
}

void GasGrid::replace(std::span<Int3 const> cells, std::span<GasDensities const> averages) {
  Impl& m = *impl_;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    GasTile& t = m.tiles[static_cast<std::size_t>(m.tiling.at(cells[n]))];
    GasDensities const& a = averages[n];
    FiveDensities const q{a.mass, a.momentum[0], a.momentum[1], m.context.dims == 3 ? a.momentum[2] : 0.0, a.energy};
    if (t.uniform && q == t.state) continue;
    t.store_state(m.context.dims);
    t.uniform = false;
    std::ptrdiff_t const at =
        t.index(cells[n][0] - t.box.first[0], cells[n][1] - t.box.first[1], cells[n][2] - t.box.first[2]);
    for (std::size_t d = 0; d < 5; ++d) {
      if (m.context.dims == 2 && d == 3) continue;
      t.now[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * t.field + at)] = q[d];
    }
    t.rate = std::max(t.rate, m.signal_rate(q));
    m.rate = std::max(m.rate, t.rate);
  }
}

GridStepReport GasGrid::step(double t_end) { return impl_->step(t_end); }
int GasGrid::dimensions() const noexcept { return impl_->context.dims; }
Int3 GasGrid::cells() const noexcept { return impl_->setup.cells; }
std::size_t GasGrid::cell_count() const noexcept {
  std::size_t n = 0;
  for (GasTile const& t : impl_->tiles) n += t.cells();
  return n;
}
Vec3 GasGrid::widths() const noexcept { return impl_->context.h; }
Vec3 GasGrid::centre(Int3 const& cell) const noexcept { return impl_->centre(cell); }
double GasGrid::time() const noexcept { return impl_->context.time; }
double GasGrid::stable_dt() const noexcept { return impl_->setup.options.cfl / impl_->rate; }
GasGridMemory GasGrid::memory() const noexcept { return {impl_->rate, impl_->largest_density}; }
void GasGrid::set_memory(GasGridMemory const& memory) noexcept {
  impl_->rate = memory.signal_rate, impl_->largest_density = memory.largest_density;
}
bool GasGrid::solid(Int3 const& cell) const noexcept { return impl_->tiling.at(cell) < 0; }

GasDensities GasGrid::average(Int3 const& cell) const noexcept {
  TileId const id = impl_->tiling.at(cell);
  if (id < 0) return {};
  GasTile const& t = impl_->tiles[static_cast<std::size_t>(id)];
  FiveDensities const q =
      impl_->densities(t, t.index(cell[0] - t.box.first[0], cell[1] - t.box.first[1], cell[2] - t.box.first[2]));
  return {q[0], {q[1], q[2], q[3]}, q[4]};
}

GasPoint GasGrid::primitive(Int3 const& cell) const noexcept {
  GasDensities const q = average(cell);
  if (!(q.mass > 0)) return {};
  return impl_->primitive({q.mass, q.momentum[0], q.momentum[1], q.momentum[2], q.energy});
}

std::vector<double> GasGrid::field(Field which) const {
  Int3 const n = cells();
  std::vector<double> out(cells_in(n));
#pragma omp parallel for num_threads(impl_->setup.options.threads) schedule(dynamic, 1)
  for (std::size_t id = 0; id < impl_->tiles.size(); ++id) {
    GasTile const& t = impl_->tiles[id];
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          std::size_t const to = cell_number(n, {t.box.first[0] + i, t.box.first[1] + j, t.box.first[2] + k});
          if (which >= Field::switched) {
            std::size_t const map = static_cast<std::size_t>(which) - static_cast<std::size_t>(Field::switched);
            std::size_t const at = static_cast<std::size_t>(i + t.box.size[0] * (j + t.box.size[1] * k));
            out[to] = t.maps.empty() ? 0.0 : static_cast<double>(t.maps[map * t.cells() + at]);
            continue;
          }
          GasPoint const s = impl_->primitive(impl_->densities(t, t.index(i, j, k)));
          switch (which) {
            case Field::density:
              out[to] = s.rho;
              break;
            case Field::velocity_x:
              out[to] = s.u[0];
              break;
            case Field::velocity_y:
              out[to] = s.u[1];
              break;
            case Field::velocity_z:
              out[to] = s.u[2];
              break;
            case Field::pressure:
              out[to] = s.p;
              break;
            default:
              out[to] = impl_->bulk_modulus(s);
          }
        }
      }
    }
  }
  return out;
}

GridCounters const& GasGrid::counters() const noexcept { return impl_->counters; }

GridLedger GasGrid::ledger() const {
  std::array<Accumulator, 5> total{};
  FiveDensities magnitude{};
  Impl const& m = *impl_;
  m.add_totals(total, &magnitude);
  auto const entry = [&](std::size_t d) {
    return LedgerEntry{.initial = m.initial[d].value(),
                       .current = total[d].value(),
                       .through_boundary = m.boundary[d].value(),
                       .from_source = m.source[d].value(),
                       .from_floor = m.floor[d].value(),
                       .scale = std::max(m.scale[d], magnitude[d])};
  };
  return {.mass = entry(0), .energy = entry(4), .momentum = {entry(1), entry(2), entry(3)}};
}

GasGridSetup const& GasGrid::setup() const noexcept { return impl_->setup; }

std::size_t GasGrid::bytes() const noexcept {
  std::size_t sum = 0;
  for (GasTile const& t : impl_->tiles) {
    sum += (t.now.size() + t.next.size()) * sizeof(double) + t.maps.size() * sizeof(float) + t.redo.size() +
           sizeof(GasTile);
  }
  for (auto const& work : impl_->works) sum += work->bytes();
  return sum;
}

std::size_t GasGrid::cells_stored() const noexcept {
  std::size_t sum = 0;
  for (GasTile const& t : impl_->tiles) sum += t.stored() ? t.cells() : 0;
  return sum;
}

std::size_t GasGrid::tile_count() const noexcept { return impl_->tiles.size(); }

}  // namespace g27
