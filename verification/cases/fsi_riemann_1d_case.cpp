/// Gas of one state against steel of one state: a shock or an expansion in the gas, elastic and plastic waves in the
/// steel, exact at all times.
#include <cmath>
#include <memory>

#include "verification/cases/fsi_problem.hpp"
#include "verification/cases/media.hpp"
#include "verification/cases/solid_media.hpp"
#include "verification/exact/gas_solid.hpp"

namespace g27 {

namespace {

constexpr double length = 0.1;  ///< of the solid [m]

struct Pair {
  AnyEos scheme;
  ExactEos exact;
};

Pair gas_law(std::string const& name) {
  if (name == "ideal") return {IdealGas{}, IdealLaw{}};
  Medium const m = medium(name);
  return {m.eos, m.exact};
}

}  // namespace

Case fsi_riemann_1d_case() {
  Case out{
      .name = "fsi-riemann-1d",
      .title = "detonation products against steel that yields: shock reflected, elastic and plastic waves",
      .source =
          "exact contact of verification/exact/gas_solid.hpp; Chapman-Jouguet state of the products at 1650 kg/m^3",
      .dimensions = 1,
      .default_cells = 800,
      .eos = {"jwl", "ideal", "stiffened"},
      .meshes = fsi_meshes(),
      .parameters = {{.name = "density", .value = 2198.643, .unit = "kg/m^3", .what = "of the gas"},
                     {.name = "velocity",
                      .value = 1893.214,
                      .unit = "m/s",
                      .what = "of the gas, against the solid",
                      .least = -5e3,
                      .most = 5e4},
                     {.name = "pressure", .value = 23.70e9, .unit = "Pa", .what = "of the gas"},
                     {.name = "yields",
                      .value = 1,
                      .unit = "1",
                      .what = "the steel: 1 yes, 0 elastic",
                      .least = 0,
                      .most = 1,
                      .whole = true}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    auto const value = [&](char const* name) { return value_of(parameters, options, name); };
    Pair const law = gas_law(options.eos.value_or("jwl"));
    GasState<> const gas{value("density"), value("velocity"), value("pressure")};
    SolidMedium const m = solid_medium("steel", value("yields") != 0);
    SolidPoint const rest = axial_state(m.exact, m.rho0, 0, 0);
    bool const sound =
        gas.rho > 0 && std::visit([&](auto const& e) { return e.pressure_margin(gas.rho, gas.p); }, law.scheme) > 0;
    if (!sound) throw std::invalid_argument("density and pressure are no state of the gas");
    auto const exact = std::make_shared<GasSolid>(law.exact, gas, m.exact, rest);
    if (exact->vacuum()) throw std::invalid_argument("the gas leaves the solid: give it less velocity away from it");
    FsiProblem problem{.eos = law.scheme, .solid = m.scheme, .material = m.exact};
    problem.t_end = 0.8 * length / exact->solid_speeds().back();
    problem.x1 = length;
    // what the first wave in the gas runs through
    problem.x0 = -1.25 * (gas.u - exact->gas().speeds().front()) * problem.t_end;
    auto const gas_mean = [=](double t) {
      return [=](double a, double b) {
        if (t > 0) return exact->gas().average(a, b, t);
        return GasConserved<>{gas.rho, gas.rho * gas.u,
                              gas.rho * (energy(law.exact, gas.rho, gas.p) + 0.5 * gas.u * gas.u)};
      };
    };
    problem.gas_initial = gas_mean(0), problem.gas_reference = gas_mean(problem.t_end);
    problem.solid_initial = [q = densities(rest)](double, double) { return q; };
    problem.solid_reference = [=, t = problem.t_end](double a, double b) {
      std::vector<double> breaks = exact->solid_speeds();
      for (double& s : breaks) s *= t;
      return solid_average([&](double x) { return exact->solid_at(x / t); }, a, b, breaks);
    };
    problem.position = [u = exact->u_star()](double t) { return u * t; };
    CaseResult r = run_problem("fsi-riemann-1d", 800, problem, options);
    r.facts["exact_contact_pressure"] = exact->p_star(), r.facts["exact_contact_velocity"] = exact->u_star();
    r.facts["contact_pressure_error"] = r.facts["contact_pressure"] / exact->p_star() - 1;
    r.facts["contact_velocity_error"] = r.facts["contact_velocity"] / exact->u_star() - 1;
    return r;
  };
  return out;
}

}  // namespace g27
