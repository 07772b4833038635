/// A step of a solid line: faces, corrector, control.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "riemann/strength/jaumann.hpp"
#include "riemann/strength/von_mises.hpp"
#include "scheme/step/solid_line_impl.hpp"

namespace g27 {

namespace {

constexpr int most_retries = 12;

/// S changes by the rates that the derivatives `grad` along `axis` cause, at the stress `mean`.
template <int axis>
void strain_along(double mu, double const* mean, double const* grad, double* S) noexcept {
  double frame[6], rate[6];
  for (int k = 0; k < 6; ++k) frame[k] = mean[frame_component(axis, k)];
  jaumann_along(mu, frame, grad, rate);
  for (int k = 0; k < 6; ++k) S[frame_component(axis, k)] += rate[k];
}

}  // namespace

void SolidLine::Impl::correct(double dt, std::vector<double> const& x_new) {
  yielded = work = hoop_push = 0;
  // mean of the hoop stresses: planar lines have none that acts
  auto const hoop_stress = [&](SolidFace<double> const& f) {
    return f.s[0] - f.S[0] + (hoops == 2 ? 0.5 * (f.S[1] + f.S[2]) : f.S[1]);
  };
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    std::size_t const k = static_cast<std::size_t>(i);
    SolidFace<double> const &l = faces[k], &r = faces[k + 1];
    SolidParcel& to = next[k];
    to = now[k];
    double const area_l = line.area[i], area_r = line.area[i + 1], h = line.h[i], h_new = x_new[k + 1] - x_new[k];
    double power_l = 0, power_r = 0, mean[6];
    for (int c = 0; c < 3; ++c) power_l += l.s[c] * l.u[c], power_r += r.s[c] * r.u[c];
    to.energy += dt * (area_r * power_r - area_l * power_l);
    // a stress that is the same everywhere and in all directions leaves nothing at all
    double const t = hoops > 0 ? 0.5 * (hoop_stress(l) + hoop_stress(r)) : 0.0;
    to.momentum[0] += dt * (area_r * (r.s[0] - t) - area_l * (l.s[0] - t));
    for (int c = 1; c < 3; ++c) to.momentum[c] += dt * (area_r * r.s[c] - area_l * l.s[c]);
    hoop_push -= dt * t * (area_r - area_l);

    for (int c = 0; c < 6; ++c) mean[c] = 0.5 * (l.S[c] + r.S[c]);
    double const by = dt / (0.5 * (h + h_new));
    double const grad[3]{std::log1p(dt * (r.u[0] - l.u[0]) / h), by * (r.u[1] - l.u[1]), by * (r.u[2] - l.u[2])};
    strain_along<0>(strength.mu, mean, grad, to.S);
    if (hoops > 0) {
      double const before = swept_area(line.symmetry, line.x[k], line.x[k + 1]);
      double const after = swept_area(line.symmetry, x_new[k], x_new[k + 1]);
      double const hoop[3]{std::log(after / before) / hoops, 0.0, 0.0};
      strain_along<1>(strength.mu, mean, hoop, to.S);
      if (hoops == 2) strain_along<2>(strength.mu, mean, hoop, to.S);
    }
    if (!plastic) continue;
    double const before = to.ep;
    if (setup.options.midpoint)
      midpoint_return(strength, to.S, to.ep, mean);
    else
      radial_return(strength, to.S, to.ep);
    double const flow = to.ep - before;
    if (!(flow > 0)) continue;
    double const volume = 0.5 * (line.measure[i] + measure_between(line.symmetry, x_new[k], x_new[k + 1]));
    yielded += 1, work += volume * flow * (strength.Y0 + strength.H * 0.5 * (before + to.ep));
  }
}

bool SolidLine::Impl::try_step(double dt, double& new_rate, StepReport& report) {
  all_faces(dt);
  std::vector<double> x_new = line.x;
  for (std::ptrdiff_t f = 0; f <= cells(); ++f) {
    line.w[f] = face(f).u[0];
    x_new[static_cast<std::size_t>(f)] += dt * line.w[f];
  }
  report.status = StepStatus::mesh_tangled;
  bool sound = line.sweep(dt);
  for (std::size_t k = 0; k < n; ++k) sound = sound && x_new[k + 1] > x_new[k];
  if (!sound || (hoops > 0 && !(x_new[0] >= 0))) return false;
  report.status = StepStatus::inadmissible_state;
  correct(dt, x_new);
  primitives(next, x_new, new_cell);
  new_rate = signal_rate(new_cell, x_new, report.cell);
  return new_rate > 0;
}

double SolidLine::Impl::choose_dt(double t_end, double shrink) const {
  double const left = t_end - time, dt = std::min(shrink * setup.options.cfl / rate, left);
  return time + dt > t_end - 1e-10 * dt ? left : dt;
}

StepReport SolidLine::Impl::step(double t_end) {
  assert(setup.left.kind != SolidBoundary::Kind::contact && setup.right.kind != SolidBoundary::Kind::contact);
  double shrink = 1.0;
  StepReport report;
  for (int tried = 0; tried <= most_retries; ++tried, shrink *= 0.5) {
    double const dt = choose_dt(t_end, shrink);
    if (!(dt > 0) || !(time + dt > time)) return {StepStatus::time_step_vanished, 0, dt};
    report = attempt(dt, tried == most_retries);
    if (report.status == StepStatus::ok) {
      accept();
      return report;
    }
    counters.retried += 1;
  }
  return report;
}

StepReport SolidLine::Impl::attempt(double dt, bool last) {
  StepReport report{.status = StepStatus::ok, .cell = 0, .dt = dt};
  double new_rate = 0;
  bool const sound = try_step(dt, new_rate, report);
  // a step in which a shock forms may have been too long
  double const limit = std::max(1.0, 1.6 * setup.options.cfl);
  if (!sound || !(last || dt * new_rate <= limit)) return report;
  attempted_dt = dt, attempted_rate = new_rate;
  report.status = StepStatus::ok, report.cell = 0;
  return report;
}

void SolidLine::Impl::accept() {
  std::ptrdiff_t const last = cells();
  double const dt = attempted_dt;
  double power[2]{};
  for (int side : {0, 1}) {
    SolidFace<double> const& f = face(side == 0 ? 0 : last);
    double const area = (side == 0 ? -dt : dt) * line.area[side == 0 ? 0 : last];
    for (int c = 0; c < 3; ++c) {
      power[side] += area * f.s[c] * f.u[c];
      boundary[static_cast<std::size_t>(1 + c)].add(area * f.s[c]);
    }
    boundary[4].add(power[side]);
  }
  source[1].add(hoop_push);
  plastic_work.add(work);
  for (std::size_t f = 0; f <= n; ++f) speeds[f] = faces[f].u[0];
  std::swap(now, next), std::swap(cell, new_cell);
  line.advance(dt);
  counters.steps += 1, counters.cell_updates += n, counters.faces += n + 1;
  counters.switched += static_cast<std::uint64_t>(switched), counters.tangent += static_cast<std::uint64_t>(tangents);
  counters.yielded += static_cast<std::uint64_t>(yielded);
  time += dt;
  rate = attempted_rate;
}

}  // namespace g27
