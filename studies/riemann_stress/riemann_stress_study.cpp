/// A million Riemann problems between every ordered pair of equations of state.
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "riemann/eos/registry.hpp"
#include "riemann/gas/exact.hpp"
#include "studies/driver/study.hpp"

namespace g27 {
namespace {

constexpr int problems_per_pair = 62500;  // 16 pairs: 10^6
constexpr double jump_tolerance = 1e-10;

double log_between(double low, double high, double x) { return low * std::pow(high / low, x); }

/// Admissible states, x and y in [0, 1]: eight decades of pressure, cold and hot, dense and dilute.
GasState<> draw(IdealGas const&, double x, double y) {
  return {log_between(1e-3, 1e3, x), 0.0, log_between(1e1, 1e9, y)};
}
GasState<> draw(StiffenedGas const& eos, double x, double y) {
  return {log_between(1e0, 1e4, x), 0.0, eos.p_inf * (log_between(1e-4, 1e4, y) - 1.0)};
}
GasState<> draw(Jwl const& eos, double x, double y) {
  double const rho = eos.rho0 * log_between(1e-3, 2.0, x);
  return {rho, 0.0, eos.cold_pressure(rho) + log_between(1e4, 1e12, y)};
}
GasState<> draw(MieGruneisen const& eos, double x, double y) {
  double const densest = eos.rho0 / (1.0 - 0.9 / eos.s), rho = log_between(0.2 * eos.rho0, densest, x);
  return {rho, 0.0, eos.cold_pressure(rho) + eos.rho0 * eos.c0 * eos.c0 * log_between(1e-6, 1e2, y)};
}

template <class L, class R>
struct Problem {
  GasState<> left, right;
};

/// Relative velocity of one of four kinds: impact, tube, expansion, the neighbourhood of the vacuum on both sides.
template <class L, class R>
double relative_velocity(L const& l, R const& r, GasState<> const& left, GasState<> const& right, double kind,
                         double x) {
  exact::Problem<double, L, R> problem(l, r, left, right);
  double const c = problem.curve_l.sound_speed() + problem.curve_r.sound_speed();
  if (kind < 0.25) {
    return -c * log_between(1e-8, 1e4, x);
  }
  if (kind < 0.5) {
    return c * 1e-3 * (x - 0.5);
  }
  double const escape = -exact::Problem<double, L, R>::at_vacuum(problem.curve_l, problem.offset_l, true).jump -
                        exact::Problem<double, L, R>::at_vacuum(problem.curve_r, problem.offset_r, true).jump;
  if (kind < 0.75) {
    return escape * x;
  }
  double const away = log_between(1e-14, 1.0, x < 0.5 ? 2.0 * x : 2.0 * x - 1.0);
  return x < 0.5 ? escape - std::fabs(escape) * away : escape + std::fabs(escape) * away;
}

/// Largest violation of the jump conditions across the shock from k to (rho, p), free of the frame: velocity jump
/// against sqrt(dp dv) over `speed`, mass through the shock at `front`, and energy (Hugoniot) over its terms and over
/// K/(Gamma rho), what a change of ln(rho) makes of e: near the limit of compression of a Mie-Grueneisen solid the
/// rounding of rho alone violates the condition by more than its terms' round-off.
template <class E>
double jump_residual(E const& eos, GasState<> const& k, double rho, double p, double u, double front, double speed) {
  double const dv = 1.0 / k.rho - 1.0 / rho, e = eos.energy(rho, p), e_k = eos.energy(k.rho, k.p);
  double const work = 0.5 * (p + k.p) * dv;
  double const velocity = std::fabs(std::fabs(u - k.u) - std::sqrt(std::max((p - k.p) * dv, 0.0))) / speed;
  double const terms = std::fabs(e) + std::fabs(e_k) + (std::fabs(p) + std::fabs(k.p)) / k.rho;
  double const slope = eos.bulk_modulus(rho, p) / (eos.gruneisen(rho) * rho);
  double const energy = std::fabs(e - e_k - work) / (terms + slope);
  double const mass =
      std::fabs(k.rho * (k.u - front) - rho * (u - front)) / ((k.rho + rho) * (speed + std::fabs(front)));
  return std::max({velocity, energy, mass});
}

struct PairResult {
  int failures = 0, vacua = 0;
  double residual = 0, jump = 0, iterations = 0, most_iterations = 0, seconds = 0;
};

template <class L, class R>
PairResult run_pair(L const& l, R const& r, gsl_qrng* sequence) {
  std::vector<Problem<L, R>> problems(problems_per_pair);
  std::vector<RiemannStar<>> stars(problems_per_pair);
  for (auto& problem : problems) {
    std::array<double, 6> x{};
    gsl_qrng_get(sequence, x.data());
    problem = {draw(l, x[0], x[1]), draw(r, x[2], x[3])};
    double const du = relative_velocity(l, r, problem.left, problem.right, x[4], x[5]);
    problem.left.u = -0.5 * du;
    problem.right.u = 0.5 * du;
  }
  auto const start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < problems.size(); ++i) {
    stars[i] = exact_star(l, r, problems[i].left, problems[i].right, true);
  }
  PairResult result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (std::size_t i = 0; i < problems.size(); ++i) {
    auto const& [left, right] = problems[i];
    RiemannStar<> const& s = stars[i];
    bool const sound = s.converged && std::isfinite(s.p) && std::isfinite(s.u) && s.rho_l >= 0.0 && s.rho_r >= 0.0;
    result.failures += !sound;
    result.vacua += s.vacuum;
    result.residual = std::max(result.residual, s.residual);
    result.iterations += s.iterations / problems_per_pair;
    result.most_iterations = std::max(result.most_iterations, s.iterations);
    double const speed = std::sqrt(l.bulk_modulus(left.rho, left.p) / left.rho) +
                         std::sqrt(r.bulk_modulus(right.rho, right.p) / right.rho) + std::fabs(right.u - left.u);
    if (s.shock_l) {
      result.jump = std::max(result.jump, jump_residual(l, left, s.rho_l, s.p, s.u_l, s.head_l, speed));
    }
    if (s.shock_r) {
      result.jump = std::max(result.jump, jump_residual(r, right, s.rho_r, s.p, s.u_r, s.head_r, speed));
    }
  }
  return result;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "pairs",
              .title = "exact Riemann solver, Sobol sequence of problems",
              .columns = {{"left", "1"},
                          {"right", "1"},
                          {"problems", "1"},
                          {"failures", "1"},
                          {"residual", "1"},
                          {"jump_residual", "1"},
                          {"vacuum_share", "1"},
                          {"iterations", "1"},
                          {"most_iterations", "1"},
                          {"time_per_solve", "s"}},
              .rows = {},
              .facts = {}};
  std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(gsl_qrng_alloc(gsl_qrng_sobol, 6), gsl_qrng_free);
  PairResult worst;
  std::size_t done = 0;
  EosList::for_each([&]<class L>() {
    EosList::for_each([&]<class R>() {
      if (context.progress) {
        context.progress(static_cast<double>(done) / (EosList::size * EosList::size),
                         std::string(L::name) + " against " + R::name);
      }
      PairResult const pair = run_pair(L{}, R{}, sequence.get());
      table.rows.push_back({std::string(L::name), std::string(R::name), long{problems_per_pair},
                            static_cast<long>(pair.failures), pair.residual, pair.jump,
                            static_cast<double>(pair.vacua) / problems_per_pair, pair.iterations, pair.most_iterations,
                            pair.seconds / problems_per_pair});
      worst.failures += pair.failures;
      worst.vacua += pair.vacua;
      worst.residual = std::max(worst.residual, pair.residual);
      worst.jump = std::max(worst.jump, pair.jump);
      worst.seconds += pair.seconds;
      ++done;
    });
  });
  long const total = problems_per_pair * static_cast<long>(done);
  table.facts = {{"problems", total}, {"seconds in the solver", worst.seconds}};
  return {{table},
          {{"no problem fails", std::to_string(worst.failures) + " of " + std::to_string(total), worst.failures == 0},
           {"velocities beside the contact agree to 1e-12 of c_l + c_r + |du|", number(worst.residual),
            worst.residual <= exact_tolerance},
           {"jump conditions hold to 1e-10 across every shock", number(worst.jump), worst.jump <= jump_tolerance},
           {"vacuum and its neighbourhood are in the sample",
            number(100.0 * worst.vacua / static_cast<double>(total)) + " %", worst.vacua > total / 100}}};
}

}  // namespace

Study riemann_stress_study() {
  return {"riemann-stress",
          "the exact Riemann solver solves every admissible problem between any two equations of state, to round-off",
          run};
}

}  // namespace g27
