#include "verification/cases/solid_manufactured.hpp"

#include <type_traits>
#include <variant>

#include "verification/cases/solid_problem.hpp"
#include "verification/mms/manufactured_solid.hpp"

namespace g27 {

namespace {

/// Waves of some per cent of the law's moduli around a compressed, stressed and moving state.
PeriodicSolid fields_of(SolidMedium const& m) {
  double const c = m.sound, K = bulk_modulus(m.exact.law, m.rho0, 0.0);
  double const rho = 1.05 * m.rho0;
  return {.frequency = 0.4 * c,
          .rho = rho,
          .density_wave = 0.02,
          .u = {0.05 * c, -0.03 * c, 0.02 * c},
          .velocity_wave = 0.02 * c,
          .e = energy(m.exact.law, rho, 0.06 * K),
          .energy_wave = 2e-3 * c * c,
          .S = {0.03 * K, -0.02 * K, -0.01 * K, 0.025 * K, -0.02 * K, 0.015 * K},
          .stress_wave = 0.01 * K};
}

template <std::size_t D, class Law>
SolidProblem manufactured(SolidMedium const& m, Law const& law) {
  ManufacturedSolid<D, PeriodicSolid, Law> const fields(fields_of(m), law, m.exact.mu);
  SolidProblem problem{.solid = m.scheme, .dimensions = static_cast<int>(D), .t_end = 0.5 / m.sound};
  make_periodic(problem);
  problem.source = {
      .mean = [=](Vec3 const& x, Vec3 const& h, double t, double dt) { return fields.mean_source(x, h, t, dt); },
      .primitive_rate = [=](Vec3 const& x, double t) -> SolidRate {
        SolidPoint const r = fields.primitive_rate(x, t);
        return {.rho = r.rho, .u = r.u, .p = r.p, .e = r.e, .S = r.S, .ep = 0};
      }};
  problem.initial = [=](Vec3 const& x, Vec3 const& h) { return fields.average(x, h, 0.0); };
  problem.reference = [=, t = problem.t_end](Vec3 const& x, Vec3 const& h) { return fields.average(x, h, t); };
  return problem;
}

SolidProblem manufactured(SolidMedium const& m, int dimensions) {
  return std::visit(
      [&](auto const& law) {
        return dimensions == 1   ? manufactured<1>(m, law)
               : dimensions == 2 ? manufactured<2>(m, law)
                                 : manufactured<3>(m, law);
      },
      m.exact.law);
}

}  // namespace

Case solid_manufactured_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 1 ? 128 : dimensions == 2 ? 48 : 16;
  Case out{.name = name,
           .title = "manufactured waves in all variables and directions, driven by their source terms",
           .source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4",
           .dimensions = dimensions,
           .default_cells = cells,
           .solid = true,
           .eos = solid_media(),
           .meshes = {"fixed"}};
  out.run = [=](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("steel"));
    return run_problem(name, cells, manufactured(m, dimensions), m.exact, options);
  };
  return out;
}

}  // namespace g27
