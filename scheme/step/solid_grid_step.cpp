/// Control of a step of a solid grid: how long, and what is done when a state is lost.
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "scheme/step/solid_grid_impl.hpp"

namespace g27 {

namespace {

constexpr int most_retries = 12;

}  // namespace

void SolidGrid::Impl::run() {
  std::vector<TileId> active;
  std::size_t cells = 0;
  for (std::size_t id = 0; id < tiles.size(); ++id) {
    if (tiles[id].active) active.push_back(static_cast<TileId>(id)), cells += tiles[id].cells();
  }
  std::size_t const worth = cells / static_cast<std::size_t>(std::max(1, setup.options.cells_per_thread));
  int const threads =
      static_cast<int>(std::min({static_cast<std::size_t>(setup.options.threads), active.size(), worth}));
  if (threads <= 1) {
    for (TileId id : active) works[0]->step(id);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (std::size_t n = 0; n < active.size(); ++n) {
    works[static_cast<std::size_t>(omp_get_thread_num())]->step(active[n]);
  }
}

Int3 SolidGrid::Impl::first_bad_cell() const noexcept {
  for (SolidTile const& t : tiles) {
    if (t.least > least_density_share) continue;
    for (int k = 0; k < t.box.size[2]; ++k) {
      for (int j = 0; j < t.box.size[1]; ++j) {
        for (int i = 0; i < t.box.size[0]; ++i) {
          std::ptrdiff_t const at = t.index(i, j, k);
          SolidVector q{};
          bool sound = true;
          for (std::size_t d = 0; d < q.size(); ++d) {
            q[d] = t.next[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(d) * t.field + at)];
            sound = sound && std::isfinite(q[d]);
          }
          sound = sound && q[0] > least_density_share * t.densities(at)[0];
          Vec3 const M = sound ? moduli(primitive(q)) : Vec3{};
          for (double m : M) sound = sound && m > 0;
          if (!sound) return {t.box.first[0] + i, t.box.first[1] + j, t.box.first[2] + k};
        }
      }
    }
  }
  return {0, 0, 0};
}

GridStepReport SolidGrid::Impl::step(double t_end) {
  double const left = t_end - context.time;
  double shrink = 1.0;
  GridStepReport report;
  for (int attempt = 0; attempt <= most_retries; ++attempt, shrink *= 0.5) {
    double dt = std::min(shrink * setup.options.cfl / rate, left);
    if (context.time + dt > t_end - 1e-10 * dt) dt = left;
    report.dt = dt;
    if (!(dt > 0) || !(context.time + dt > context.time)) return {StepStatus::time_step_vanished, {}, dt};
    context.dt = dt;
    run();
    double least = 1, new_rate = 0;
    for (SolidTile const& t : tiles) {
      if (!t.active) continue;
      least = std::min(least, t.least);
      if (!(t.rate <= new_rate)) new_rate = t.rate;
    }
    bool const sound = least > least_density_share && std::isfinite(new_rate);
    report.status = sound ? StepStatus::ok : StepStatus::inadmissible_state;
    // a step in which a shock forms may have been too long
    double const limit = std::max(1.0, 1.6 * setup.options.cfl);
    if (sound && (attempt == most_retries || dt * new_rate <= limit)) {
      accept(dt, new_rate);
      return report;
    }
    if (!sound) report.cell = first_bad_cell();
    counters.retried += 1;
  }
  return report;
}

void SolidGrid::Impl::accept(double dt, double new_rate) {
  for (SolidTile& t : tiles) {
    if (!t.active) continue;
    std::swap(t.now, t.next);
    counters.cell_updates += t.cells();
    counters.faces += static_cast<std::uint64_t>(t.faces);
    counters.switched += static_cast<std::uint64_t>(t.switched);
    counters.tangent += static_cast<std::uint64_t>(t.tangents);
    counters.yielded += static_cast<std::uint64_t>(t.yielded);
    plastic_work.add(t.plastic_work);
    for (std::size_t d = 0; d < 5; ++d) boundary[d].add(t.through[d]), source[d].add(t.from_source[d]);
  }
  counters.steps += 1;
  context.time += dt;
  rate = new_rate;
}

}  // namespace g27
