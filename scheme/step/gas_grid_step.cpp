/// Control of a step of a gas grid: which tiles, how long, and what is done when a state is lost.
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "scheme/step/gas_grid_impl.hpp"

namespace g27 {

namespace {

constexpr int most_retries = 12;
constexpr double vacuum_pressure = 1e-12, vacuum_density = 1e-13;  ///< floors, over rho u^2 and the largest density

}  // namespace

bool GasGrid::Impl::stays(TileId id) const {
  GasTile const& t = tiles[static_cast<std::size_t>(id)];
  if (!t.uniform) return false;
  // the front may reach it in this step
  if (context.time < t.last_lit && context.time + setup.options.cfl / rate > t.first_lit) return false;
  using Kind = GridBoundary::Kind;
  for (int a = 0; a < 3; ++a) {
    std::size_t const s = static_cast<std::size_t>(a);
    if (!context.swept[s]) continue;
    for (int d : {-1, 1}) {
      Int3 direction{0, 0, 0};
      direction[s] = d;
      if (tiling.beside(id, direction) >= 0) continue;
      bool const at_rest = t.state[1 + s] == 0.0;
      if (!tiling.at_side(id, a, d)) {
        if (!at_rest) return false;  // a block's wall
        continue;
      }
      Side const side = static_cast<Side>(2 * a + (d < 0 ? 0 : 1));
      auto const still = [&](GridBoundary const& b) {
        return b.kind == Kind::outflow || (b.kind == Kind::wall && at_rest);
      };
      bool all = still(setup.sides[static_cast<std::size_t>(side)]);
      for (BoundaryPatch const& p : setup.patches) {
        bool touches = p.side == side;
        for (std::size_t b = 0; b < 3; ++b) {
          // ghosts reach a few cells beyond the tile
          double const from = context.lower[b] + (t.box.first[b] - context.halo) * context.h[b];
          double const to = context.lower[b] + (t.box.first[b] + t.box.size[b] + context.halo) * context.h[b];
          touches = touches && (b == s || !context.swept[b] || (to >= p.lower[b] && from < p.upper[b]));
        }
        all = all && (!touches || still(p.condition));
      }
      if (!all) return false;
    }
  }
  for (TileNeighbour const& n : tiling.neighbours(id)) {
    GasTile const& o = tiles[static_cast<std::size_t>(n.id)];
    if (!o.uniform || o.state != t.state) return false;
  }
  return true;
}

std::vector<TileId> GasGrid::Impl::active() const {
  std::vector<TileId> ids;
  bool const skip = setup.options.skip && !setup.source.mean;
  for (TileId id = 0; id < tiling.count(); ++id) {
    if (!skip || !stays(id)) ids.push_back(id);
  }
  return ids;
}

void GasGrid::Impl::run(std::vector<TileId> const& ids) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(ids.size());
  std::size_t cells = 0;
  for (TileId id : ids) cells += tiles[static_cast<std::size_t>(id)].cells();
  std::size_t const worth = cells / static_cast<std::size_t>(std::max(1, setup.options.cells_per_thread));
  int const threads = static_cast<int>(std::min({static_cast<std::size_t>(setup.options.threads), ids.size(), worth}));
  if (threads <= 1) {
    for (TileId id : ids) works[0]->step(id);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    works[static_cast<std::size_t>(omp_get_thread_num())]->step(ids[static_cast<std::size_t>(k)]);
  }
}

bool GasGrid::Impl::fresh(GasTile const& t, std::ptrdiff_t i) const {
  int const row = static_cast<int>(i / t.row), at = static_cast<int>(i % t.row);
  Int3 const cell{t.box.first[0] + at, t.box.first[1] + row % t.box.size[1], t.box.first[2] + row / t.box.size[1]};
  return setup.burn.unburnt(setup.burn.lighting(centre(cell)), context.time, context.width()) > 0;
}

