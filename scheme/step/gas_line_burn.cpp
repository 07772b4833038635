/// Programmed burn on a line.
#include <algorithm>

#include "scheme/step/gas_line_impl.hpp"

namespace g27 {

void GasLine::Impl::find_unburnt() {
  unburnt.assign(n, 0.0);
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const lit = setup.burn.lighting({line.center(i), 0, 0});
    unburnt[static_cast<std::size_t>(i)] = setup.burn.unburnt(lit, time, line.h[i]);
  }
  if (std::none_of(unburnt.begin(), unburnt.end(), [](double x) { return x > 0; })) {
    unburnt.clear();
    return;
  }
  unburnt_faces.assign(n + 1, 0);
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    if (!(unburnt[static_cast<std::size_t>(i)] > 0)) continue;
    // the stencils of faces reach two cells to either side
    for (std::ptrdiff_t f = std::max<std::ptrdiff_t>(0, i - 1); f <= std::min(cells(), i + 2); ++f)
      unburnt_faces[static_cast<std::size_t>(f)] = 1;
  }
}

void GasLine::Impl::leave_unburnt(std::ptrdiff_t begin, std::size_t count, FaceProblems& b) const noexcept {
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(count); ++k) {
    if (unburnt_faces[static_cast<std::size_t>(begin + k)] == 0) continue;
    GasState<> const s = now.state(std::min(begin + k, cells() - 1));
    b.s_rho[k] = s.rho, b.s_u[k] = s.u, b.s_p[k] = s.p, b.strong[k] = 0.0;
  }
}

GasLine::Impl::FaceRun GasLine::Impl::beside_unburnt(FaceRun run) noexcept {
  run = at_first_order(run);
  run.at_once = false, run.riemann = RiemannSolver::hllc, run.unburnt = true;
  return run;
}

void GasLine::Impl::burn(FaceRun const& run, double dt) {
  FaceRun const first = beside_unburnt(run);
  std::ptrdiff_t const chunk = static_cast<std::ptrdiff_t>(face_chunk);
  for (std::ptrdiff_t f = 0, end = 0; f <= cells(); f = std::max(end, f + 1)) {
    for (end = f; end <= cells() && end - f < chunk && unburnt_faces[static_cast<std::size_t>(end)] != 0;) ++end;
    if (end > f) run_faces(first, f, static_cast<std::size_t>(end - f), problems[0], faces, f);
  }
  unburnt_next.assign(n, 0.0);
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const x = line.center(i) + 0.5 * dt * (line.w[i] + line.w[i + 1]);
    unburnt_next[static_cast<std::size_t>(i)] =
        setup.burn.unburnt(setup.burn.lighting({x, 0, 0}), time + dt, line.h[i]);
    src_mass[i] = src_momentum[i] = 0.0;
    release(i, dt);
  }
}

void GasLine::Impl::release(std::ptrdiff_t i, double dt) noexcept {
  auto const at = [&](std::ptrdiff_t cell) {
    return unburnt[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(cell, 0, cells() - 1))];
  };
  auto const flow = [&](std::ptrdiff_t f) { return dt * (curved ? line.area[f] : 1.0) * faces.mass[f]; };
  double const in = flow(i), out = flow(i + 1), mass = line.measure[i] * now.mass[i];
  double const fresh = at(i) * mass + (in > 0 ? at(i - 1) : at(i)) * in - (out > 0 ? at(i) : at(i + 1)) * out;
  src_energy[i] = setup.burn.energy * (fresh - unburnt_next[static_cast<std::size_t>(i)] * (mass + in - out));
}

}  // namespace g27
