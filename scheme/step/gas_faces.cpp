#include <omp.h>

#include <algorithm>

#include "scheme/step/gas_line_impl.hpp"

namespace g27 {

namespace {

constexpr double increment_share = 0.2;  ///< least share of rho and margin that a half-step increment leaves

}  // namespace

double GasLine::Impl::geometric_divergence(std::ptrdiff_t i) const noexcept {
  double const x0 = line.center(i) - 0.5 * line.h[i], x1 = line.center(i) + 0.5 * line.h[i];
  double const u0 = 0.5 * (now.u[i - 1] + now.u[i]), u1 = 0.5 * (now.u[i] + now.u[i + 1]);
  double const flow = swept_area(setup.symmetry, x1, x1) * u1 - swept_area(setup.symmetry, x0, x0) * u0;
  return flow / measure_between(setup.symmetry, x0, x1) - (u1 - u0) * line.inv_h[i];
}

void GasLine::Impl::set_averages_of_primitives() {
  if (!is_third_order(predictor)) return;
  law.average({.cells = n,
               .eos = eos,
               .rho = now.rho.data(),
               .u = now.u.data(),
               .p = now.p.data(),
               .K = now.K.data(),
               .h = line.h.data(),
               .dK_dp = dK_dp.data(),
               .u_mean = u_mean.data(),
               .p_mean = p_mean.data()});
  fill_mean_ghosts(setup, line, now, u_mean, p_mean, dK_dp);
}

bool GasLine::Impl::set_increments(double dt) {
  if (!curved && !setup.source.primitive_rate) return false;
  if (predictor == PredictorKernel::godunov) return false;
  for (std::ptrdiff_t i = -1; i <= cells(); ++i) {
    GasState<> d{0, 0, 0};
    double const x = line.center(i);
    if (curved) {
      double const spread = geometric_divergence(i);
      d = {-now.rho[i] * spread, 0.0, -now.K[i] * spread};
    }
    if (setup.source.primitive_rate) {
      // the mean over the step of what has accumulated along a characteristic is half a step of the rate a third on,
      // where the mesh has carried the cell by then
      double const carried = 0.5 * (line.w[std::max<std::ptrdiff_t>(i, 0)] + line.w[std::min(i + 1, cells())]);
      GasState<> const r = setup.source.primitive_rate(x + carried * dt / 3.0, time + dt / 3.0);
      d = {d.rho + r.rho, d.u + r.u, d.p + r.p};
    }
    d = {0.5 * dt * d.rho, 0.5 * dt * d.u, 0.5 * dt * d.p};
    bool const deep =
        now.rho[i] + d.rho < increment_share * now.rho[i] || now.margin[i] + d.p < increment_share * now.margin[i];
    if (deep) d = {0, 0, 0};
    inc_rho[i] = d.rho, inc_u[i] = d.u, inc_p[i] = d.p;
  }
  return true;
}

void GasLine::Impl::predict(FaceRun const& run, std::ptrdiff_t f, std::size_t count, FaceProblems& b,
                            FluxesAtOnce const& at_once) const noexcept {
  std::ptrdiff_t const c = f - 1;  // the cell on the left of face f
  bool const averaged = is_third_order(run.predictor);
  predict_row(run, count,
              {.rho = now.rho.data() + c,
               .u = (averaged ? u_mean : now.u).data() + c,
               .p = (averaged ? p_mean : now.p).data() + c,
               .K = now.K.data() + c,
               .dK_dp = dK_dp.data() + c,
               .h = line.h.data() + c,
               .inv_pair = line.inv_pair.data() + c,
               .inv_triple = line.inv_triple.data() + c,
               .w = line.w.data() + f,
               .inc_rho = inc_rho.data() + c,
               .inc_u = inc_u.data() + c,
               .inc_p = inc_p.data() + c,
               .foot_shift = cell_feet ? line.foot_shift[run.side].data() + f : nullptr,
               .foot_factor = cell_feet ? line.foot_factor[run.side].data() + f : nullptr},
              b, at_once);
}

void GasLine::Impl::predict_row(FaceRun const& run, std::size_t count, PredictorRow const& row, FaceProblems& b,
                                FluxesAtOnce const& at_once) const noexcept {
  PredictArguments const g{.faces = count,
                           .stride = 1,
                           .own_increments = false,
                           .rho = row.rho,
                           .u = row.u,
                           .p = row.p,
                           .K = row.K,
                           .dK_dp = row.dK_dp,
                           .h = row.h,
                           .inv_pair = row.inv_pair,
                           .inv_triple = row.inv_triple,
                           .w = row.w,
                           .inc_rho = run.increments ? row.inc_rho : nullptr,
                           .inc_u = row.inc_u,
                           .inc_p = row.inc_p,
                           .next_rho = row.inc_rho + 1,
                           .next_u = row.inc_u + 1,
                           .next_p = row.inc_p + 1,
                           .foot_shift = row.foot_shift,
                           .foot_factor = row.foot_factor,
                           .dt = run.dt,
                           .exponent = exponent,
                           .linear_star = run.linear_star,
                           .l_rho = b.l_rho.data(),
                           .l_u = b.l_u.data(),
                           .l_p = b.l_p.data(),
                           .r_rho = b.r_rho.data(),
                           .r_u = b.r_u.data(),
                           .r_p = b.r_p.data(),
                           .s_rho = b.s_rho.data(),
                           .s_u = b.s_u.data(),
                           .s_p = b.s_p.data(),
                           .switched = b.switched.data(),
                           .d_rho = b.d_rho.data(),
                           .d_u = b.d_u.data(),
                           .d_p = b.d_p.data(),
                           .strong = b.strong.data(),
                           .at_once = at_once};
  kernels.predict->table[static_cast<std::size_t>(run.predictor)][line.uniform() ? 1 : 0](g);
}

void GasLine::Impl::predict_mirrored(FaceRun const& run, std::ptrdiff_t f, FaceProblems& b) noexcept {
  // the cells f + 1, f | f - 1, f - 2 become -1, 0 | 1, 2 of a row of one face
  MirrorRow& m = mirror_row;
  bool const averaged = is_third_order(run.predictor);
  for (std::ptrdiff_t k = -1; k <= 2; ++k) {
    std::ptrdiff_t const i = f - k;
    m.rho[k] = now.rho[i], m.u[k] = -(averaged ? u_mean : now.u)[i], m.p[k] = (averaged ? p_mean : now.p)[i];
    m.K[k] = now.K[i], m.dK_dp[k] = averaged ? dK_dp[i] : 0.0;
    m.h[k] = line.h[i], m.inv_triple[k] = line.inv_triple[i];
    if (k < 2) m.inv_pair[k] = line.inv_pair[i - 1];
    if (k == 0 || k == 1) m.inc_rho[k] = inc_rho[i], m.inc_u[k] = -inc_u[i], m.inc_p[k] = inc_p[i];
  }
  m.w[0] = -line.w[f], m.w[-1] = -line.w[f + 1];
  if (cell_feet) m.foot_shift[0] = -line.foot_shift[run.side][f], m.foot_factor[0] = line.foot_factor[run.side][f];
  predict_row(run, 1, m.row(), b, {});
}

std::size_t GasLine::Impl::solve(FaceRun const& run, std::ptrdiff_t f, std::size_t count, FaceProblems& b,
                                 GasFaces& out, std::ptrdiff_t to) const noexcept {
  std::ptrdiff_t const c = f - 1;
  SolveArguments g{.faces = count,
                   .stride = 1,
                   .eos = eos,
                   .rho = now.rho.data() + c,
                   .u = now.u.data() + c,
                   .p = now.p.data() + c,
                   .margin = now.margin.data() + c,
                   .w = line.w.data() + f,
                   .lagrangian = setup.motion.kind == MeshMotion::Kind::lagrangian,
                   .l_rho = b.l_rho.data(),
                   .l_u = b.l_u.data(),
                   .l_p = b.l_p.data(),
                   .r_rho = b.r_rho.data(),
                   .r_u = b.r_u.data(),
                   .r_p = b.r_p.data(),
                   .s_rho = b.s_rho.data(),
                   .s_u = b.s_u.data(),
                   .s_p = b.s_p.data(),
                   .strong = b.strong.data(),
                   .f_mass = out.mass.data() + to,
                   .f_momentum = out.momentum.data() + to,
                   .f_energy = out.energy.data() + to,
                   .face_p = out.p.data() + to,
                   .face_u = out.u.data() + to,
                   .d_rho = is_third_order(run.predictor) ? b.d_rho.data() : nullptr,
                   .d_u = b.d_u.data(),
                   .d_p = b.d_p.data(),
                   .weak_done = run.at_once,
                   .failures = 0};
  law.solve[static_cast<std::size_t>(run.riemann)](g);
  return g.failures;
}

void GasLine::Impl::image_in_wall(FaceRun run, std::ptrdiff_t f, bool wall_on_left, FaceProblems& b,
                                  std::size_t at) noexcept {
  FaceProblems& one = wall_problems[wall_on_left ? 0 : 1];
  run.linear_star = false;
  if (wall_on_left) {
    predict_mirrored(run, f, one);
  } else {
    predict(run, f, 1, one, {});
  }
  // seen with the gas on the left; the image carries the same density and pressure and twice the wall's speed less its
  // own
  GasState<> const s{one.l_rho[0], wall_on_left ? -one.l_u[0] : one.l_u[0], one.l_p[0]};
  std::ptrdiff_t const i = static_cast<std::ptrdiff_t>(at);
  double const image = 2.0 * line.w[f] - s.u;
  b.l_rho[i] = b.r_rho[i] = s.rho, b.l_p[i] = b.r_p[i] = s.p;
  b.l_u[i] = wall_on_left ? image : s.u, b.r_u[i] = wall_on_left ? s.u : image;
  b.d_rho[i] = b.d_u[i] = b.d_p[i] = 0.0;
  b.strong[i] = 1.0;
}

std::size_t GasLine::Impl::run_faces(FaceRun const& run, std::ptrdiff_t begin, std::size_t count, FaceProblems& b,
                                     GasFaces& out, std::ptrdiff_t to) noexcept {
  FluxesAtOnce at_once;
  if (run.at_once) {
    // the states are kept: pressure and velocity of every face are wanted
    auto const line_of_law = law.energy_line(eos);
    at_once = {.per_pressure = line_of_law[0],
               .at_zero = line_of_law[1],
               .keep_states = true,
               .mass = out.mass.data() + to,
               .momentum = out.momentum.data() + to,
               .energy = out.energy.data() + to};
  }
  predict(run, begin, count, b, at_once);
  std::ptrdiff_t const end = begin + static_cast<std::ptrdiff_t>(count);
  if (begin == 0 && is_wall(setup.left)) image_in_wall(run, 0, true, b, 0);
  if (end == cells() + 1 && is_wall(setup.right)) image_in_wall(run, cells(), false, b, count - 1);
  if (begin == 0 && is_contact(setup.left)) leave_to_contact(0, b, 0);
  if (end == cells() + 1 && is_contact(setup.right)) leave_to_contact(cells() - 1, b, count - 1);
  if (burns() && !run.unburnt) leave_unburnt(begin, count, b);
  std::size_t const failures = solve(run, begin, count, b, out, to);
  if (begin == 0 && is_wall(setup.left)) seal(out, to, line.w[0]);
  if (end == cells() + 1 && is_wall(setup.right))
    seal(out, to + static_cast<std::ptrdiff_t>(count) - 1, line.w[cells()]);
  if (begin == 0 && is_contact(setup.left)) seal_contact(out, to, contacts.left);
  if (end == cells() + 1 && is_contact(setup.right))
    seal_contact(out, to + static_cast<std::ptrdiff_t>(count) - 1, contacts.right);
  return failures;
}

void GasLine::Impl::leave_to_contact(std::ptrdiff_t cell, FaceProblems& b, std::size_t at) const noexcept {
  std::ptrdiff_t const i = static_cast<std::ptrdiff_t>(at);
  GasState<> const s = now.state(cell);
  b.l_rho[i] = b.r_rho[i] = s.rho, b.l_u[i] = b.r_u[i] = s.u, b.l_p[i] = b.r_p[i] = s.p;
  b.d_rho[i] = b.d_u[i] = b.d_p[i] = 0.0;
  b.strong[i] = 1.0;
}

void GasLine::Impl::seal_contact(GasFaces& out, std::ptrdiff_t f, Contact const& c) noexcept {
  out.p[f] = c.p;
  seal(out, f, c.u);
}

void GasLine::Impl::seal(GasFaces& out, std::ptrdiff_t f, double w) noexcept {
  out.mass[f] = 0.0, out.momentum[f] = out.p[f], out.energy[f] = out.p[f] * w, out.u[f] = w;
}

std::size_t GasLine::Impl::all_faces(FaceRun const& run, GasFaces& out) {
  // the last face of a periodic line is its first
  bool const periodic = setup.left.kind == GasBoundary::Kind::periodic;
  std::ptrdiff_t const count = cells() + (periodic ? 0 : 1),
                       chunks = (count + static_cast<std::ptrdiff_t>(face_chunk) - 1) /
                                static_cast<std::ptrdiff_t>(face_chunk);
  double switched = 0, strong = 0;
  std::size_t failures = 0;
  int const threads = n >= parallel_threshold ? setup.options.threads : 1;
  auto const one_chunk = [&](std::ptrdiff_t k, FaceProblems& b, double& sw, double& st, std::size_t& fail) {
    std::ptrdiff_t const begin = k * static_cast<std::ptrdiff_t>(face_chunk);
    std::size_t const len = static_cast<std::size_t>(std::min<std::ptrdiff_t>(face_chunk, count - begin));
    fail += run_faces(run, begin, len, b, out, begin);
    CountArguments counts{.faces = len,
                          .switched = b.switched.data(),
                          .strong = b.strong.data(),
                          .map = switch_counts.data() + begin,
                          .faces_switched = 0,
                          .faces_strong = 0};
    kernels.predict->count(counts);
    sw += counts.faces_switched, st += counts.faces_strong;
  };
  if (threads <= 1) {
    for (std::ptrdiff_t k = 0; k < chunks; ++k) one_chunk(k, problems[0], switched, strong, failures);
  } else {
    // counts are small integers: their sums do not depend on the order
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : switched, strong, failures)
    for (std::ptrdiff_t k = 0; k < chunks; ++k) {
      one_chunk(k, problems[static_cast<std::size_t>(omp_get_thread_num())], switched, strong, failures);
    }
  }
  if (periodic) {
    out.copy_face(count, out, 0);
    switch_counts[static_cast<std::size_t>(count)] = switch_counts[0];
  }
  counters.faces += static_cast<std::uint64_t>(count);
  counters.switched += static_cast<std::uint64_t>(switched);
  counters.linear_star += static_cast<std::uint64_t>(static_cast<double>(count) - strong);
  return failures;
}

}  // namespace g27
