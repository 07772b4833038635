#include "fsi/overset/overset_solver.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

#include "fsi/overset/asleep.hpp"
#include "fsi/overset/clouds.hpp"
#include "fsi/overset/fast_cores.hpp"
#include "fsi/overset/fill.hpp"
#include "fsi/overset/rigid_step.hpp"
#include "fsi/overset/thin_gaps.hpp"
#include "fsi/overset/thin_rims.hpp"
#include "fsi/overset/turned_cores.hpp"
#include "fsi/overset/untangle.hpp"

namespace g27 {

namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

struct OversetSolver::Impl {
  OversetSetup setup;
  std::function<GasPoint(Vec3 const&)> initial;
  GasGrid gas;
  std::vector<std::unique_ptr<Body>> bodies;
  std::vector<std::vector<ModelProblems>> problems;  ///< [body][thread]
  std::vector<std::vector<ModelResult>> results;     ///< [body][triangle]
  std::vector<std::vector<CoreSlopes>> slopes;       ///< [body][triangle]
  std::vector<std::vector<TrianglePlace>> places;    ///< [body][triangle]: at the start of the step
  std::vector<BodyMomentum> momenta;
  std::vector<char> sleeping;  ///< [body]: nothing has reached it; it never falls asleep again
  OversetCounters counters;
  double time = 0, last_dt = 0, stable = 0;  ///< of the next step at most
  int threads;

  Impl(OversetSetup s, std::function<GasPoint(Vec3 const&)> start)
      : setup(std::move(s)),
        initial(std::move(start)),
        gas(setup.gas),
        time(setup.start),
        threads(std::max(1, setup.gas.options.threads)) {
    if (setup.gas_cells) {
      gas.set_cells(setup.gas_cells, setup.start);
    } else {
      gas.set_averages([&](Vec3 const& x, Vec3 const&) { return densities_of(setup.gas.eos, gas_at(x)); }, setup.start);
    }
    make_bodies();
    begin();
    for (auto const& b : bodies) momenta.push_back(momentum_of(*b));
    initial = {}, setup.gas_cells = {};  // of the start alone
  }

  Impl(OversetSetup s, OversetState const& from)
      : setup(std::move(s)), gas(setup.gas), threads(std::max(1, setup.gas.options.threads)) {
    restore_gas(from, gas);
    make_bodies();
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      momenta.push_back(restore_body(from, n, *bodies[n]));
      results[n].resize(bodies[n]->triangles.size());
    }
    OversetClock const clock = clock_of(from);
    time = clock.time, last_dt = clock.last_dt, counters = clock.counters;
    for (std::size_t n = 0; n < bodies.size(); ++n) sleeping[n] = from.at("sleeping").at(n) != 0 ? 1 : 0;
    classify();
    for (auto const& b : bodies) b->gas.update(threads), b->solid.update(threads);
    set_clouds();
    stable = find_stable_dt();
  }

  [[nodiscard]] OversetState state() const {
    OversetState out;
    save_gas(gas, out);
    for (std::size_t n = 0; n < bodies.size(); ++n) save_body(*bodies[n], momenta[n], n, out);
    save_clock({time, last_dt, counters}, out);
    out.arrays["sleeping"].assign(sleeping.begin(), sleeping.end());
    return out;
  }

  void make_bodies() {
    if (setup.cfl <= 0) {
      bool const yields =
          std::any_of(setup.bodies.begin(), setup.bodies.end(), [](auto const& b) { return b.material.plastic(); });
      setup.cfl = yields ? 0.7 : 0.8;
    }
    if (setup.solid_options.cfl <= 0) setup.solid_options.cfl = setup.cfl;
    for (BodySetup const& b : setup.bodies) {
      bodies.push_back(std::make_unique<Body>(b, gas, setup.solid_options, setup.literal));
      std::vector<ModelProblems> each;
      for (int k = 0; k < threads; ++k) {
        if (b.rigid) {
          each.emplace_back(setup.gas.eos, gas.widths()[0], setup.local);
        } else {
          each.emplace_back(setup.gas.eos, b.material, gas.widths()[0], b.cell, setup.local);
        }
      }
      problems.push_back(std::move(each));
      results.emplace_back(), slopes.emplace_back(), places.emplace_back();
    }
    sleeping.assign(bodies.size(), setup.skip ? 1 : 0);
  }

