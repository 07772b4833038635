#include "scheme/step/gas_line.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/gas_boundary.hpp"
#include "scheme/step/gas_fields.hpp"
#include "scheme/step/gauss.hpp"

namespace g27 {

namespace {

constexpr std::size_t chunk = 256;                ///< faces handled at a time: their arrays stay in the first cache
constexpr std::size_t parallel_threshold = 8192;  ///< cells below which threads cost more than they bring
constexpr double repair_share = 1e-3;             ///< least rho and margin a step may leave, over the old ones
constexpr double increment_share = 0.2;           ///< least share of rho and margin that a half-step increment leaves
constexpr double vacuum_pressure = 1e-12, vacuum_density = 1e-13;  ///< floors, over rho u^2 and the largest density
constexpr int most_retries = 12;

/// Sum that loses nothing to round-off over millions of steps (Neumaier).
struct Accumulator {
  double sum = 0, lost = 0;
  void add(double v) noexcept {
    double const t = sum + v;
    lost += std::fabs(sum) >= std::fabs(v) ? (sum - t) + v : (v - t) + sum;
    sum = t;
  }
  [[nodiscard]] double value() const noexcept { return sum + lost; }
};
struct Accumulators {
  Accumulator mass, momentum, energy;
  void add(double m, double q, double e) noexcept { mass.add(m), momentum.add(q), energy.add(e); }
};

PredictorKernel kernel_of(GasSchemeOptions const& o) {
  bool const per_cell = o.feet != FootPoints::conservative;
  if (per_cell && (o.predictor != Predictor::linear || o.monotonicity != Switch::off)) {
    throw std::invalid_argument("the points of (3.10) go with the linear predictor and the switch off");
  }
  switch (o.predictor) {
    case Predictor::godunov:
      return PredictorKernel::godunov;
    case Predictor::muscl:
      return PredictorKernel::muscl;
    case Predictor::parabolic:
      return o.monotonicity == Switch::off ? PredictorKernel::parabolic_off : PredictorKernel::parabolic_on;
    case Predictor::linear:
      break;
  }
  if (per_cell) return PredictorKernel::linear_cell_feet;
  if (o.single_foot) return PredictorKernel::linear_single_foot;
  switch (o.monotonicity) {
    case Switch::off:
      return PredictorKernel::linear_off;
    case Switch::literal:
      return PredictorKernel::linear_literal;
    case Switch::binary:
      return PredictorKernel::linear_binary;
    case Switch::graded:
      return PredictorKernel::linear_graded;
  }
  return PredictorKernel::linear_graded;
}

}  // namespace

struct GasLine::Impl {
  GasLineSetup setup;
  GasKernels const& kernels = gas_kernels();
  PredictorKernel predictor;
  EosKernels const& law;
  std::size_t n;
  void const* eos;
  double exponent = 1.0;
  bool moving, curved, plain, cell_feet;
  Line line;
  GasCells now, next;
  GasFaces faces, other_faces;  ///< `other_faces`: as the cell on the right sees them, with the points of OG (3.10)
  Padded inc_rho, inc_u, inc_p, src_mass, src_momentum, src_energy;
  std::vector<double> switch_counts;
  std::vector<char> redone;
  std::vector<FaceProblems> problems;  ///< one a thread
  FaceProblems wall_problems[2]{FaceProblems(16), FaceProblems(16)};
  double time = 0, rate = 0, largest_density = 0;
  GasCounters counters;
  Accumulators initial, boundary, source, floor;
  GasConserved<> scale{0, 0, 0};

