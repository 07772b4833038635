#include "verification/cases/solid_step.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "verification/cases/oblique_wave.hpp"
#include "verification/cases/solid_problem.hpp"
#include "verification/exact/elastic_riemann.hpp"

namespace g27 {

namespace {

constexpr double amplitude = 1e-6;  ///< over the speed of P waves: linear to that
constexpr double high_from = 0.25, high_to = 0.75;

struct Step {
  Vector3 n, across;
  double to_space[3][3];  ///< from the frame of the wave
  ElasticRiemann up, down;

  /// In the wave's frame at s = x.n of the period [0, 1).
  [[nodiscard]] SolidPoint at(double s, double t) const {
    s -= std::floor(s);
    double const tiny = 1e-30;
    return s < 0.5 ? up.at((s - high_from) / std::fmax(t, tiny)) : down.at((s - high_to) / std::fmax(t, tiny));
  }
  [[nodiscard]] SolidPoint in_space(Vec3 const& x, double t) const {
    SolidPoint s = at(n[0] * x[0] + n[1] * x[1] + n[2] * x[2], t);
    Vector3 u{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) u[i] += to_space[i][j] * s.u[j];
    s.u = u, s.S = turned(to_space, s.S);
    return s;
  }
};

Step step_of(SolidMedium const& m, Vector3 const& n, double normal, double shear, double stress) {
  double const K = bulk_modulus(m.exact.law, m.rho0, 0.0), T = stress * K, a = amplitude * m.sound;
  SolidPoint const low = solid_state(m, m.rho0 * (stress > 0 ? 1.05 : 1.0), {}, stress > 0 ? 0.06 * K : 0.0,
                                     {0.6 * T, -0.4 * T, -0.2 * T, 0.5 * T, -0.4 * T, 0.3 * T});
  SolidPoint high = low;
  high.u = {normal * a, shear * a, 0};
  double const flat = std::hypot(n[0], n[1]);
  Vector3 const y{-n[1] / flat, n[0] / flat, 0}, z{-n[2] * y[1], n[2] * y[0], n[0] * y[1] - n[1] * y[0]};
  Step out{.n = n,
           .across = y,
           .to_space = {},
           .up = ElasticRiemann(m.exact, low, low, high),
           .down = ElasticRiemann(m.exact, low, high, low)};
  for (std::size_t i = 0; i < 3; ++i) out.to_space[i][0] = n[i], out.to_space[i][1] = y[i], out.to_space[i][2] = z[i];
  return out;
}

/// Averages along the first axis by pieces between the jumps, across the others by midpoints: exact in one dimension.
SolidMean mean_of(std::shared_ptr<Step const> step, int dimensions, double t) {
  return [=](Vec3 const& x, Vec3 const& h) {
    int const parts = dimensions == 1 ? 1 : dimensions == 2 ? 16 : 6;
    SolidDensities sum{};
    int const deep = dimensions > 2 ? parts : 1;
    std::vector<double> jumps;
    for (int j = 0; j < parts; ++j) {
      for (int k = 0; k < deep; ++k) {
        double const y = dimensions > 1 ? x[1] + h[1] * ((j + 0.5) / parts - 0.5) : 0.0;
        double const z = dimensions > 2 ? x[2] + h[2] * ((k + 0.5) / deep - 0.5) : 0.0;
        double const rest = step->n[1] * y + step->n[2] * z, a = x[0] - 0.5 * h[0], b = x[0] + 0.5 * h[0];
        jumps.clear();
        double const from = std::floor(step->n[0] * a + rest);
        for (double period : {from - 1, from, from + 1}) {
          for (double ray : step->up.rays()) jumps.push_back((period + high_from + ray * t - rest) / step->n[0]);
          for (double ray : step->down.rays()) jumps.push_back((period + high_to + ray * t - rest) / step->n[0]);
          jumps.push_back((period + 0.5 - rest) / step->n[0]);
          jumps.push_back((period - rest) / step->n[0]);
        }
        std::sort(jumps.begin(), jumps.end());
        SolidDensities const q = solid_average([&](double s) { return step->in_space({s, y, z}, t); }, a, b, jumps, 1);
        double const weight = 1.0 / (parts * deep);
        sum.mass += weight * q.mass, sum.energy += weight * q.energy;
        for (std::size_t i = 0; i < 3; ++i) sum.momentum[i] += weight * q.momentum[i];
        for (std::size_t c = 0; c < 6; ++c) sum.rho_S[c] += weight * q.rho_S[c];
      }
    }
    return sum;
  };
}

/// Beyond the range of the exact velocity, over the step.
void measure(Step const& step, double normal, double shear, double c, SolidGrid const& grid, CaseResult& r) {
  auto const beyond = [&](Vector3 const& e) {
    double low = 1e300, high = -1e300, least = 1e300, most = -1e300;
    for (int i = 0; i < 4000; ++i) {
      SolidPoint const s = step.in_space({(i + 0.5) / 4000 / step.n[0], 0, 0}, grid.time());
      double const v = e[0] * s.u[0] + e[1] * s.u[1] + e[2] * s.u[2];
      low = std::fmin(low, v), high = std::fmax(high, v);
    }
    Int3 const n = grid.cells();
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i) {
          Vec3 const u = grid.primitive({i, j, k}).u;
          double const v = e[0] * u[0] + e[1] * u[1] + e[2] * u[2];
          least = std::fmin(least, v), most = std::fmax(most, v);
        }
      }
    }
    return std::fmax(0.0, std::fmax(most - high, low - least)) / (std::hypot(normal, shear) * amplitude * c);
  };
  r.facts["overshoot_normal"] = beyond(step.n);
  r.facts["overshoot_shear"] = beyond(step.across);
}

}  // namespace

Case solid_step_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 1 ? 200 : dimensions == 2 ? 128 : 36;
  Case out{.name = name,
           .title = "square wave of the velocity along and across its normal, before its steps meet",
           .source = "exact Riemann problem of linear elasticity: verification/exact/elastic_riemann.hpp",
           .dimensions = dimensions,
           .default_cells = cells,
           .solid = true,
           .eos = solid_media(),
           .meshes = {"fixed"},
           .parameters = {{"normal", 1, "1", "part of the step along the normal", -1, 1},
                          {"shear", 1, "1", "part of the step across it", -1, 1},
                          {"stress", 0, "1", "pre-stress over the bulk modulus", -0.1, 0.1}}};
  out.run = [=, parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("steel"));
    ObliqueBox const box = dimensions == 1 ? ObliqueBox{{1, 0, 0}, {1, 1, 1}} : oblique_box(dimensions);
    double const normal = value_of(parameters, options, "normal"), shear = value_of(parameters, options, "shear");
    if (normal == 0 && shear == 0) throw std::invalid_argument("normal and shear are both 0: there is no step");
    auto const step =
        std::make_shared<Step const>(step_of(m, box.normal, normal, shear, value_of(parameters, options, "stress")));
    SolidProblem problem{.solid = m.scheme, .dimensions = dimensions, .upper = box.upper};
    make_periodic(problem);
    problem.t_end = 0.2 / step->up.speeds()[0];
    problem.initial = mean_of(step, dimensions, 0), problem.reference = mean_of(step, dimensions, problem.t_end);
    problem.measure = [=](SolidGrid const& grid, CaseResult& r) { measure(*step, normal, shear, m.sound, grid, r); };
    return run_problem(name, cells, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