  [[nodiscard]] GasFields gas_at(Vec3 const& x) const {
    GasPoint const s = initial(x);
    return {s.rho, s.u[0], s.u[1], s.u[2], s.p};
  }
  [[nodiscard]] static SolidFields solid_at(Body const& b, Vec3 const& x) {
    SolidPoint const s = b.setup.initial(x);
    SolidFields q{s.rho, s.u[0], s.u[1], s.u[2], s.p};
    q[solid_field_of::e] = std::visit([&](auto const& eos) { return eos.energy(s.rho, s.p); }, b.setup.material.eos);
    for (std::size_t c = 0; c < 6; ++c) q[solid_field_of::S + c] = s.S[c];
    q[solid_field_of::ep] = s.ep;
    return q;
  }

  void classify() {
    std::vector<TriangleSurface const*> all;
    for (auto const& b : bodies) all.push_back(&b->surface);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < 2 * bodies.size(); ++n) {
      Body& b = *bodies[n / 2];
      TriangleSurface const* const own = &b.surface;
      if (n % 2 == 0) {
        b.gas.kinds.classify(all);
      } else if (!b.rigid) {
        b.solid.kinds.classify(std::span(&own, 1));
      }
    }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) compute_deep_cells(*bodies[n]);
  }

  /// The grid of a body computes what its scheme updates: the rest of its window, where there is no body, costs
  /// nothing.
  static void compute_deep_cells(Body& b) {
    std::vector<Int3> deep;
    CellKinds const& kinds = b.solid.kinds;
    kinds.for_each_near(0, [&](std::size_t i) {
      if (kinds.kind(i) == CellKind::deep && !kinds.is_image(i)) deep.push_back(kinds.in_grid(kinds.cell(i)));
    });
    b.grid.compute_only(deep);
  }

  void begin() {
    classify();
    for (auto const& b : bodies) {
      double const h = b->setup.cell, h_gas = gas.widths()[0];
      for (TriangleState& t : b->triangles) {
        Mirrors const &walls = b->gas.kinds.box().mirrors, &cuts = b->cut.mirrors;
        for (std::size_t k = 0; k < core_layers; ++k) {
          Vec3 const x = core_centre(t, k, h_gas), y = core_centre(t, k, -h);
          t.gas[k] = reflected(gas_at(walls.within(x)), walls.image_at(x));
          t.solid[k] = reflected(solid_at(*b, cuts.within(y)), cuts.image_at(y), cuts.clamps);
        }
        t.velocity = velocity_of(solid_at(*b, t.centre)), t.pressure = t.gas[0][gas_field::p];
      }
      Vec3 const middle = 0.5 * (b->setup.lower + b->setup.upper);
      b->background = solid_at(*b, middle);
      b->ambient = gas_at(middle);
      b->grid.set_averages(
          [&](Vec3 const& x, Vec3 const&) {
            std::size_t const i = static_cast<std::size_t>(b->solid.kinds.index(b->solid.kinds.cell_of(x)));
            return densities_of(b->solid.kinds.valid(i) ? solid_at(*b, x) : b->background);
          },
          setup.start);
    }
    read_states(true), set_clouds(), write_back(true), set_rates(true);
    stable = find_stable_dt();
  }

  /// Calls f with the number of every body: side by side, or where there are fewer bodies than threads one after the
  /// other, since loops within a body have the threads then. Those of a loop within another start anew each time, even
  /// where the outer one has a single thread: an octant with one cube took 9.1 s instead of 4.1.
  template <class F>
  void for_each_body(F const& f) const {
    if (bodies.size() < static_cast<std::size_t>(threads)) {
      for (std::size_t n = 0; n < bodies.size(); ++n) f(n);
      return;
    }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) f(n);
  }

  void set_rates(bool all) {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      if (all || sleeping[n] == 0) set_rate(*bodies[n]);
    }
  }

  /// The time step of a body's grid goes by the cells of the body, not by what is around them in the tiles.
  static void set_rate(Body& b) {
    double rate = 0;
    CellKinds const& kinds = b.solid.kinds;
    kinds.for_each_near(0, [&](std::size_t i) {
      if (!kinds.valid(i) || kinds.is_image(i)) return;
      double const own = b.grid.signal_rate_of(densities_of(b.solid.states[i]));
      if (!(own <= rate)) rate = own;  // NaN as well
    });
    if (rate > 0) b.grid.set_signal_rate(rate);
  }

  /// States of the cells that the grids' own schemes have updated; at the start of all.
  void read_states(bool all) {
    for_each_body([&](std::size_t at) {
      auto const& b = bodies[at];
      auto const read = [&](auto& region, int around, auto const& state) {
        std::vector<std::size_t> cells;
        region.kinds.for_each_near(around, [&](std::size_t i) {
          bool const own = all || region.kinds.kind_before(i) == CellKind::deep;
          if (own && region.kinds.valid(i) && !region.kinds.is_image(i)) cells.push_back(i);
        });
#pragma omp parallel for num_threads(threads) schedule(static)
        for (std::size_t n = 0; n < cells.size(); ++n)
          region.states[cells[n]] = state(region.kinds.in_grid(region.kinds.cell(cells[n])));
        region.update(threads);
      };
      // of gas all that is in the window: probes look there
      int const everywhere = *std::max_element(b->gas.kinds.box().size.begin(), b->gas.kinds.box().size.end());
      read(b->gas, everywhere, [&](Int3 const& c) { return fields_of(setup.gas.eos, gas.average(c)); });
      read(b->solid, 0, [&](Int3 const& c) { return fields_of(b->setup.material.eos, b->grid.average(c)); });
    });
  }

  void set_clouds() {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < 2 * bodies.size(); ++n) {
      if (n % 2 == 0) {
        set_gas_cloud(*bodies[n / 2], bodies);
      } else {
        set_solid_cloud(*bodies[n / 2]);
      }
    }
  }

  void set_solid_clouds() {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) set_solid_cloud(*bodies[n]);
  }

  /// Cells that the schemes have not updated: those of the medium from its donors, those around it continued, the rest
  /// at rest. `started`: every valid cell has its state already.
  void write_back(bool started) {
    std::vector<std::vector<Int3>> gas_cells(bodies.size());
    std::vector<std::vector<GasDensities>> gas_averages(bodies.size());
    for_each_body([&](std::size_t n) {
      auto const& b = bodies[n];
      FilledCells<GasFields> gas_filled = fill(
          b->gas, started, b->ambient, 0, [](Int3 const&) { return true; }, threads);
      gas_cells[n] = std::move(gas_filled.cells);
      for (GasFields const& q : gas_filled.states) gas_averages[n].push_back(densities_of(setup.gas.eos, q));
      if (!started && sleeping[n] != 0) return;
      Vec3 mean{0, 0, 0};
      for (TriangleState const& t : b->triangles)
        mean = mean + (1.0 / static_cast<double>(b->triangles.size())) * t.velocity;
      for (std::size_t a = 0; a < 3; ++a)
        b->background[solid_field_of::u + a] = b->cut.mirrors.across(a) ? 0.0 : mean[a];
      Int3 const& tile = b->grid.setup().options.tile;
      FilledCells<SolidFields> const filled = fill(
          b->solid, started, b->background, *std::max_element(tile.begin(), tile.end()),
          [&](Int3 const& c) { return b->grid.computes(c); }, threads);
      std::vector<SolidDensities> solid_averages;
      for (SolidFields const& q : filled.states) solid_averages.push_back(densities_of(q));
      b->grid.replace(filled.cells, solid_averages);
    });
    // one after the other: their windows overlap
    for (std::size_t n = 0; n < bodies.size(); ++n) gas.replace(gas_cells[n], gas_averages[n]);
  }

  void close() {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      Body& b = *bodies[n];
      close_content(b, momenta[n]);
      std::vector<Int3> cells;
      std::vector<SolidDensities> averages;
      CellKinds const& kinds = b.solid.kinds;
      kinds.for_each_near(0, [&](std::size_t i) {
        if (!kinds.valid(i) || kinds.is_image(i)) return;
        cells.push_back(kinds.in_grid(kinds.cell(i))), averages.push_back(densities_of(b.solid.states[i]));
      });
      b.grid.replace(cells, averages);
      b.solid.update(1);
    }
    set_solid_clouds();
  }

  [[nodiscard]] double find_stable_dt() const {
    double dt = gas.stable_dt();
    double const h_gas = gas.widths()[0];
    for (auto const& b : bodies) {
      if (!b->rigid) dt = std::min(dt, b->grid.stable_dt());
      double rate = 0, solid_rate = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : rate, solid_rate)
      for (std::size_t n = 0; n < b->triangles.size(); ++n) {
        TriangleState const& t = b->triangles[n];
        rate = std::max(rate, signal_rate(setup.gas.eos, t, t.gas[0], h_gas));
        if (b->rigid) continue;
        SolidFields const& s = t.solid[0];
        double const M = p_wave_modulus(b->setup.material, s);
        solid_rate = std::max(solid_rate, 3 * std::sqrt(M / s[0]) / b->setup.cell);
      }
      dt = std::min({dt, setup.cfl / rate, setup.solid_options.cfl / solid_rate});
    }
    return dt;
  }

  void solve_problems(double dt) {
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      Body& b = *bodies[n];
      if (sleeping[n] != 0) {
        counters.skipped += b.triangles.size();
        continue;
      }
      places[n] = places_of(b);
      if (b.rigid) start_rigid_step(b, setup.gas.eos, time, dt);
      std::size_t const count = b.triangles.size(), batches = (count + ModelProblems::lanes - 1) / ModelProblems::lanes;
      std::vector<std::size_t> const order = b.neighbours_in_turn();
      std::vector<std::array<Vec3, 2>> gradient(count);
      results[n].resize(count), slopes[n].resize(count);
#pragma omp parallel num_threads(threads)
      {
        Body::Nearby nearby(b);
#pragma omp for schedule(dynamic, 4)
        for (std::size_t batch = 0; batch < batches; ++batch) {
          std::size_t const first = batch * ModelProblems::lanes, size = std::min(ModelProblems::lanes, count - first);
          std::array<ModelStencil, ModelProblems::lanes> stencils;
          std::array<ModelResult, ModelProblems::lanes> found;
          for (std::size_t k = 0; k < size; ++k) {
            std::size_t const t = order[first + k];
            stencils[k] = b.stencil(t, nearby);
            gradient[t] = b.velocity_gradient(t, stencils[k]);
            slopes[n][t] = core_slopes(b.triangles[t].frame, stencils[k]);
          }
          problems[n][static_cast<std::size_t>(omp_get_thread_num())].solve(std::span(stencils).first(size), dt,
                                                                            std::span(found).first(size));
          for (std::size_t k = 0; k < size; ++k) results[n][order[first + k]] = found[k];
        }
      }
      for (std::size_t t = 0; t < count; ++t) b.triangles[t].gradient = gradient[t];
      counters.problems += count;
    }
  }

  GridStepReport step(double t_end) {
    double dt = stable;
    dt = last_dt > 0 ? std::min(dt, setup.growth * last_dt) : setup.first * dt;
    last_dt = dt;
    if (time + dt > t_end - 1e-10 * dt) dt = t_end - time;
    GridStepReport report{.status = StepStatus::ok, .cell = {}, .dt = dt};
    if (!(dt > 0)) return {StepStatus::time_step_vanished, {}, dt};
    double const began = seconds();
    for (std::size_t n = 0; n < bodies.size(); ++n) sleeping[n] = sleeping[n] != 0 && asleep(*bodies[n]) ? 1 : 0;
    solve_problems(dt);
    double const solved = seconds();
    while (gas.time() < time + dt) {
      GridStepReport const r = gas.step(time + dt);
      if (r.status != StepStatus::ok) return r;
    }
    double const gas_done = seconds();
    std::vector<GridStepReport> of_solids(bodies.size(), report);
    for_each_body([&](std::size_t n) {
      SolidGrid& grid = bodies[n]->grid;
      if (sleeping[n] != 0 || bodies[n]->rigid) grid.rest(time + dt);
      while (grid.time() < time + dt && of_solids[n].status == StepStatus::ok) of_solids[n] = grid.step(time + dt);
    });
    for (GridStepReport const& r : of_solids) {
      if (r.status != StepStatus::ok) return r;
    }
    double const solid_done = seconds();
    std::exception_ptr trouble;  // a surface that cannot be meshed anew
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      try {
        if (sleeping[n] != 0) {
          add_impulse(*bodies[n], dt, momenta[n]);
        } else {
          accept(n, dt);
        }
      } catch (...) {
#pragma omp critical(overset_trouble)
        trouble = std::current_exception();
      }
    }
    if (trouble) std::rethrow_exception(trouble);
    classify();
    double const placed = seconds();
    std::uint64_t renewed = 0;
    double const fastest = setup.gas.options.cfl / gas.stable_dt();
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) reduction(+ : renewed)
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      if (sleeping[n] != 0) continue;
      tie_thin_gaps(*bodies[n], dt);
      renewed += renew_fast_cores(*bodies[n], fastest);
    }
    counters.renewed += renewed;
    read_states(false), set_clouds();
    int tied = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) reduction(+ : tied)
    for (std::size_t n = 0; n < bodies.size(); ++n) tied += tie_thin_rims(*bodies[n], dt) ? 1 : 0;
    if (tied > 0) set_solid_clouds();
    write_back(false);
    if (setup.closure) close();
    set_rates(false);
    stable = find_stable_dt();
    double const done = seconds();
    counters.seconds_local += solved - began, counters.seconds_gas += gas_done - solved;
    counters.seconds_solid += solid_done - gas_done, counters.seconds_geometry += placed - solid_done;
    counters.seconds_fill += done - placed;
    time += dt, counters.steps += 1;
    return report;
  }

  void accept(std::size_t number, double dt) {
    Body& b = *bodies[number];
    BodyMomentum& held = momenta[number];
    std::uint64_t first_order = 0, failed = 0;
    for (std::size_t n = 0; n < b.triangles.size(); ++n) {
      TriangleState& t = b.triangles[n];
      ModelResult const& r = results[number][n];
      t.pressure = r.pressure, t.velocity = t.frame.out_of(r.velocity);
      for (std::size_t k = 0; k < core_layers; ++k) {
        t.gas[k] = out_of_frame(t.frame, r.gas[k]), t.solid[k] = out_of_frame(t.frame, r.solid[k]);
      }
      first_order += r.first_order ? 1 : 0, failed += r.failed ? 1 : 0;
    }
    LocalRemeshCounts changes;
    Untangled untangled;
    if (b.rigid) {
      finish_rigid_step(b, time, dt, held);
      turn_cores(b, places[number], slopes[number], dt);
    } else {
      add_impulse(b, dt, held);
      b.move_vertices(dt, held.growth);
      for (Vec3 const& x : b.surface.vertices) {
        if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2])) continue;
        throw std::runtime_error("the surface of body " + std::to_string(number + 1) + " has broken down in step " +
                                 std::to_string(counters.steps + 1) +
                                 ": its grid may be too coarse, or its time step too long");
      }
      b.place_triangles();
      turn_cores(b, places[number], slopes[number], dt);
      changes = remesh(b, setup.remeshing);
      if (setup.remeshing.on) untangled = untangle(b.surface, b.cut);
      if (untangled.moved > 0) b.place_triangles();
    }