bool GasGrid::Impl::bad(GasTile const& t, std::ptrdiff_t i, double share) const {
  FiveDensities q{};
  for (std::size_t d = 0; d < 5; ++d) {
    if (context.dims == 2 && d == 3) continue;
    q[d] = t.next[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * t.field + i)];
    if (!std::isfinite(q[d])) return true;
  }
  FiveDensities const old = densities(t, i);
  if (!(q[0] > share * old[0]) || !(q[0] > 0)) return true;
  // unburnt explosive at rest has no pressure margin: it lies below the products' isentropes
  if (context.time < t.last_lit && fresh(t, i)) return !(bulk_modulus(primitive(q)) > 0);
  return !(margin(primitive(q)) > share * margin(primitive(old)));
}

void GasGrid::Impl::repair(std::vector<TileId> const& ids) {
  for (bool again = true; again;) {
    again = false;
    std::vector<TileId> redo;
    for (TileId id : ids) {
      GasTile& t = tiles[static_cast<std::size_t>(id)];
      if (t.worst > grid_repair_share) continue;
      bool marked = false;
      for (int k = 0; k < t.box.size[2]; ++k) {
        for (int j = 0; j < t.box.size[1]; ++j) {
          for (int i = 0; i < t.box.size[0]; ++i) {
            if (!bad(t, t.index(i, j, k), grid_repair_share)) continue;
            if (t.redo.empty()) t.redo.assign(t.cells(), 0);
            unsigned char& flag = t.redo[static_cast<std::size_t>(i + t.box.size[0] * (j + t.box.size[1] * k))];
            marked = marked || flag == 0;
            flag = 1;
          }
        }
      }
      if (!marked) continue;
      again = true;
      redo.push_back(id);
      for (TileNeighbour const& n : tiling.neighbours(id)) redo.push_back(n.id);
    }
    std::sort(redo.begin(), redo.end());
    redo.erase(std::unique(redo.begin(), redo.end()), redo.end());
    std::erase_if(redo, [&](TileId id) { return !std::binary_search(ids.begin(), ids.end(), id); });
    run(redo);
  }
}

bool GasGrid::Impl::floor_vacuum(std::vector<TileId> const& ids, Int3& cell) {
  bool sound = true;
  double const v = volume();
  for (TileId id : ids) {
    GasTile& t = tiles[static_cast<std::size_t>(id)];
    if (t.worst > 0) continue;
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          std::ptrdiff_t const at = t.index(i, j, k);
          if (!bad(t, at, 0.0)) continue;
          auto const next = [&](std::size_t d) -> double& {
            return t.next[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * t.field + at)];
          };
          FiveDensities before{};
          bool finite = true;
          for (std::size_t d = 0; d < 5; ++d) {
            if (context.dims == 2 && d == 3) continue;
            before[d] = next(d), finite = finite && std::isfinite(before[d]);
          }
          FiveDensities after = before;
          if (finite) {
            GasPoint s{std::max(before[0], vacuum_density * largest_density), {}, primitive(densities(t, at)).p};
            double speed2 = 0;
            for (std::size_t a = 0; a < 3; ++a) {
              s.u[a] = before[0] > 0 ? before[1 + a] / s.rho : 0.0;
              speed2 += s.u[a] * s.u[a];
            }
            double const wanted = std::max(vacuum_pressure * s.rho * speed2, 1e-300);
            for (int m = 0; m < 3; ++m) s.p += wanted - margin(s);
            after = conserved(s);
            for (std::size_t d = 0; d < 5; ++d) {
              if (context.dims == 2 && d == 3) continue;
              next(d) = after[d];
              floor[d].add(v * (after[d] - before[d]));
            }
            counters.floored += 1;
          }
          if (!finite || bad(t, at, 0.0)) {
            cell = {t.box.first[0] + i, t.box.first[1] + j, t.box.first[2] + k};
            sound = false;
          } else {
            t.rate = std::max(t.rate, signal_rate(after));
          }
        }
      }
    }
  }
  return sound;
}

bool GasGrid::Impl::try_step(double dt, std::vector<TileId> const& ids, double& new_rate, Int3& cell) {
  context.dt = dt;
  run(ids);
  auto const worst = [&] {
    double least = 1;
    for (TileId id : ids) least = std::min(least, tiles[static_cast<std::size_t>(id)].worst);
    return least;
  };
  bool sound = true;
  if (!(worst() > grid_repair_share)) {
    if (setup.options.repair) repair(ids);
    if (!(worst() > 0)) sound = floor_vacuum(ids, cell);
  }
  new_rate = 0;
  for (GasTile const& t : tiles) {
    if (!(t.rate <= new_rate)) new_rate = t.rate;
    if (t.failures > 0) sound = false, cell = t.box.first;
  }
  return sound && std::isfinite(new_rate);
}

