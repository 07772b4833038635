#include "fsi/ale/gas_side.hpp"

#include <algorithm>
#include <cmath>

#include "scheme/predictor/graded_share.hpp"
#include "scheme/predictor/parabolic.hpp"

namespace g27 {

namespace {

constexpr double quiet = 0.01;        ///< bend of the acoustic amplitudes over the pressure up to which no switch acts
constexpr double least_share = 0.02;  ///< of density and pressure margin, that a step may leave
constexpr double most_beyond = 0.5;   ///< change of density and margin to the cell beyond the contact, relative

RowOut row_out(LaneRows<5>& r) noexcept { return {r[0], {r[1], r[2], r[3]}, r[4]}; }

}  // namespace

GasSide::GasSide(AnyEos const& eos, double width, ModelOptions const& options)
    : eos_(eos),
      kernels_(gas_kernels()),
      law_(*kernels_.eos[eos.index()]),
      predictor_(predictor_kernel(options.predictor, options.monotonicity, FootPoints::conservative, false)),
      options_(options),
      at_eos_(std::visit([](auto const& e) -> void const* { return &e; }, eos_)),
      exponent_(std::visit([](auto const& e) { return e.isentropic_exponent(); }, eos_)),
      h_(width),
      terms_(45),
      still_(model_lanes),
      width_(model_lanes, width),
      pair_(model_lanes, 0.5 / width),
      triple_(model_lanes, 1.0 / (3.0 * width)) {}

void GasSide::put(std::size_t lane, int i, int j, int k, GasFields const& q) {
  for (std::size_t f = 0; f < gas_field::count; ++f) block_.at(f, i, j, k)[lane] = q[f];
  std::visit(
      [&](auto const& eos) {
        block_.at(K, i, j, k)[lane] = eos.bulk_modulus(q[rho], q[p]);
        block_.at(margin, i, j, k)[lane] = eos.pressure_margin(q[rho], q[p]);
      },
      eos_);
}

void GasSide::load(std::span<ModelStencil const> stencils, std::array<Vec3, model_lanes> const& frame) {
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    ModelStencil const& s = stencils[std::min(lane, stencils.size() - 1)];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          GasFields q = s.gas[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
          for (std::size_t c = 0; c < 3; ++c) q[u + c] -= frame[lane][c];
          put(lane, i, j, k, q);
        }
      }
    }
    GasFields q = s.gas_fourth.value_or(s.gas[2][1][1]);
    for (std::size_t c = 0; c < 3; ++c) q[u + c] -= frame[lane][c];
    put(lane, 3, 1, 1, q);
  }
}

void GasSide::shift(std::array<Vec3, model_lanes> const& by) noexcept {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
          double* const at = block_.at(u + c, i, j, k);
          for (std::size_t lane = 0; lane < model_lanes; ++lane) at[lane] -= by[lane][c];
        }
      }
    }
  }
}

void GasSide::term_of(int i, int j, int k, double dt, std::array<Terms*, 3> const& out) {
  std::ptrdiff_t const at = LaneBlock<fields>::index(i, j, k);
  double const half = 0.5 * dt / h_;
  TransverseArguments t{.cells = model_lanes,
                        .primitive = RowIn::of({block_.q[rho] + at, block_.q[u] + at, block_.q[u + 1] + at,
                                                block_.q[u + 2] + at, block_.q[p] + at}),
                        .K = block_.q[K] + at,
                        .margin = block_.q[margin] + at,
                        .stride = LaneBlock<fields>::stride,
                        .half_dt_over_h = {half, half, half},
                        .term = {},
                        .flag = nullptr,
                        .any = false};
  for (std::size_t a = 0; a < 3; ++a) {
    if (out[a] != nullptr) t.term[a] = row_out(*out[a]);
  }
  kernels_.predict->grid.transverse[1](t);
}

