/// Observed orders of the one-dimensional gas schemes on smooth problems: all laws, all meshes, and what is lost
/// without each part of the predictor.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/driver/study.hpp"
#include "studies/orders/order_tables.hpp"
#include "verification/cases/media.hpp"

namespace g27 {
namespace {

struct Scheme {
  std::string name;
  CaseOptions options;
};

/// The points of (3.10) reach beyond the centre of the next cell at a larger one, where the profile ends and they are
/// clipped: the two fluxes of a face then no longer agree to second order.
constexpr double cfl_of_feet = 0.2;

Scheme scheme(std::string const& name, Predictor predictor, Switch monotonicity = Switch::off) {
  Scheme s{name, {}};
  s.options.predictor = predictor, s.options.monotonicity = monotonicity;
  return s;
}
Scheme with_feet(std::string const& name, FootPoints feet) {
  Scheme s = scheme(name, Predictor::linear);
  s.options.feet = feet, s.options.cfl = cfl_of_feet;
  return s;
}
Scheme with_feet_too_far() {
  Scheme s = with_feet("linear, corrected (3.10), CFL 0.8", FootPoints::corrected_3_10);
  s.options.cfl = 0.8;
  return s;
}
Scheme with_one_foot() {
  Scheme s = scheme("linear, one foot", Predictor::linear);
  s.options.single_foot = true;
  return s;
}

Scheme const godunov = scheme("godunov", Predictor::godunov);
Scheme const linear_off = scheme("linear, off", Predictor::linear);
Scheme const linear_graded = scheme("linear, graded", Predictor::linear, Switch::graded);
Scheme const linear_binary = scheme("linear, binary", Predictor::linear, Switch::binary);
Scheme const linear_literal = scheme("linear, literal", Predictor::linear, Switch::literal);
Scheme const parabolic_off = scheme("parabolic, off", Predictor::parabolic);
Scheme const parabolic_on = scheme("parabolic, on", Predictor::parabolic, Switch::graded);
Scheme const muscl = scheme("muscl", Predictor::muscl);
Scheme const corrected = with_feet("linear, corrected (3.10)", FootPoints::corrected_3_10);
Scheme const clipped = with_feet_too_far();
Scheme const printed = with_feet("linear, printed (3.10)", FootPoints::printed_3_10);
Scheme const one_foot = with_one_foot();

std::vector<std::string> const problems{"acoustic-1d", "entropy-1d", "simple-wave-1d", "mms-1d"};
std::vector<std::string> const nonuniform{"graded", "alternating", "random", "moving", "moving-random"};

/// Grids fine enough for the asymptotic range, coarse enough that round-off stays out of the errors and that sources
/// evaluated in every cell and step (mms) stay cheap. All even: the alternating mesh is periodic.
std::vector<int> grids(std::string const& problem, std::string const& eos, Predictor predictor) {
  if (problem == "mms-1d" && eos == "mie-gruneisen") return {56, 72, 96, 128};
  if (problem == "mms-1d" && predictor == Predictor::godunov) return {160, 224, 320, 448};
  if (problem == "mms-1d") return {112, 160, 224, 320};
  if (problem == "entropy-1d" && eos == "mie-gruneisen") return {80, 112, 160, 224, 320};
  if (problem == "acoustic-1d" && predictor == Predictor::parabolic) return {24, 32, 48, 64, 96, 128, 192};
  // from 420 cells on the exemption of smooth extrema covers the wave of 20 %: below, the bounds act on its crests
  if (problem == "entropy-1d" && predictor == Predictor::parabolic) return {448, 512, 640, 768, 896, 1024};
  if (predictor == Predictor::godunov) return {160, 224, 320, 448, 640, 896};
  return {80, 112, 160, 224, 320, 448, 640};
}

std::vector<OrderRow> all_rows() {
  std::vector<OrderRow> rows;
  auto const add = [&](std::string const& group, std::string const& problem, std::string const& eos,
                       std::string const& mesh, Scheme const& s) {
    rows.push_back({group, problem, eos, mesh, s.name, s.options, grids(problem, eos, *s.options.predictor)});
  };
  std::vector<Scheme> const schemes{godunov, linear_off, linear_graded, parabolic_off, parabolic_on};
  for (std::string const& problem : problems) {
    for (std::string const& eos : media()) {
      for (Scheme const& s : schemes) add("laws", problem, eos, "uniform", s);
      add("laws", problem, eos, "uniform", muscl);
    }
    for (std::string const& mesh : nonuniform) {
      for (Scheme const& s : schemes) add("meshes", problem, "ideal", mesh, s);
    }
    for (Scheme const& s : schemes) add("meshes", problem, "jwl", "moving", s);
    for (Scheme const& s : {linear_binary, linear_literal}) add("switches", problem, "ideal", "uniform", s);
    add("one foot", problem, "ideal", "uniform", one_foot);
  }
  for (char const* problem : {"acoustic-1d", "entropy-1d", "simple-wave-1d"}) {
    for (char const* mesh : {"graded", "alternating", "random"}) {
      for (Scheme const& s : {corrected, clipped, printed}) add("feet", problem, "ideal", mesh, s);
    }
  }
  return rows;
}

bool smooth_mesh(OrderRow const& r) { return r.mesh == "uniform" || r.mesh == "graded" || r.mesh == "moving"; }
bool parabolic(OrderRow const& r) { return r.scheme == parabolic_off.name || r.scheme == parabolic_on.name; }
/// Energy linear in pressure with coefficients that do not depend on density: means of a flow at constant pressure have
/// exactly that pressure.
bool linear_law(OrderRow const& r) { return r.eos == "ideal" || r.eos == "stiffened"; }
/// Velocity and pressure of the entropy wave are constant: what errors they have come from the others.
bool varies(OrderRow const& r, VariableOrder const& v) { return r.problem != "entropy-1d" || v.variable == "density"; }
bool linear_wave(OrderRow const& r) { return r.problem == "acoustic-1d" || r.problem == "entropy-1d"; }

/// Least ratio of the linear scheme's error to the parabolic one's on the finest grid they share, nonlinear waves.
Finding gain(std::vector<RowResult> const& results) {
  double least = std::numeric_limits<double>::infinity();
  std::string where;
  for (RowResult const& a : results) {
    for (RowResult const& b : results) {
      bool const pair = a.row.scheme == linear_graded.name && b.row.scheme == parabolic_on.name &&
                        !linear_wave(a.row) && a.row.problem == b.row.problem && a.row.eos == b.row.eos &&
                        a.row.mesh == b.row.mesh && a.row.cells.back() == b.row.cells.back();
      if (!pair || a.variables[0].errors.empty() || b.variables[0].errors.empty()) continue;
      double const ratio = a.variables[0].errors.back().l1 / b.variables[0].errors.back().l1;
      if (!(ratio >= least)) least = ratio, where = a.row.problem + " " + a.row.eos + " " + a.row.mesh;
    }
  }
  return {"parabolic, nonlinear waves, finest grid: density error at most a tenth of the linear scheme's",
          fmt::format("1/{:.0f} at worst ({})", least, where), std::isfinite(least) && least >= 10.0};
}

std::vector<Finding> judge(std::vector<RowResult> const& results) {
  std::vector<Finding> findings;
  auto const claim = [&](std::string const& text, double low, double high, Chosen const& chosen) {
    findings.push_back(order_claim(results, text, low, high, chosen));
  };
  claim("linear, switch off, smooth meshes, every law and variable: L1 order 2.00 +- 0.05", 1.95, 2.05,
        [](auto& r, auto& v) { return r.scheme == linear_off.name && smooth_mesh(r) && varies(r, v); });
  claim("linear, graded switch, smooth meshes, every law and variable: L1 order 1.9 to 2.1", 1.9, 2.1,
        [](auto& r, auto& v) { return r.scheme == linear_graded.name && smooth_mesh(r) && varies(r, v); });
  claim("linear, switch off or graded, alternating and random meshes: L1 order 2.0 +- 0.1", 1.9, 2.1,
        [](auto& r, auto& v) {
          return (r.scheme == linear_off.name || r.scheme == linear_graded.name) && !smooth_mesh(r) && varies(r, v);
        });
  claim("Godunov, every law and mesh: L1 order 1.0 +- 0.1", 0.9, 1.1,
        [](auto& r, auto& v) { return r.scheme == godunov.name && varies(r, v); });
  claim("parabolic, linear waves, every law and mesh: L1 order 2.8 to 3.2", 2.8, 3.2,
        [](auto& r, auto& v) { return parabolic(r) && varies(r, v) && linear_wave(r); });
  claim("parabolic, nonlinear waves, smooth meshes, every law: L1 order 2.8 to 3.2", 2.8, 3.2,
        [](auto& r, auto&) { return parabolic(r) && !linear_wave(r) && smooth_mesh(r); });
  claim("parabolic, nonlinear waves, alternating and random meshes: L1 order 1.9 to 3.2", 1.9, 3.2,
        [](auto& r, auto&) { return parabolic(r) && !linear_wave(r) && !smooth_mesh(r); });
  claim("MUSCL, uniform mesh, every law: L1 order 1.9 to 2.3", 1.9, 2.3,
        [](auto& r, auto& v) { return r.scheme == muscl.name && varies(r, v); });
  findings.push_back(gain(results));
  claim("corrected (3.10), CFL 0.2, every mesh: L1 order 2.0 +- 0.1", 1.9, 2.1,
        [](auto& r, auto& v) { return r.scheme == corrected.name && varies(r, v); });

  Spread const wrong =
      spread(results, [](auto& r, auto& v) { return r.scheme == printed.name && !smooth_mesh(r) && varies(r, v); });
  bool const first_order = wrong.fitted == 0 || wrong.largest <= 1.3;
  findings.push_back({"printed (3.10), alternating and random meshes: order 1.3 at most, or it fails", wrong.text(),
                      first_order && wrong.fitted + static_cast<int>(!wrong.failure.empty()) > 0});
  claim("one foot for all variables: density of the entropy and manufactured waves falls to order 1.0 +- 0.1", 0.9, 1.1,
        [](auto& r, auto& v) {
          return r.scheme == one_foot.name && (r.problem == "entropy-1d" || r.problem == "mms-1d") &&
                 v.variable == "density";
        });
  Spread const kept = spread(results, [](auto& r, auto& v) {
    return r.problem == "entropy-1d" && linear_law(r) && !varies(r, v) && r.scheme != printed.name;
  });
  findings.push_back({"ideal and stiffened gas keep velocity and pressure of the entropy wave to 1e-12 on every mesh",
                      kept.text(), kept.fitted == 0 && kept.exact > 0 && kept.failure.empty()});
  return findings;
}

StudyReport run(StudyContext const& context) {
  std::vector<RowResult> const results = measure_orders(all_rows(), context);
  return {{order_table(results), error_table(results)}, judge(results)};
}

}  // namespace

Study order_1d_study() {
  return {"order-1d", "the one-dimensional gas schemes show their order for every law and on every mesh", run};
}

}  // namespace g27