#pragma omp critical(overset_counters)
    {
      counters.first_order += first_order, counters.failed += failed, counters.remeshing.add(changes);
      counters.untangled += untangled.moved, counters.tangled += untangled.clear ? 0 : 1;
    }
  }
};

OversetSolver::OversetSolver(OversetSetup setup, std::function<GasPoint(Vec3 const&)> initial)
    : impl_(std::make_unique<Impl>(std::move(setup), std::move(initial))) {}
OversetSolver::OversetSolver(OversetSetup setup, OversetState const& from)
    : impl_(std::make_unique<Impl>(std::move(setup), from)) {}
OversetSolver::~OversetSolver() = default;
OversetState OversetSolver::state() const { return impl_->state(); }
double OversetSolver::stable_dt() const { return impl_->stable; }
GridStepReport OversetSolver::step(double t_end) { return impl_->step(t_end); }
double OversetSolver::time() const noexcept { return impl_->time; }
GasGrid const& OversetSolver::gas() const noexcept { return impl_->gas; }
std::vector<std::unique_ptr<Body>> const& OversetSolver::bodies() const noexcept { return impl_->bodies; }
OversetCounters const& OversetSolver::counters() const noexcept { return impl_->counters; }
std::vector<BodyMomentum> const& OversetSolver::momenta() const noexcept { return impl_->momenta; }

}  // namespace g27