void GasSide::transverse(double dt) {
  // beyond the contact: one-sided derivatives
  for (std::size_t f = 0; f < fields; ++f) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        double *const to = block_.at(f, -1, j, k), *const q0 = block_.at(f, 0, j, k), *const q1 = block_.at(f, 1, j, k);
        for (std::size_t lane = 0; lane < model_lanes; ++lane) to[lane] = 2 * q0[lane] - q1[lane];
      }
    }
  }
  for (int layer = 0; layer <= core_layers; ++layer) {
    bool const core = layer < core_layers;
    term_of(layer, 1, 1, dt,
            {&term(layer, 0, 0), core ? &term(layer, 0, 1) : nullptr, core ? &term(layer, 0, 2) : nullptr});
    if (!core) continue;
    for (int side = 0; side < 2; ++side) {
      term_of(layer, 2 * side, 1, dt, {nullptr, &term(layer, 1 + side, 1), nullptr});
      term_of(layer, 1, 2 * side, dt, {nullptr, nullptr, &term(layer, 3 + side, 2)});
    }
  }
}

GasTrace GasSide::trace(std::size_t lane, double dt, bool first_order) {
  auto const q = [&](std::size_t f, int layer) { return block_.at(f, layer, 1, 1)[lane]; };
  GasTrace const cell{q(rho, 0), q(u, 0), q(p, 0)};
  if (first_order || options_.predictor == Predictor::godunov) return cell;
  double const c = std::sqrt(q(K, 0) / cell.rho), Z = cell.rho * c;
  auto const difference = [&](std::size_t f, int from) { return q(f, from + 1) - q(f, from); };
  auto const switched = [&](double far, double d) {
    return options_.monotonicity == Switch::off ? d : graded_share(far, d) * d;
  };
  // amplitudes of the waves to and from the contact and of entropy, switched each by itself: where one of them is
  // nothing but round-off, that must not decide about the others
  auto const wave = [&](double sign) {
    auto const amplitude = [&](int from) { return difference(p, from) + sign * Z * difference(u, from); };
    return switched(amplitude(1), amplitude(0));
  };
  auto const entropy = [&](int from) { return difference(rho, from) - difference(p, from) / (c * c); };
  double const to = wave(-1), fro = wave(1), dp = 0.5 * (fro + to), du = 0.5 * (fro - to) / Z;
  // what reaches the contact at half the step starts c dt/2 away from it; entropy stands there
  double const x = 0.5 * c * dt / h_ - 0.5;
  Terms const& t = term(0, 0, 0);
  GasTrace s{.rho = 0, .u = cell.u + x * du + t[u][lane], .p = cell.p + x * dp + t[p][lane]};
  s.rho = cell.rho - 0.5 * switched(entropy(1), entropy(0)) + t[rho][lane] + (s.p - cell.p - t[p][lane]) / (c * c);
  double const left = std::visit([&](auto const& eos) { return eos.pressure_margin(s.rho, s.p); }, eos_);
  bool const near =
      s.rho > 0.3 * cell.rho && s.rho < 3 * cell.rho && left > 0.3 * q(margin, 0) && left < 3 * q(margin, 0);
  return near ? s : cell;
}