  explicit Impl(GasLineSetup s)
      : setup(std::move(s)),
        predictor(kernel_of(setup.options)),
        law(*kernels.eos[setup.eos.index()]),
        n(checked_cells(setup)),
        eos(std::visit([](auto const& e) -> void const* { return &e; }, setup.eos)),
        exponent(std::visit([](auto const& e) { return e.isentropic_exponent(); }, setup.eos)),
        moving(setup.motion.kind != MeshMotion::Kind::fixed),
        curved(setup.symmetry != Symmetry::planar),
        plain(false),
        cell_feet(predictor == PredictorKernel::linear_cell_feet),
        line(setup.faces, setup.symmetry, setup.left.kind == GasBoundary::Kind::periodic, !moving),
        now(n + 2),
        next(n + 2),
        faces(n + 1),
        other_faces(cell_feet ? n + 1 : 0),
        inc_rho(n + 2),
        inc_u(n + 2),
        inc_p(n + 2),
        src_mass(n),
        src_momentum(n),
        src_energy(n),
        switch_counts(n + 1, 0.0),
        redone(n + 1, 0) {
    plain = line.uniform() && !curved && !setup.source.mean && !cell_feet;
    problems.assign(static_cast<std::size_t>(std::max(1, setup.options.threads)), FaceProblems(chunk + 16));
    if (cell_feet) line.set_cell_feet(setup.options.feet == FootPoints::printed_3_10);
  }

  static std::size_t checked_cells(GasLineSetup const& s) {
    if (s.faces.size() < 4) throw std::invalid_argument("a line needs at least 3 cells");
    for (std::size_t f = 1; f < s.faces.size(); ++f) {
      if (!(s.faces[f] > s.faces[f - 1])) throw std::invalid_argument("face positions must increase");
    }
    if (s.symmetry != Symmetry::planar && s.faces.front() < 0) {
      throw std::invalid_argument("curved symmetry needs positions >= 0");
    }
    using Kind = GasBoundary::Kind;
    if ((s.left.kind == Kind::periodic) != (s.right.kind == Kind::periodic)) {
      throw std::invalid_argument("a periodic boundary needs its partner");
    }
    return s.faces.size() - 1;
  }

  [[nodiscard]] std::ptrdiff_t cells() const noexcept { return static_cast<std::ptrdiff_t>(n); }

  // ---- state -------------------------------------------------------------------------------------------------------

  void primitives(GasCells& c, std::ptrdiff_t begin, std::size_t count) const noexcept {
    law.primitive({.cells = count,
                   .eos = eos,
                   .mass = c.mass.data() + begin,
                   .momentum = c.momentum.data() + begin,
                   .energy = c.energy.data() + begin,
                   .rho = c.rho.data() + begin,
                   .u = c.u.data() + begin,
                   .p = c.p.data() + begin,
                   .K = c.K.data() + begin,
                   .margin = c.margin.data() + begin});
  }

  [[nodiscard]] double energy_density(GasState<> const& s) const noexcept {
    return s.rho * std::visit([&](auto const& e) { return e.energy(s.rho, s.p); }, setup.eos) + 0.5 * s.rho * s.u * s.u;
  }

  void start(double t) {
    primitives(now, 0, n);
    time = t;
    counters = {};
    initial = boundary = source = floor = {};
    scale = {0, 0, 0};
    add_totals(initial, &scale);
    rate = signal_rate(now, false);
    largest_density = 0;
    for (std::ptrdiff_t i = 0; i < cells(); ++i) largest_density = std::max(largest_density, now.rho[i]);
  }

  void add_totals(Accumulators& a, GasConserved<>* magnitude) const noexcept {
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      double const v = line.measure[i];
      GasConserved<> const q = now.average(i);
      a.add(v * q.mass, v * q.momentum, v * q.energy);
      if (magnitude != nullptr) {
        magnitude->mass += v * std::fabs(q.mass);
        magnitude->momentum += v * (std::fabs(q.momentum) + std::sqrt(now.K[i] * now.rho[i]));
        magnitude->energy += v * (std::fabs(q.energy) + now.K[i]);
      }
    }
  }

