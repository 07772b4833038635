#include <algorithm>
#include <cassert>
#include <cmath>

#include "scheme/step/gas_line_impl.hpp"

namespace g27 {

namespace {

constexpr int most_retries = 12;

}  // namespace

void GasLine::Impl::set_face_speeds(double dt) {
  using Kind = MeshMotion::Kind;
  std::ptrdiff_t const last = cells();
  switch (setup.motion.kind) {
    case Kind::fixed:
      return;
    case Kind::prescribed:
      for (std::ptrdiff_t f = 0; f <= last; ++f) {
        std::size_t const k = static_cast<std::size_t>(f);
        line.w[f] = (setup.motion.position(line.x_initial[k], time + dt) - line.x[k]) / dt;
      }
      break;
    case Kind::stretched: {
      double const w_l = end_speed(LineEnd::left, dt), w_r = end_speed(LineEnd::right, dt);
      double const x0 = line.x.front(), length = line.x.back() - x0;
      for (std::ptrdiff_t f = 0; f <= last; ++f) {
        double const share = (line.x[static_cast<std::size_t>(f)] - x0) / length;
        line.w[f] = w_l + share * (w_r - w_l);
      }
      break;
    }
    case Kind::lagrangian:
      for (std::ptrdiff_t f = 0; f <= last; ++f) line.w[f] = 0.5 * (now.u[f - 1] + now.u[f]);
      break;
  }
  fix_boundary_speed(setup.left, 0, dt);
  fix_boundary_speed(setup.right, last, dt);
}

void GasLine::Impl::fix_boundary_speed(GasBoundary const& b, std::ptrdiff_t f, double dt) noexcept {
  using Kind = GasBoundary::Kind;
  if (b.kind == Kind::piston) line.w[f] = b.velocity(time + 0.5 * dt);
  // on Lagrangian cells the face of an inflow moves with the gas, as the others do
  bool const follows = b.kind == Kind::inflow && setup.motion.kind == MeshMotion::Kind::lagrangian;
  if (b.kind == Kind::wall || (b.kind == Kind::inflow && !follows)) line.w[f] = 0.0;
  if (b.kind == Kind::contact) line.w[f] = (f == 0 ? contacts.left : contacts.right).u;
}

double GasLine::Impl::end_speed(LineEnd end, double dt) const {
  GasBoundary const& b = end == LineEnd::left ? setup.left : setup.right;
  return is_contact(b) ? contacts.at(end).u : boundary_speed(b, time + 0.5 * dt);
}

std::size_t GasLine::Impl::first_bad() const noexcept {
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    if (bad(i, 0.0)) return static_cast<std::size_t>(i);
  }
  return 0;
}

double GasLine::Impl::choose_dt(double t_end, double shrink) {
  double const left = t_end - time;
  double const target = shrink * setup.options.cfl;
  double dt = std::min(target / rate, left);
  if (moving) {
    // what counts is the speed relative to the mesh, and that depends on the step where the motion is prescribed
    for (int k = 0; k < 3; ++k) {
      set_face_speeds(dt);
      dt = std::min(target / signal_rate(now, true), left);
    }
    set_face_speeds(dt);
    dt = std::min(dt, target / signal_rate(now, true));
  }
  if (time + dt > t_end - 1e-10 * dt) dt = left;
  if (moving) set_face_speeds(dt);
  return dt;
}

void GasLine::Impl::prepare() {
  fill_ghosts(setup, line, time, now);
  set_averages_of_primitives();
}

StepReport GasLine::Impl::step(double t_end) {
  assert(!is_contact(setup.left) && !is_contact(setup.right));
  prepare();
  double shrink = 1.0;
  StepReport report;
  for (int tried = 0; tried <= most_retries; ++tried, shrink *= 0.5) {
    if (tried > 0) counters.retried += 1;
    double const dt = choose_dt(t_end, shrink);
    report.dt = dt;
    if (!(dt > 0) || !(time + dt > time)) return {StepStatus::time_step_vanished, 0, dt};
    report = attempt(dt, tried == most_retries);
    if (report.status == StepStatus::ok) {
      accept();
      return report;
    }
  }
  return report;
}

