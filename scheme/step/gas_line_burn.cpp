/// Programmed burn on a line.
#include <algorithm>

#include "scheme/step/gas_line_impl.hpp"

namespace g27 {

void GasLine::Impl::burn(FaceRun const& run, double dt) {
  unburnt.assign(n, 0.0), unburnt_next.assign(n, 0.0);
  std::vector<char> fresh(n, 0);
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    std::size_t const k = static_cast<std::size_t>(i);
    double const x = line.center(i), lit = setup.burn.lighting({x, 0, 0});
    double const later = x + 0.5 * dt * (line.w[i] + line.w[i + 1]);
    unburnt[k] = setup.burn.unburnt(lit, time, line.h[i]);
    unburnt_next[k] = setup.burn.unburnt(moving ? setup.burn.lighting({later, 0, 0}) : lit, time + dt, line.h[i]);
    fresh[k] = unburnt[k] > 0 || unburnt_next[k] > 0 ? 1 : 0;
  }
  if (std::none_of(fresh.begin(), fresh.end(), [](char c) { return c != 0; })) {
    unburnt.clear();
    return;
  }
  FaceRun first = run;
  first.predictor = PredictorKernel::godunov, first.increments = false, first.linear_star = false;
  auto const at_first_order = [&](std::ptrdiff_t f) {
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, f - 2); i < std::min(cells(), f + 2); ++i) {
      if (fresh[static_cast<std::size_t>(i)] != 0) return true;
    }
    return false;
  };
  for (std::ptrdiff_t f = 0; f <= cells(); ++f) {
    std::ptrdiff_t end = f;
    while (end <= cells() && end - f < static_cast<std::ptrdiff_t>(face_chunk) && at_first_order(end)) ++end;
    if (end == f) continue;
    run_faces(first, f, static_cast<std::size_t>(end - f), problems[0], faces, f);
    f = end - 1;
  }
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
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
