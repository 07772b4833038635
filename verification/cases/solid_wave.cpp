#include "verification/cases/solid_wave.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "verification/cases/oblique_wave.hpp"
#include "verification/exact/plane_wave.hpp"

namespace g27 {

namespace {

using Loading = SolidWaveCase::Loading;
using Sides = SolidWaveCase::Sides;

/// Compressed, so that the pressure is positive, moving along all axes; all six stresses where there is any.
SolidPoint elastic_base(SolidMedium const& m, SolidWaveCase const& c) {
  // a fixed side gives no density to what flows in
  double const flow = c.sides == Sides::periodic ? m.sound : 0.0, K = bulk_modulus(m.exact.law, m.rho0, 0.0);
  double const T = c.stress * K;
  Tensor6 const S{0.6 * T, -0.4 * T, -0.2 * T, 0.5 * T, -0.4 * T, 0.3 * T};
  return solid_state(m, m.rho0 * (c.stress > 0 ? 1.05 : 1.0), {0.025 * flow, -0.013 * flow, 0.01 * flow},
                     c.stress > 0 ? 0.06 * K : 0.0, S);
}

/// On the yield surface: compressed along n, or sheared across it as well.
SolidPoint yielding_base(SolidMedium const& m, SolidWaveCase const& c, Vector3 const& n) {
  Vector3 const across =
      n[0] < 0.99 ? Vector3{-n[1] / std::hypot(n[0], n[1]), n[0] / std::hypot(n[0], n[1]), 0} : Vector3{0, 1, 0};
  double const shear = c.loading == Loading::sheared ? 0.7 : 0.0;
  Tensor6 S{};
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      double const s = -n[i] * n[j] + (i == j ? 1.0 / 3 : 0.0) + shear * (n[i] * across[j] + n[j] * across[i]);
      S[tensor_place[i][j]] = s, squares += (i == j ? 1.5 : 3.0) * s * s;
    }
  }
  for (double& s : S) s *= m.exact.yield / std::sqrt(squares);
  return solid_state(m, m.rho0, {}, 0, S);
}

/// Elastic waves of finite amplitude may be of any family.
std::vector<CaseParameter> parameters_of(SolidWaveCase const& c) {
  if (c.stress == 0 || c.loading != Loading::elastic) return {};
  return {{"family", static_cast<double>(c.family), "1", "of the wave: 0 P, 1 and 2 S by falling speed", 0, 2}};
}

int family_of(SolidWaveCase const& c, CaseOptions const& options) {
  std::vector<CaseParameter> const parameters = parameters_of(c);
  if (parameters.empty()) return c.family;
  double const family = value_of(parameters, options, "family");
  if (family != 0 && family != 1 && family != 2) throw std::invalid_argument("family is 0, 1 or 2");
  return static_cast<int>(family);
}

Case made_of(SolidWaveCase const& c, int cells) {
  return {.name = c.name,
          .title = c.title,
          .source = "exact simple wave by its ordinary differential equation: verification/exact/plane_wave.hpp",
          .dimensions = c.dimensions,
          .default_cells = cells,
          .solid = true,
          .eos = c.loading == Loading::elastic ? solid_media() : std::vector<std::string>{"steel"},
          .meshes = {"fixed"},
          .parameters = parameters_of(c)};
}

}  // namespace

Case solid_wave_case(SolidWaveCase const& c) {
  int const cells = c.dimensions == 1 ? 200 : c.dimensions == 2 ? 64 : 40;
  Case out = made_of(c, cells);
  out.run = [=](CaseOptions const& options) {
    bool const loads = c.loading != Loading::elastic;
    SolidMedium const m = solid_medium(options.eos.value_or("steel"), loads);
    ObliqueBox const box = c.dimensions == 1   ? ObliqueBox{{1, 0, 0}, {1, 1, 1}}
                           : c.dimensions == 2 ? oblique_box(2)
                                               : uneven_box();
    Vec3 const n = box.normal;
    double const span = n[0] * box.upper[0] + (c.dimensions > 1 ? n[1] * box.upper[1] + n[2] * box.upper[2] : 0.0);
    double const a = c.amplitude * m.sound, k = 2 * std::numbers::pi;
    SolidPoint const ahead = loads ? yielding_base(m, c, n) : elastic_base(m, c);
    // a step whose slope falls below round-off of the state towards the sides of the box
    auto const profile = [=](double s) {
      return loads ? 0.5 * a * std::erfc((s - 0.4 * span) / (0.08 * span)) : a * std::sin(k * s);
    };
    auto const wave =
        std::make_shared<PlaneWave>(m.exact, ahead, n, family_of(c, options), loads ? 0.0 : -a, a, profile, loads);
    SolidProblem problem{.solid = m.scheme, .dimensions = c.dimensions, .upper = box.upper};
    problem.t_end = (loads ? 0.2 * span : 1.0) / wave->speed(0);
    auto const state = [=](Vec3 const& x, double t) { return wave->state_at(x, t); };
    make_periodic(problem);
    for (std::size_t side = 0; side < 2 * static_cast<std::size_t>(c.dimensions); ++side) {
      SolidBoundary& b = problem.sides[side];
      if (loads) {
        b = solid_inflow(state);
      } else if (c.sides == Sides::fixed) {
        b = {.kind = SolidBoundary::Kind::fixed, .velocity = [=](Vec3 const& x, double t) { return state(x, t).u; }};
      } else if (c.sides == Sides::wall) {
        b = {.kind = SolidBoundary::Kind::wall,
             .normal_velocity = [=](Vec3 const& x, double t) { return state(x, t).u[side / 2]; }};
      } else if (c.sides == Sides::traction) {
        b = {.kind = SolidBoundary::Kind::traction, .traction = [=](Vec3 const& x, double t) -> Vec3 {
               SolidPoint const s = state(x, t);
               return {s.stress(0, side / 2), s.stress(1, side / 2), s.stress(2, side / 2)};
             }};
      }
    }
    auto const at = [=, dims = c.dimensions](double t) {
      auto const w = std::make_shared<PlaneWaveAt>(*wave, 0.0, span, t);
      return solid_mean(dims, [=](Vec3 const& x) {
        return wave->state((*w)(x[0] * n[0] + (dims > 1 ? x[1] * n[1] + x[2] * n[2] : 0.0)));
      });
    };
    problem.initial = at(0.0), problem.reference = at(problem.t_end);
    return run_problem(c.name, cells, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