StepReport GasLine::Impl::attempt(double dt, bool last) {
  GasCounters const counters_before = counters;
  Accumulators const floor_before = floor;
  StepReport report{.status = StepStatus::mesh_tangled, .cell = 0, .dt = dt};
  bool sound = !moving || line.sweep(dt);
  double new_rate = 0;
  if (sound) {
    sound = try_step(dt, new_rate);
    report.status = StepStatus::inadmissible_state;
    report.cell = sound ? 0 : first_bad();
  }
  // A step in which a shock forms may have been too long: behind it signals are faster than any were before. They do
  // outrun the shock itself, so that some excess over 1 is sound.
  double const limit = std::max(1.0, 1.6 * setup.options.cfl);
  if (sound && (last || dt * new_rate <= limit)) {
    attempted_dt = dt, attempted_rate = new_rate;
    report.status = StepStatus::ok;
    return report;
  }
  counters = counters_before, floor = floor_before;
  return report;
}

bool GasLine::Impl::try_step(double dt, double& new_rate) {
  FaceRun run{.predictor = predictor,
              .increments = set_increments(dt),
              .linear_star = setup.options.linear_star && setup.options.riemann != RiemannSolver::hllc,
              .dt = dt,
              .at_once = law.energy_line(eos)[0] > 0 && predictor != PredictorKernel::muscl &&
                         setup.motion.kind == MeshMotion::Kind::fixed && setup.options.riemann != RiemannSolver::hllc,
              .riemann = setup.options.riemann};
  if (setup.burn.there()) find_unburnt();
  std::size_t failures = all_faces(run, faces);
  if (setup.motion.kind == MeshMotion::Kind::lagrangian) {
    for (std::ptrdiff_t f = 0; f <= cells(); ++f) line.w[f] = faces.u[f];
    if (!line.sweep(dt)) return false;
  }
  set_sources(dt);
  if (burns()) burn(run, dt);
  std::pair<double, double> result;
  if (cell_feet) {
    run.side = 1;
    failures += all_faces(run, other_faces);
    result = correct_with_cell_feet(dt);
  } else {
    result = correct_all(dt);
  }
  if (failures > 0) return false;
  if (!(result.first > repair_share) && !cell_feet) {
    repair(run, dt);
    if (!floor_vacuum()) return false;
    result.second = signal_rate(next, false);
  }
  new_rate = moving ? 0.0 : result.second;
  return std::isfinite(result.second);
}

std::pair<double, double> GasLine::Impl::correct_all(double dt) {
  int const threads = n >= parallel_threshold ? setup.options.threads : 1;
  if (threads <= 1) return correct(dt, 0, n, next, 0);
  double worst = 1.0, fastest = 0.0;
  std::ptrdiff_t const size = static_cast<std::ptrdiff_t>(16 * face_chunk), blocks = (cells() + size - 1) / size;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(min : worst) reduction(max : fastest)
  for (std::ptrdiff_t k = 0; k < blocks; ++k) {
    std::ptrdiff_t const begin = k * size;
    auto const r = correct(dt, begin, static_cast<std::size_t>(std::min(size, cells() - begin)), next, begin);
    worst = std::min(worst, r.first), fastest = std::max(fastest, r.second);
  }
  return {worst, fastest};
}

void GasLine::Impl::accept() {
  std::ptrdiff_t const last = cells();
  double const dt = attempted_dt;
  double const a0 = curved ? line.area[0] : 1.0, a1 = curved ? line.area[last] : 1.0;
  auto const through = [&](Padded const& f) { return dt * (a0 * f[0] - a1 * f[last]); };
  boundary.add(through(faces.mass), through(faces.momentum), through(faces.energy));
  if (curved || setup.source.mean || burns()) {
    for (std::ptrdiff_t i = 0; i < last; ++i) {
      double m = 0, q = 0, e = 0;
      if (setup.source.mean || burns()) m = src_mass[i], q = src_momentum[i], e = src_energy[i];
      if (curved) q += 0.5 * dt * (faces.p[i] + faces.p[i + 1]) * (line.area[i + 1] - line.area[i]);
      source.add(m, q, e);
    }
  }
  std::swap(now, next);
  if (moving) {
    line.advance(dt);
    rate = signal_rate(now, false);
  } else {
    rate = attempted_rate;
  }
  time += dt;
  counters.steps += 1;
  counters.cell_updates += n;
}

}  // namespace g27