  /// Largest signal speed over width; with the mesh's own speed when `relative`.
  [[nodiscard]] double signal_rate(GasCells const& c, bool relative) const noexcept {
    double most = 0;
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      double const sound = std::sqrt(c.K[i] / c.rho[i]);
      double speed = std::fabs(c.u[i]);
      if (relative) speed = std::max(std::fabs(c.u[i] - line.w[i]), std::fabs(c.u[i] - line.w[i + 1]));
      double const r = (speed + sound) * line.inv_h[i];
      if (!(r <= most)) most = r;  // a NaN stays
    }
    return most;
  }

  // ---- mesh motion -------------------------------------------------------------------------------------------------

  /// Face speeds for a step from `time`; the contact's own speed comes later for Lagrangian faces.
  void set_face_speeds(double dt) {
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
        double const w_l = boundary_speed(setup.left, time + 0.5 * dt),
                     w_r = boundary_speed(setup.right, time + 0.5 * dt);
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

  void fix_boundary_speed(GasBoundary const& b, std::ptrdiff_t f, double dt) noexcept {
    using Kind = GasBoundary::Kind;
    if (b.kind == Kind::piston) line.w[f] = b.velocity(time + 0.5 * dt);
    if (b.kind == Kind::wall || b.kind == Kind::inflow) line.w[f] = 0.0;
  }

  // ---- predictor and Riemann problems ------------------------------------------------------------------------------

  /// Half-step increments of geometry (alpha rho u / r, alpha K u / r) and of manufactured sources.
  bool set_increments(double dt) {
    if (!curved && !setup.source.primitive_rate) return false;
    if (predictor == PredictorKernel::godunov) return false;
    double const alpha = static_cast<double>(setup.symmetry);
    for (std::ptrdiff_t i = -1; i <= cells(); ++i) {
      GasState<> d{0, 0, 0};
      double const x = line.center(i);
      if (curved) d = {-alpha * now.rho[i] * now.u[i] / x, 0.0, -alpha * now.K[i] * now.u[i] / x};
      if (setup.source.primitive_rate) {
        // the mean over the step of what has accumulated along a characteristic is half a step of the rate a third on
        GasState<> const r = setup.source.primitive_rate(x, time + dt / 3.0);
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

  struct FaceRun {
    PredictorKernel predictor;
    bool increments, linear_star;
    double dt;
    int side = 0;  ///< OG (3.10): for the cell on the left (0) or on the right (1)
  };

  void predict(FaceRun const& run, std::ptrdiff_t f, std::size_t count, FaceProblems& b) const noexcept {
    std::ptrdiff_t const c = f - 1;  // the cell on the left of face f
    PredictArguments const g{.faces = count,
                             .rho = now.rho.data() + c,
                             .u = now.u.data() + c,
                             .p = now.p.data() + c,
                             .K = now.K.data() + c,
                             .h = line.h.data() + c,
                             .inv_pair = line.inv_pair.data() + c,
                             .inv_triple = line.inv_triple.data() + c,
                             .w = line.w.data() + f,
                             .inc_rho = run.increments ? inc_rho.data() + c : nullptr,
                             .inc_u = inc_u.data() + c,
                             .inc_p = inc_p.data() + c,
                             .foot_shift = cell_feet ? line.foot_shift[run.side].data() + f : nullptr,
                             .foot_factor = cell_feet ? line.foot_factor[run.side].data() + f : nullptr,
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
                             .strong = b.strong.data()};
    kernels.predict->table[static_cast<std::size_t>(run.predictor)][line.uniform() ? 1 : 0](g);
  }

  std::size_t solve(std::ptrdiff_t f, std::size_t count, FaceProblems& b, GasFaces& out,
                    std::ptrdiff_t to) const noexcept {
    std::ptrdiff_t const c = f - 1;
    SolveArguments g{.faces = count,
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
                     .failures = 0};
    law.solve[static_cast<std::size_t>(setup.options.riemann)](g);
    return g.failures;
  }

  /// A wall's Riemann problem: the gas beside it against its own image in the moving wall.
  void image_in_wall(FaceRun run, std::ptrdiff_t f, bool wall_on_left, FaceProblems& b, std::size_t at) noexcept {
    FaceProblems& one = wall_problems[wall_on_left ? 0 : 1];
    run.linear_star = false;
    predict(run, f, 1, one);
    double const w = line.w[f];
    GasState<> s = wall_on_left ? GasState<>{one.r_rho[0], one.r_u[0], one.r_p[0]}
                                : GasState<>{one.l_rho[0], one.l_u[0], one.l_p[0]};
    std::ptrdiff_t const i = static_cast<std::ptrdiff_t>(at);
    double const image = 2.0 * w - s.u;
    b.l_rho[i] = b.r_rho[i] = s.rho, b.l_p[i] = b.r_p[i] = s.p;
    b.l_u[i] = wall_on_left ? image : s.u, b.r_u[i] = wall_on_left ? s.u : image;
    b.strong[i] = 1.0;
  }

  /// Predictor and Riemann problems of the faces [begin, begin + count), written to out at `to`. Returns failures.
  std::size_t run_faces(FaceRun const& run, std::ptrdiff_t begin, std::size_t count, FaceProblems& b, GasFaces& out,
                        std::ptrdiff_t to) noexcept {
    predict(run, begin, count, b);
    std::ptrdiff_t const end = begin + static_cast<std::ptrdiff_t>(count);
    if (begin == 0 && is_wall(setup.left)) image_in_wall(run, 0, true, b, 0);
    if (end == cells() + 1 && is_wall(setup.right)) image_in_wall(run, cells(), false, b, count - 1);
    std::size_t const failures = solve(begin, count, b, out, to);
    if (begin == 0 && is_wall(setup.left)) seal(out, to, line.w[0]);
    if (end == cells() + 1 && is_wall(setup.right))
      seal(out, to + static_cast<std::ptrdiff_t>(count) - 1, line.w[cells()]);
    return failures;
  }

  /// Nothing passes a wall but its push and its work: exactly, not to round-off.
  static void seal(GasFaces& out, std::ptrdiff_t f, double w) noexcept {
    out.mass[f] = 0.0, out.momentum[f] = out.p[f], out.energy[f] = out.p[f] * w, out.u[f] = w;
  }

  std::size_t all_faces(FaceRun const& run, GasFaces& out) {
    std::ptrdiff_t const count = cells() + 1,
                         chunks = (count + static_cast<std::ptrdiff_t>(chunk) - 1) / static_cast<std::ptrdiff_t>(chunk);
    double switched = 0, strong = 0;
    std::size_t failures = 0;
    int const threads = n >= parallel_threshold ? setup.options.threads : 1;
    auto const one_chunk = [&](std::ptrdiff_t k, FaceProblems& b, double& sw, double& st, std::size_t& fail) {
      std::ptrdiff_t const begin = k * static_cast<std::ptrdiff_t>(chunk);
      std::size_t const len = static_cast<std::size_t>(std::min<std::ptrdiff_t>(chunk, count - begin));
      fail += run_faces(run, begin, len, b, out, begin);
      for (std::size_t i = 0; i < len; ++i) {
        std::ptrdiff_t const j = static_cast<std::ptrdiff_t>(i);
        double const acted = b.switched[j] > 0 ? 1.0 : 0.0;
        switch_counts[static_cast<std::size_t>(begin) + i] += acted;
        sw += acted, st += b.strong[j];
      }
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
    if (setup.left.kind == GasBoundary::Kind::periodic) out.copy_face(count - 1, out, 0);
    counters.faces += static_cast<std::uint64_t>(count);
    counters.switched += static_cast<std::uint64_t>(switched);
    counters.linear_star += static_cast<std::uint64_t>(static_cast<double>(count) - strong);
    return failures;
  }

  // ---- corrector ---------------------------------------------------------------------------------------------------

  /// Corrects the cells [begin, begin + count) into `out` at `to`; returns {worst share, signal rate}.
  std::pair<double, double> correct(double dt, std::ptrdiff_t begin, std::size_t count, GasCells& out,
                                    std::ptrdiff_t to) const noexcept {
    bool const sourced = static_cast<bool>(setup.source.mean);
    double const h = line.width();
    UpdateArguments g{.cells = count,
                      .eos = eos,
                      .mass = now.mass.data() + begin,
                      .momentum = now.momentum.data() + begin,
                      .energy = now.energy.data() + begin,
                      .f_mass = faces.mass.data() + begin,
                      .f_momentum = faces.momentum.data() + begin,
                      .f_energy = faces.energy.data() + begin,
                      .face_p = faces.p.data() + begin,
                      .area = curved ? line.area.data() + begin : nullptr,
                      .measure = plain ? nullptr : line.measure.data() + begin,
                      .inv_measure_new = line.inv_measure_new.data() + begin,
                      .src_mass = sourced ? src_mass.data() + begin : nullptr,
                      .src_momentum = src_momentum.data() + begin,
                      .src_energy = src_energy.data() + begin,
                      .inv_h = line.inv_h.data() + begin,
                      .dt = dt,
                      .lambda = dt / h,
                      .inv_width = 1.0 / h,
                      .rho_old = now.rho.data() + begin,
                      .margin_old = now.margin.data() + begin,
                      .mass_new = out.mass.data() + to,
                      .momentum_new = out.momentum.data() + to,
                      .energy_new = out.energy.data() + to,
                      .rho = out.rho.data() + to,
                      .u = out.u.data() + to,
                      .p = out.p.data() + to,
                      .K = out.K.data() + to,
                      .margin = out.margin.data() + to,
                      .worst = 1.0,
                      .rate = 0.0};
    law.update(g);
    return {g.worst, g.rate};
  }

  /// The corrector with two fluxes a face, OG (3.10): not conservative.
  std::pair<double, double> correct_with_cell_feet(double dt) {
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      double const k = dt * line.inv_h[i];
      next.mass[i] = now.mass[i] - k * (faces.mass[i + 1] - other_faces.mass[i]);
      next.momentum[i] = now.momentum[i] - k * (faces.momentum[i + 1] - other_faces.momentum[i]);
      next.energy[i] = now.energy[i] - k * (faces.energy[i + 1] - other_faces.energy[i]);
    }
    primitives(next, 0, n);
    double worst = 1.0;
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      double const share = std::min(next.rho[i] / now.rho[i], next.margin[i] / now.margin[i]);
      if (!(share >= worst)) worst = share > 0 ? share : -1.0;
    }
    return {worst, signal_rate(next, false)};
  }

  void set_sources(double dt) {
    if (!setup.source.mean) return;
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      // over the cell where it stands at half the step
      std::size_t const k = static_cast<std::size_t>(i);
      double const x0 = line.x[k] + 0.5 * dt * line.w[i], x1 = line.x[k + 1] + 0.5 * dt * line.w[i + 1];
      double const v = dt * measure_between(setup.symmetry, x0, x1);
      GasConserved<> const s = setup.source.mean(x0, x1, time, dt);
      src_mass[i] = v * s.mass, src_momentum[i] = v * s.momentum, src_energy[i] = v * s.energy;
    }
  }

  [[nodiscard]] bool bad(std::ptrdiff_t i, double share) const noexcept {
    return !(next.rho[i] > share * now.rho[i]) || !(next.margin[i] > share * now.margin[i]) ||
           !std::isfinite(next.energy[i]) || !std::isfinite(next.momentum[i]);
  }

  /// A posteriori: the faces of cells that lost nearly all of their density or pressure are redone at first order and
  /// their neighbours corrected again, until none is left or nothing more can be redone.
  void repair(FaceRun const& run, double dt) {
    std::fill(redone.begin(), redone.end(), 0);
    FaceRun first = run;
    first.predictor = PredictorKernel::godunov, first.increments = false, first.linear_star = false;
    GasFaces one(16);
    GasCells cell(16);
    bool const periodic = setup.left.kind == GasBoundary::Kind::periodic;
    std::vector<std::ptrdiff_t> touched;
    for (bool again = true; again;) {
      again = false;
      touched.clear();
      for (std::ptrdiff_t i = 0; i < cells(); ++i) {
        if (!bad(i, repair_share)) continue;
        for (std::ptrdiff_t f : {i, i + 1}) {
          if (redone[static_cast<std::size_t>(f)] != 0) continue;
          auto const redo = [&](std::ptrdiff_t face) {
            run_faces(first, face, 1, problems[0], one, 0);
            faces.copy_face(face, one, 0);
            redone[static_cast<std::size_t>(face)] = 1;
            counters.repaired += 1;
            if (face > 0) touched.push_back(face - 1);
            if (face < cells()) touched.push_back(face);
          };
          redo(f);
          if (periodic && (f == 0 || f == cells())) redo(cells() - f);
          again = true;
        }
      }
      for (std::ptrdiff_t i : touched) {
        correct(dt, i, 1, cell, 0);
        next.copy_cell(i, cell, 0);
      }
    }
  }

  /// Raises what is still not admissible to the vacuum floor; false where that does not help either.
  bool floor_vacuum() {
    bool sound = true;
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      if (!bad(i, 0.0)) continue;
      GasConserved<> const before = next.average(i);
      if (!std::isfinite(before.mass) || !std::isfinite(before.momentum) || !std::isfinite(before.energy)) return false;
      double const rho = std::max(before.mass, vacuum_density * largest_density);
      double const u = before.mass > 0 ? before.momentum / rho : 0.0;
      GasState<> s{rho, u, now.p[i]};
      double const wanted = std::max(vacuum_pressure * rho * u * u, 1e-300);
      for (int k = 0; k < 3; ++k) {
        double const margin = std::visit([&](auto const& e) { return e.pressure_margin(s.rho, s.p); }, setup.eos);
        s.p += wanted - margin;
      }
      next.mass[i] = s.rho, next.momentum[i] = s.rho * s.u, next.energy[i] = energy_density(s);
      GasCells cell(16);
      cell.mass[0] = next.mass[i], cell.momentum[0] = next.momentum[i], cell.energy[0] = next.energy[i];
      primitives(cell, 0, 1);
      next.copy_primitives(i, cell, 0);
      double const v = 1.0 / line.inv_measure_new[i];
      floor.add(v * (next.mass[i] - before.mass), v * (next.momentum[i] - before.momentum),
                v * (next.energy[i] - before.energy));
      counters.floored += 1;
      sound = sound && !bad(i, 0.0);
    }
    return sound;
  }

  // ---- the step ----------------------------------------------------------------------------------------------------

  [[nodiscard]] std::size_t first_bad() const noexcept {
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      if (bad(i, 0.0)) return static_cast<std::size_t>(i);
    }
    return 0;
  }

  double choose_dt(double t_end, double shrink) {
    double const left = t_end - time;
    double const target = shrink * setup.options.cfl;
    double dt = std::min(target / rate, left);
    if (moving) {
      // the mesh's own speed counts, and it depends on the step where the motion is prescribed
      for (int k = 0; k < 3; ++k) {
        set_face_speeds(dt);
        double const allowed = target / signal_rate(now, true);
        if (dt <= allowed) break;
        dt = allowed;
      }
    }
    if (time + dt > t_end - 1e-10 * dt) dt = left;
    if (moving) set_face_speeds(dt);
    return dt;
  }

  StepReport step(double t_end) {
    fill_ghosts(setup, line, time, now);
    double shrink = 1.0;
    StepReport report;
    for (int attempt = 0; attempt <= most_retries; ++attempt, shrink *= 0.5) {
      if (attempt > 0) counters.retried += 1;
      GasCounters const counters_before = counters;
      Accumulators const floor_before = floor;
      double const dt = choose_dt(t_end, shrink);
      report.dt = dt;
      if (!(dt > 0) || !(time + dt > time)) return {StepStatus::time_step_vanished, 0, dt};
      bool sound = line.sweep(dt);
      report.status = StepStatus::mesh_tangled;
      double new_rate = 0;
      if (sound) {
        sound = try_step(dt, new_rate);
        report.status = StepStatus::inadmissible_state;
        report.cell = sound ? 0 : first_bad();
      }
      // A step that lets signals cross more than a cell of the new state was too long (a shock forming at the start).
      bool const last_try = attempt == most_retries;
      double const limit = std::max(1.0, 1.25 * setup.options.cfl);
      if (sound && (last_try || dt * new_rate <= limit)) {
        accept(dt, new_rate);
        report.status = StepStatus::ok;
        return report;
      }
      std::uint64_t const retried = counters.retried;
      counters = counters_before, counters.retried = retried;
      floor = floor_before;
    }
    return report;
  }

  /// One attempt: everything up to the new state in `next`.
  bool try_step(double dt, double& new_rate) {
    FaceRun run{.predictor = predictor,
                .increments = set_increments(dt),
                .linear_star = setup.options.linear_star && setup.options.riemann != RiemannSolver::hllc,
                .dt = dt};
    std::size_t failures = all_faces(run, faces);
    if (setup.motion.kind == MeshMotion::Kind::lagrangian) {
      for (std::ptrdiff_t f = 0; f <= cells(); ++f) line.w[f] = faces.u[f];
      if (!line.sweep(dt)) return false;
    }
    set_sources(dt);
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

  std::pair<double, double> correct_all(double dt) {
    int const threads = n >= parallel_threshold ? setup.options.threads : 1;
    if (threads <= 1) return correct(dt, 0, n, next, 0);
    double worst = 1.0, fastest = 0.0;
    std::ptrdiff_t const size = static_cast<std::ptrdiff_t>(16 * chunk), blocks = (cells() + size - 1) / size;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(min : worst) reduction(max : fastest)
    for (std::ptrdiff_t k = 0; k < blocks; ++k) {
      std::ptrdiff_t const begin = k * size;
      auto const r = correct(dt, begin, static_cast<std::size_t>(std::min(size, cells() - begin)), next, begin);
      worst = std::min(worst, r.first), fastest = std::max(fastest, r.second);
    }
    return {worst, fastest};
  }

  void accept(double dt, double new_rate) {
    std::ptrdiff_t const last = cells();
    double const a0 = curved ? line.area[0] : 1.0, a1 = curved ? line.area[last] : 1.0;
    auto const through = [&](Padded const& f) { return dt * (a0 * f[0] - a1 * f[last]); };
    boundary.add(through(faces.mass), through(faces.momentum), through(faces.energy));
    if (curved || setup.source.mean) {
      for (std::ptrdiff_t i = 0; i < last; ++i) {
        double m = 0, q = 0, e = 0;
        if (setup.source.mean) m = src_mass[i], q = src_momentum[i], e = src_energy[i];
        if (curved) q += 0.5 * dt * (faces.p[i] + faces.p[i + 1]) * (line.area[i + 1] - line.area[i]);
        source.add(m, q, e);
      }
    }
    std::swap(now, next);
    if (moving) {
      line.advance(dt);
      rate = signal_rate(now, false);
    } else {
      rate = new_rate;
    }
    time += dt;
    counters.steps += 1;
    counters.cell_updates += n;
  }
};

