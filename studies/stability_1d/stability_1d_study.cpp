/// Largest stable CFL number of each one-dimensional scheme, by bisection: round-off-like noise on uniform flow (what a
/// von Neumann analysis would say) and shock tubes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/media.hpp"

namespace g27 {
namespace {

constexpr int lowest = 50, highest = 160, recommended = 80;  ///< CFL number in hundredths
constexpr int noise_cells = 100, noise_steps = 800;
constexpr double noise_amplitude = 1e-8;
constexpr double allowed_growth = 1.01;  // of the noise's energy in the second half: one of 1e-5 a step is seen
constexpr double allowed_peak = 2.0;     // of the noise's energy over the initial one, ever
constexpr int tube_cells = 200;
constexpr double allowed_overshoot = 0.02;
constexpr double allowed_error = 1.5;  ///< times the error at the lowest CFL number
constexpr int allowed_retries = 3;     ///< steps redone while the first waves form; more: the step is too long

struct Scheme {
  std::string name;
  Predictor predictor;
  Switch monotonicity;
  bool tubes;  ///< without its switch a scheme rings on shocks at every CFL number
};

std::vector<Scheme> const schemes{{"godunov", Predictor::godunov, Switch::off, true},
                                  {"linear, off", Predictor::linear, Switch::off, false},
                                  {"linear, binary", Predictor::linear, Switch::binary, true},
                                  {"linear, graded", Predictor::linear, Switch::graded, true},
                                  {"parabolic, off", Predictor::parabolic, Switch::off, false},
                                  {"parabolic, on", Predictor::parabolic, Switch::graded, true},
                                  {"muscl", Predictor::muscl, Switch::graded, true}};

/// What a run at one CFL number gave; `trouble` says why it counts as unstable, empty when stable.
struct Trial {
  std::string trouble;
  double figure = 0;  ///< growth of the noise's energy, or overshoot of density
};

// ---- noise ---------------------------------------------------------------------------------------------------------

/// Integral of the squares of the three characteristic fields: a stable scheme lets none of them grow, whereas the sum
/// of the squares of density, velocity and pressure goes up and down as waves pass each other.
double noise_energy(GasLine const& line, GasState<> const& base, double sound) {
  double energy = 0, K = base.rho * sound * sound;
  for (std::size_t i = 0; i < line.cells(); ++i) {
    double const rho = line.density()[i] / base.rho - 1.0, u = (line.velocity()[i] - base.u) / sound,
                 p = (line.pressure()[i] - base.p) / K;
    energy += line.measure(i) * (0.5 * (p + u) * (p + u) + 0.5 * (p - u) * (p - u) + (rho - p) * (rho - p));
  }
  return energy;
}

/// On a periodic line, or from the axis or centre to a wall.
Trial noise(Scheme const& s, Symmetry symmetry, double mach, double cfl) {
  Medium const m = medium("ideal");
  GasState<> const base{m.base.rho, mach * m.sound, m.base.p};
  GasLineSetup setup{.eos = m.eos};
  for (int i = 0; i <= noise_cells; ++i) setup.faces.push_back(static_cast<double>(i) / noise_cells);
  setup.symmetry = symmetry;
  setup.left.kind = setup.right.kind =
      symmetry == Symmetry::planar ? GasBoundary::Kind::periodic : GasBoundary::Kind::wall;
  setup.options.predictor = s.predictor, setup.options.monotonicity = s.monotonicity, setup.options.cfl = cfl;
  GasLine line(std::move(setup));
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> uniform(-noise_amplitude, noise_amplitude);
  line.set_state(
      [&](double) -> GasState<> {
        return {base.rho * (1.0 + uniform(generator)), base.u + m.sound * uniform(generator),
                base.p + base.rho * m.sound * m.sound * uniform(generator)};
      },
      1);
  double const start = noise_energy(line, base, m.sound);
  double half = 0;
  for (int k = 0; k < noise_steps; ++k) {
    if (k == noise_steps / 2) half = noise_energy(line, base, m.sound);
    if (line.step(1e30).status != StepStatus::ok) return {"a step failed", std::numeric_limits<double>::infinity()};
    double const now = noise_energy(line, base, m.sound) / start;
    if (!(now <= allowed_peak)) return {"noise grows", now};
  }
  double const growth = noise_energy(line, base, m.sound) / half;
  if (line.counters().retried > static_cast<std::uint64_t>(allowed_retries)) return {"steps redone", growth};
  return {growth <= allowed_growth ? "" : "noise grows", growth};
}

// ---- shock tubes ---------------------------------------------------------------------------------------------------

CaseResult tube_run(Case const& tube, Scheme const& s, double cfl) {
  CaseOptions options;
  options.cells = tube_cells, options.predictor = s.predictor, options.monotonicity = s.monotonicity, options.cfl = cfl;
  return tube.run(options);
}

Trial tube_trial(Case const& tube, Scheme const& s, double cfl, double error_at_lowest) {
  CaseResult r;
  try {
    r = tube_run(tube, s, cfl);
  } catch (std::runtime_error const&) {
    return {"a step failed", std::numeric_limits<double>::infinity()};
  }
  double const overshoot = r.overshoot.at("density");
  std::string trouble;
  if (!(r.errors.at("density").l1 <= allowed_error * error_at_lowest)) trouble = "error";
  if (!(overshoot <= allowed_overshoot)) trouble = "overshoot";
  if (r.counters.floored > 0) trouble = "floors";
  if (r.counters.retried > static_cast<std::uint64_t>(allowed_retries)) trouble = "steps redone";
  return {trouble, overshoot};
}

// ---- the limit -----------------------------------------------------------------------------------------------------

struct Limit {
  int cfl = 0;             ///< largest stable one, hundredths; 0: not even the lowest is
  bool bracketed = false;  ///< a larger one was seen to fail
  std::string trouble;     ///< what happens a hundredth above
  Trial at_recommended;
};

Limit find_limit(std::function<Trial(double cfl)> const& trial) {
  Limit limit;
  limit.at_recommended = trial(0.01 * recommended);
  Trial const low = trial(0.01 * lowest);
  if (!low.trouble.empty()) return {0, true, low.trouble, limit.at_recommended};
  Trial const high = trial(0.01 * highest);
  if (high.trouble.empty()) return {highest, false, "", limit.at_recommended};
  limit.bracketed = true, limit.trouble = high.trouble;
  int stable = lowest, unstable = highest;
  while (unstable - stable > 1) {
    int const middle = (stable + unstable) / 2;
    Trial const t = trial(0.01 * middle);
    if (t.trouble.empty()) {
      stable = middle;
    } else {
      unstable = middle, limit.trouble = t.trouble;
    }
  }
  limit.cfl = stable;
  return limit;
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "limits",
              .title = "largest stable CFL number, to 0.01",
              .columns = {{"scheme", "1"},
                          {"problem", "1"},
                          {"cfl_limit", "1"},
                          {"beyond", "1"},
                          {"stable_at_0.8", "1"},
                          {"figure_at_0.8", "1"}},
              .rows = {},
              .facts = {{"cells, noise", long{noise_cells}},
                        {"steps, noise", long{noise_steps}},
                        {"amplitude of the noise", noise_amplitude},
                        {"cells, tubes", long{tube_cells}}}};
  std::vector<Case> tubes;
  for (Case& c : all_cases()) {
    for (char const* name : {"sod", "toro3", "toro4", "shu-osher"}) {
      if (c.name == name) tubes.push_back(std::move(c));
    }
  }
  std::vector<Finding> findings;
  int least_noise = highest, largest_noise = 0;
  std::string curved;
  bool curved_stable = true;
  double done = 0;
  for (Scheme const& s : schemes) {
    int least = highest;
    std::string where = "none", unstable;
    auto const record = [&](std::string const& problem, Limit const& limit) {
      table.rows.push_back({s.name, problem, 0.01 * limit.cfl, limit.bracketed ? limit.trouble : "stable",
                            limit.at_recommended.trouble.empty() ? std::string("yes") : limit.at_recommended.trouble,
                            limit.at_recommended.figure});
      if (limit.cfl < least) least = limit.cfl, where = problem;
      if (!limit.at_recommended.trouble.empty()) unstable += " " + problem + ": " + limit.at_recommended.trouble + ";";
    };
    if (context.progress) context.progress(done / static_cast<double>(schemes.size()), s.name);
    for (double const mach : {0.0, 0.3, 1.0, 3.0}) {
      Limit const limit = find_limit([&](double cfl) { return noise(s, Symmetry::planar, mach, cfl); });
      least_noise = std::min(least_noise, limit.cfl), largest_noise = std::max(largest_noise, limit.cfl);
      record(fmt::format("noise, Mach {:g}", mach), limit);
    }
    for (Case const& tube : tubes) {
      if (!s.tubes) continue;
      double const reference = tube_run(tube, s, 0.01 * lowest).errors.at("density").l1;
      record(tube.name, find_limit([&](double cfl) { return tube_trial(tube, s, cfl, reference); }));
    }
    findings.push_back({s.name + ": stable at CFL 0.8 on every planar problem",
                        (unstable.empty() ? "stable" : "unstable at 0.8:" + unstable) +
                            fmt::format(", least limit {:.2f} ({})", 0.01 * least, where),
                        unstable.empty()});
    least = highest, unstable.clear();
    record("noise, cylinder", find_limit([&](double cfl) { return noise(s, Symmetry::cylindrical, 0.0, cfl); }));
    record("noise, sphere", find_limit([&](double cfl) { return noise(s, Symmetry::spherical, 0.0, cfl); }));
    curved += fmt::format("{} {:.2f} ({}), ", s.name, 0.01 * least, where);
    curved_stable = curved_stable && unstable.empty();
    done += 1;
  }
  curved.resize(curved.size() - 2);
  findings.push_back(
      {"at the axis and at the centre every scheme is stable at CFL 0.8", "least limits: " + curved, curved_stable});
  findings.push_back({"on uniform flow the limit of every scheme is that of the exact solution, 1.00 +- 0.02",
                      fmt::format("{:.2f} to {:.2f}", 0.01 * least_noise, 0.01 * largest_noise),
                      least_noise >= 98 && largest_noise <= 102});
  return {{table}, findings};
}

}  // namespace

Study stability_1d_study() {
  return {"stability-1d",
          "CFL 0.8 is stable for every one-dimensional gas scheme, on noise and on shock tubes, in every symmetry",
          run};
}

}  // namespace g27
