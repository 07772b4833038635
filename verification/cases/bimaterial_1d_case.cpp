/// A small smooth wave that crosses the bonded face of two solids: reflected and transmitted, of one family or, under
/// pre-stress, of all three.
#include <cmath>
#include <memory>
#include <numbers>

#include "verification/cases/bonded_problem.hpp"
#include "verification/exact/bonded_wave.hpp"

namespace g27 {

namespace {

constexpr double centre = -0.5, half_width = 0.4;  ///< of the pulse [m]; each solid is 1 m long
/// Of the velocity over the speed of P waves: the reference is linear, and off by this part of the wave; the round-off
/// of the positions is 1e-7 of it.
constexpr double amplitude = 1e-6;

/// States of one traction and no velocity; all six stresses where there is any.
std::pair<SolidPoint, SolidPoint> bases(SolidMedium const& l, SolidMedium const& r, double stress) {
  double const T = stress * bulk_modulus(r.exact.law, r.rho0, 0.0), p_l = T, p_r = 0.8 * T;
  auto const state = [](SolidMedium const& m, double p, Tensor6 const& S) {
    return solid_state(m, m.rho0 * (1 + p / bulk_modulus(m.exact.law, m.rho0, 0.0)), {}, p, S);
  };
  return {state(l, p_l, {0.6 * T, -0.4 * T, -0.2 * T, 0.5 * T, -0.4 * T, 0.3 * T}),
          state(r, p_r, {0.4 * T, -0.1 * T, -0.3 * T, 0.5 * T, -0.4 * T, -0.2 * T})};
}

SolidBoundary held(SolidPoint const& base) {
  return {.kind = SolidBoundary::Kind::traction, .traction = [=](Vec3 const&, double) -> Vec3 {
            return {base.stress(0, 0), base.stress(0, 1), base.stress(0, 2)};
          }};
}

}  // namespace

Case bimaterial_1d_case() {
  Case out{.name = "bimaterial-1d",
           .title = "P or S wave that crosses the bonded face of two solids",
           .source = "exact linear reflection and transmission: verification/exact/bonded_wave.hpp",
           .dimensions = 1,
           .default_cells = 200,
           .solid = true,
           .eos = bonded_pairs(),
           .meshes = {"lagrangian"},
           .parameters = {
               {"family", 0, "1", "of the incoming wave: 0 P, 1 and 2 S by falling speed", 0, 2, true},
               {"stress", 0, "1", "scale of the pre-stress, over the bulk modulus of the solid on the right", 0, 0.1}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    auto const [l, r] = bonded_media(options.eos.value_or("steel-aluminium"), false);
    double const family = value_of(parameters, options, "family");
    if (family != 0 && family != 1 && family != 2) throw std::invalid_argument("family is 0, 1 or 2");
    auto const [base_l, base_r] = bases(l, r, value_of(parameters, options, "stress"));
    auto const profile = [a = amplitude * l.sound](double x) {
      double const y = (x - centre) / half_width;
      return std::fabs(y) < 1 ? a * std::pow(std::cos(0.5 * std::numbers::pi * y), 6) : 0.0;
    };
    auto const exact =
        std::make_shared<BondedWave>(l.exact, base_l, r.exact, base_r, static_cast<std::size_t>(family), profile);
    BondedProblem problem{.left = {.medium = l, .outer = held(base_l)}, .right = {.medium = r, .outer = held(base_r)}};
    // the fastest wave that the front of the pulse causes at the bonded face stays inside
    double const fastest = std::fmax(exact->left_families().speeds()[0], exact->right_families().speeds()[0]);
    double const c = exact->left_families().speeds()[static_cast<std::size_t>(family)];
    problem.t_end = 0.95 / fastest - (centre + half_width) / c;
    auto const left = [=](double t) {
      return
          [=](double a, double b) { return solid_average([&](double x) { return exact->left(x, t); }, a, b, {}, 5); };
    };
    auto const right = [=](double t) {
      return
          [=](double a, double b) { return solid_average([&](double x) { return exact->right(x, t); }, a, b, {}, 5); };
    };
    problem.left.initial = left(0), problem.left.reference = left(problem.t_end);
    problem.right.initial = right(0), problem.right.reference = right(problem.t_end);
    problem.contact = [=](double t) { return exact->right(0, t); };
    CaseResult result = run_problem("bimaterial-1d", 200, problem, options);
    result.eos = options.eos.value_or("steel-aluminium");
    return result;
  };
  return out;
}

}  // namespace g27