GasLine::GasLine(GasLineSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
GasLine::~GasLine() = default;
GasLine::GasLine(GasLine&&) noexcept = default;
GasLine& GasLine::operator=(GasLine&&) noexcept = default;

void GasLine::set_state(std::function<GasState<>(double x)> const& state, int points) {
  std::vector<GasConserved<>> averages(impl_->n);
  for (std::size_t i = 0; i < impl_->n; ++i) {
    averages[i] = cell_average(impl_->setup.symmetry, impl_->line.x[i], impl_->line.x[i + 1], points,
                               [&](double x) -> GasConserved<> {
                                 GasState<> const s = state(x);
                                 return {s.rho, s.rho * s.u, impl_->energy_density(s)};
                               });
  }
  set_averages(averages);
}

void GasLine::set_averages(std::span<GasConserved<> const> averages, double time) {
  if (averages.size() != impl_->n) throw std::invalid_argument("one average a cell is needed");
  for (std::size_t i = 0; i < impl_->n; ++i) {
    std::ptrdiff_t const k = static_cast<std::ptrdiff_t>(i);
    impl_->now.mass[k] = averages[i].mass;
    impl_->now.momentum[k] = averages[i].momentum;
    impl_->now.energy[k] = averages[i].energy;
  }
  impl_->start(time);
}

StepReport GasLine::step(double t_end) { return impl_->step(t_end); }
std::size_t GasLine::cells() const noexcept { return impl_->n; }
double GasLine::time() const noexcept { return impl_->time; }
double GasLine::stable_dt() const noexcept { return impl_->setup.options.cfl / impl_->rate; }
std::span<double const> GasLine::faces() const noexcept { return impl_->line.x; }
std::span<double const> GasLine::density() const noexcept { return {impl_->now.rho.data(), impl_->n}; }
std::span<double const> GasLine::velocity() const noexcept { return {impl_->now.u.data(), impl_->n}; }
std::span<double const> GasLine::pressure() const noexcept { return {impl_->now.p.data(), impl_->n}; }
std::span<double const> GasLine::bulk_modulus() const noexcept { return {impl_->now.K.data(), impl_->n}; }
GasConserved<> GasLine::average(std::size_t cell) const noexcept {
  return impl_->now.average(static_cast<std::ptrdiff_t>(cell));
}
double GasLine::measure(std::size_t cell) const noexcept {
  return impl_->line.measure[static_cast<std::ptrdiff_t>(cell)];
}
std::span<double const> GasLine::switch_map() const noexcept { return impl_->switch_counts; }

GasState<> GasLine::left_face() const noexcept {
  GasFaces const& f = impl_->faces;
  return {impl_->now.rho[0], f.u[0], f.p[0]};
}
GasState<> GasLine::right_face() const noexcept {
  GasFaces const& f = impl_->faces;
  std::ptrdiff_t const last = impl_->cells();
  return {impl_->now.rho[last - 1], f.u[last], f.p[last]};
}
GasCounters const& GasLine::counters() const noexcept { return impl_->counters; }

GasLedger GasLine::ledger() const noexcept {
  Accumulators total;
  GasConserved<> magnitude{0, 0, 0};
  impl_->add_totals(total, &magnitude);
  auto const entry = [](Accumulator const& start, Accumulator const& end, Accumulator const& through,
                        Accumulator const& source, Accumulator const& floor, double scale) {
    return LedgerEntry{.initial = start.value(),
                       .current = end.value(),
                       .through_boundary = through.value(),
                       .from_source = source.value(),
                       .from_floor = floor.value(),
                       .scale = scale};
  };
  Impl const& m = *impl_;
  return {entry(m.initial.mass, total.mass, m.boundary.mass, m.source.mass, m.floor.mass,
                std::max(m.scale.mass, magnitude.mass)),
          entry(m.initial.momentum, total.momentum, m.boundary.momentum, m.source.momentum, m.floor.momentum,
                std::max(m.scale.momentum, magnitude.momentum)),
          entry(m.initial.energy, total.energy, m.boundary.energy, m.source.energy, m.floor.energy,
                std::max(m.scale.energy, magnitude.energy))};
}

GasLineSetup const& GasLine::setup() const noexcept { return impl_->setup; }

}  // namespace g27