GridStepReport GasGrid::Impl::step(double t_end) {
  std::vector<TileId> const ids = active();
  double const left = t_end - context.time;
  double shrink = 1.0;
  GridStepReport report;
  for (int attempt = 0; attempt <= most_retries; ++attempt, shrink *= 0.5) {
    GridCounters const counters_before = counters;
    auto const floor_before = floor;
    double dt = std::min(shrink * setup.options.cfl / rate, left);
    if (context.time + dt > t_end - 1e-10 * dt) dt = left;
    report.dt = dt;
    if (!(dt > 0) || !(context.time + dt > context.time)) return {StepStatus::time_step_vanished, {}, dt};
    std::vector<double> rates;
    for (GasTile const& t : tiles) rates.push_back(t.rate);
    double new_rate = 0;
    bool const sound = try_step(dt, ids, new_rate, report.cell);
    report.status = sound ? StepStatus::ok : StepStatus::inadmissible_state;
    // A step in which a shock forms may have been too long: behind it signals are faster than any were before.
    bool const last_try = attempt == most_retries;
    double const limit = std::max(1.0, 1.6 * setup.options.cfl);
    if (sound && (last_try || dt * new_rate <= limit)) {
      accept(dt, ids, new_rate);
      return report;
    }
    for (std::size_t k = 0; k < tiles.size(); ++k) tiles[k].rate = rates[k], tiles[k].redo.clear();
    std::uint64_t const retried = counters.retried + 1;
    counters = counters_before, counters.retried = retried;
    floor = floor_before;
  }
  return report;
}

void GasGrid::Impl::account_for_skipped(double dt, std::vector<TileId> const& ids) {
  for (TileId id = 0; id < tiling.count(); ++id) {
    if (std::binary_search(ids.begin(), ids.end(), id)) continue;
    GasTile const& t = tiles[static_cast<std::size_t>(id)];
    GasPoint const s = primitive(t.state);
    for (int a = 0; a < 3; ++a) {
      std::size_t const n = static_cast<std::size_t>(a);
      if (!context.swept[n]) continue;
      for (int d : {-1, 1}) {
        Int3 direction{0, 0, 0};
        direction[n] = d;
        if (tiling.beside(id, direction) >= 0) continue;
        double const area = volume() / context.h[n] * static_cast<double>(t.cells()) / t.box.size[n];
        double const swept_volume = -d * dt * area * s.u[n];
        for (std::size_t q = 0; q < 5; ++q) boundary[q].add(swept_volume * t.state[q]);
        boundary[1 + n].add(-d * dt * area * s.p), boundary[4].add(swept_volume * s.p);
      }
    }
  }
}

void GasGrid::Impl::accept(double dt, std::vector<TileId> const& ids, double new_rate) {
  if (ids.size() < tiles.size()) account_for_skipped(dt, ids);
  std::uint64_t computed = 0;
  for (TileId id : ids) {
    GasTile& t = tiles[static_cast<std::size_t>(id)];
    std::swap(t.now, t.next);
    if (t.uniform && t.differs) t.uniform = false;
    if (t.uniform && setup.options.skip) t.now = {}, t.next = {};
    t.redo.clear();
    computed += t.cells();
    counters.faces += static_cast<std::uint64_t>(t.faces);
    counters.switched += static_cast<std::uint64_t>(t.switched);
    counters.linear_star += static_cast<std::uint64_t>(t.faces - t.strong);
    counters.cured += static_cast<std::uint64_t>(t.cured);
    counters.repaired += static_cast<std::uint64_t>(t.redone);
    for (std::size_t d = 0; d < 5; ++d) boundary[d].add(t.through[d]), source[d].add(t.from_source[d]);
  }
  std::uint64_t all = 0;
  for (GasTile const& t : tiles) all += t.cells();
  counters.cell_updates += computed;
  counters.cells_skipped += all - computed;
  counters.steps += 1;
  context.time += dt;
  rate = new_rate;
}

}  // namespace g27