void GasSide::faces(int axis, std::array<int, 3> cell, bool far_left, bool far_right, Terms const* left,
                    Terms const* right, double dt, bool first_order, Flux& out) {
  std::size_t const a = static_cast<std::size_t>(axis);
  PredictorKernel const kernel = first_order ? PredictorKernel::godunov : predictor_;
  if (kernel == PredictorKernel::godunov) left = right = nullptr;
  double free[model_lanes] = {};
  for (std::size_t lane = 0; lane < model_lanes && !(far_left && far_right); ++lane) {
    auto const [i, j, k] = known_side(axis, cell, far_left);
    double const stiff = block_.at(K, i, j, k)[lane], Z = std::sqrt(stiff * block_.at(rho, i, j, k)[lane]);
    auto const dp = differences(block_, p, axis, cell, far_left, lane);
    auto const du = differences(block_, u + a, axis, cell, far_left, lane);
    double const most = quiet * stiff / exponent_;
    free[lane] = std::min(plainness(dp.far + Z * du.far, dp.face + Z * du.face, most),
                          plainness(dp.far - Z * du.far, dp.face - Z * du.face, most));
  }
  gather(block_, axis, cell, far_left, far_right, free, stencil_);
  auto const at = [&](std::size_t field) -> double const* { return stencil_.q[field][1]; };
  FaceProblems& b = problems_;
  bool const linear_star = options_.riemann != RiemannSolver::hllc;
  PredictArguments g{.faces = model_lanes,
                     .stride = lane_stride,
                     .own_increments = true,
                     .rho = at(rho),
                     .u = at(u + a),
                     .p = at(p),
                     .K = at(K),
                     .dK_dp = nullptr,
                     .h = width_.data(),
                     .inv_pair = pair_.data(),
                     .inv_triple = triple_.data(),
                     .w = still_.data(),
                     .inc_rho = left ? (*left)[0] : nullptr,
                     .inc_u = left ? (*left)[1 + a] : nullptr,
                     .inc_p = left ? (*left)[4] : nullptr,
                     .next_rho = right ? (*right)[0] : nullptr,
                     .next_u = right ? (*right)[1 + a] : nullptr,
                     .next_p = right ? (*right)[4] : nullptr,
                     .foot_shift = nullptr,
                     .foot_factor = nullptr,
                     .dt = dt,
                     .exponent = exponent_,
                     .linear_star = linear_star,
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
                     .strong = b.strong.data()};
  kernels_.predict->table[static_cast<std::size_t>(kernel)][1](g);
  SolveArguments s{.faces = model_lanes,
                   .stride = lane_stride,
                   .eos = at_eos_,
                   .rho = at(rho),
                   .u = at(u + a),
                   .p = at(p),
                   .margin = at(margin),
                   .w = still_.data(),
                   .lagrangian = false,
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
                   .f_mass = out.q[0],
                   .f_momentum = out.q[1 + a],
                   .f_energy = out.q[4],
                   .face_p = out.at[0],
                   .face_u = out.at[1],
                   .d_rho = nullptr,
                   .d_u = b.d_u.data(),
                   .d_p = b.d_p.data(),
                   .weak_done = false,
                   .failures = 0};
  law_.solve[static_cast<std::size_t>(options_.riemann)](s);
  TangentialArguments t{.faces = model_lanes,
                        .fields = 2,
                        .stride = lane_stride,
                        .rho = at(rho),
                        .u = at(u + a),
                        .p = at(p),
                        .K = at(K),
                        .velocity = {},
                        .increment = {},
                        .next = {},
                        .h = h_,
                        .dt = dt,
                        .f_mass = out.q[0],
                        .f_energy = out.q[4],
                        .f_velocity = {}};
  for (std::size_t k = 0; k < 2; ++k) {
    std::size_t const c = (a + 1 + k) % 3;
    t.velocity[k] = at(u + c);
    t.increment[k] = left ? (*left)[1 + c] : nullptr, t.next[k] = right ? (*right)[1 + c] : nullptr;
    t.f_velocity[k] = out.q[1 + c];
  }
  kernels_.predict->grid.tangential[static_cast<std::size_t>(kernel)](t);
}

void GasSide::continue_beyond(std::array<double, model_lanes> const& pressure) noexcept {
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    auto const q = [&](std::size_t f, int layer) -> double& { return block_.at(f, layer, 1, 1)[lane]; };
    auto const bounded = [](double x, double most) { return std::fabs(x) <= most ? x : std::copysign(most, x); };
    // entropy goes on as it was, pressure and normal velocity through what they are at the contact, where that is zero
    double const c2 = q(K, 0) / q(rho, 0), dp = bounded(2 * (pressure[lane] - q(p, 0)), most_beyond * q(margin, 0));
    double const entropy = q(rho, 1) - q(rho, 0) - (q(p, 1) - q(p, 0)) / c2;
    q(rho, -1) = q(rho, 0) + bounded(dp / c2 - entropy, most_beyond * q(rho, 0)), q(p, -1) = q(p, 0) + dp;
    q(u, -1) = -q(u, 0);
    for (std::size_t c = 1; c < 3; ++c) q(u + c, -1) = 2 * q(u + c, 0) - q(u + c, 1);
    q(K, -1) = q(K, 0), q(margin, -1) = q(margin, 0);
  }
}

bool GasSide::shocks(std::array<double, model_lanes> const& pressure, bool* in_shock) const noexcept {
  bool any = false;
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    double low = pressure[lane], high = low, least_K = block_.at(K, 0, 1, 1)[lane], velocity = 0;
    for (int layer = 0; layer <= core_layers; ++layer) {
      auto const q = [&](std::size_t f) { return block_.at(f, layer, 1, 1)[lane]; };
      low = std::min(low, q(p)), high = std::max(high, q(p));
      least_K = std::min(least_K, q(K)), velocity = std::min(velocity, q(u));
    }
    in_shock[lane] = velocity < 0 && high - low > parabolic::shock_pressure * least_K;
    any = any || in_shock[lane];
  }
  return any;
}

void GasSide::step(double dt, std::array<double, model_lanes> const& pressure, bool first_order) {
  std::array<Flux, core_layers + 1> normal;
  for (std::size_t lane = 0; lane < model_lanes; ++lane) normal[0].q[1][lane] = pressure[lane];
  continue_beyond(pressure);
  for (int layer = 0; layer < core_layers; ++layer) {
    faces(0, {layer, 1, 1}, true, true, &term(layer, 0, 0), &term(layer + 1, 0, 0), dt, first_order,
          normal[static_cast<std::size_t>(layer) + 1]);
  }
  // Shocks stay long in the cells beside a body, while they turn. No slope that is taken there agrees with that of the
  // grid, which takes another for the same face; the flux between cell averages does.
  bool in_shock[model_lanes];
  if (!first_order && shocks(pressure, in_shock)) {
    Flux between;
    faces(0, {0, 1, 1}, true, true, nullptr, nullptr, dt, true, between);
    for (std::size_t lane = 0; lane < model_lanes; ++lane) {
      for (std::size_t d = 0; d < 5 && in_shock[lane]; ++d) normal[1].q[d][lane] = between.q[d][lane];
    }
  }
  double const lambda = dt / h_;
  for (int layer = 0; layer < core_layers; ++layer) {
    std::size_t const l = static_cast<std::size_t>(layer);
    std::array<Flux, 4> across;
    faces(1, {layer, 0, 1}, false, true, &term(layer, 1, 1), &term(layer, 0, 1), dt, first_order, across[0]);
    faces(1, {layer, 1, 1}, true, false, &term(layer, 0, 1), &term(layer, 2, 1), dt, first_order, across[1]);
    faces(2, {layer, 1, 0}, false, true, &term(layer, 3, 2), &term(layer, 0, 2), dt, first_order, across[2]);
    faces(2, {layer, 1, 1}, true, false, &term(layer, 0, 2), &term(layer, 4, 2), dt, first_order, across[3]);
    for (std::size_t lane = 0; lane < model_lanes; ++lane) {
      auto const q = [&](std::size_t f) { return block_.at(f, layer, 1, 1)[lane]; };
      double const e = std::visit([&](auto const& eos) { return eos.energy(q(rho), q(p)); }, eos_);
      double const speed2 = q(u) * q(u) + q(u + 1) * q(u + 1) + q(u + 2) * q(u + 2);
      now_[l][0][lane] = q(rho), now_[l][4][lane] = q(rho) * (e + 0.5 * speed2);
      for (std::size_t c = 0; c < 3; ++c) now_[l][1 + c][lane] = q(rho) * q(u + c);
    }
    for (std::size_t d = 0; d < 5; ++d) {
      for (std::size_t lane = 0; lane < model_lanes; ++lane) {
        next_[l][d][lane] = now_[l][d][lane] - lambda * (normal[l + 1].q[d][lane] - normal[l].q[d][lane]) -
                            lambda * (across[1].q[d][lane] - across[0].q[d][lane]) -
                            lambda * (across[3].q[d][lane] - across[2].q[d][lane]);
      }
    }
  }
}

GasFields GasSide::state(std::size_t lane, int layer, Vec3 const& frame, bool& sound) const {
  LaneRows<5> const &q = next_[static_cast<std::size_t>(layer)], &old = now_[static_cast<std::size_t>(layer)];
  GasFields s{q[0][lane]};
  double speed2 = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double const v = q[1 + c][lane] / s[rho];
    s[u + c] = v + frame[c], speed2 += v * v;
  }
  double const e = q[4][lane] / s[rho] - 0.5 * speed2;
  auto const margin_of = [&](double density, double pressure) {
    return std::visit([&](auto const& eos) { return eos.pressure_margin(density, pressure); }, eos_);
  };
  s[p] = std::visit([&](auto const& eos) { return eos.pressure(s[rho], e); }, eos_);
  double const margin_old = block_.at(margin, layer, 1, 1)[lane];
  sound = sound && s[rho] > least_share * old[0][lane] && margin_of(s[rho], s[p]) > least_share * margin_old;
  for (double x : s) sound = sound && std::isfinite(x);
  return s;
}

}  // namespace g27
