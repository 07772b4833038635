/// Steel that runs into a rigid wall and yields: an elastic precursor and a plastic shock.
#include <cmath>
#include <memory>

#include "verification/cases/solid_problem.hpp"
#include "verification/exact/axial_waves.hpp"

namespace g27 {

namespace {

constexpr double length = 0.1;  ///< [m]

/// Where u first falls to `level` from the right end, linear between the centres.
double front(std::vector<double> const& x, std::vector<double> const& u, double level) {
  for (std::size_t i = x.size() - 1; i > 0; --i) {
    if (u[i - 1] >= level) return x[i - 1] + (x[i] - x[i - 1]) * (u[i - 1] - level) / (u[i - 1] - u[i]);
  }
  return x.front();
}

double mean_between(std::vector<double> const& x, std::vector<double> const& y, double a, double b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] > a && x[i] < b) sum += y[i], count += 1;
  }
  return sum / count;
}

/// Plateau stresses, in the middle half of each plateau; wave speeds by where the waves are; the largest stress over
/// that of the plateau.
void measure(AxialWaves const& exact, double u_p, CaseResult& r) {
  auto const& waves = exact.waves();
  double const t = r.time, x1 = t * waves[0].head, x2 = t * waves[1].head;  // precursor, plastic shock
  std::vector<double> sigma;
  for (std::size_t i = 0; i < r.x.size(); ++i) sigma.push_back(r.profile["pressure"][i] - r.profile["sxx"][i]);
  auto const stress = [](SolidPoint const& s) { return -s.stress(0, 0); };
  double const elastic = stress(waves[0].behind), plastic = stress(waves[1].behind);
  double const quarter = 0.25 * (x1 - x2);
  double const found_elastic = mean_between(r.x, sigma, x2 + quarter, x1 - quarter);
  // the wall's first cells keep the heat and the strain of its start
  double const found_plastic = mean_between(r.x, sigma, 0.25 * x2, 0.75 * x2);
  double const found_1 = front(r.x, sigma, 0.5 * elastic) / t + u_p;
  double const found_2 = front(r.x, sigma, 0.5 * (elastic + plastic)) / t + u_p;
  double most = 0;
  for (double s : sigma) most = std::fmax(most, s);
  double const speed_1 = waves[0].head + u_p, speed_2 = waves[1].head + u_p;
  r.facts["elastic_stress"] = found_elastic, r.facts["plastic_stress"] = found_plastic;
  r.facts["elastic_stress_error"] = found_elastic / elastic - 1;
  r.facts["plastic_stress_error"] = found_plastic / plastic - 1;
  r.facts["elastic_speed"] = found_1, r.facts["elastic_speed_error"] = found_1 / speed_1 - 1;
  r.facts["plastic_speed"] = found_2, r.facts["plastic_speed_error"] = found_2 / speed_2 - 1;
  r.facts["stress_overshoot"] = most / plastic - 1;
}

}  // namespace

Case piston_ep_case() {
  Case out{.name = "piston-ep",
           .title = "steel at 50 m/s against a rigid wall: elastic precursor and plastic shock",
           .source = "exact waves of uniaxial strain: Udaykumar et al., J. Comput. Phys. 186 (2003) 136",
           .dimensions = 1,
           .default_cells = 800,
           .solid = true,
           .eos = solid_media(),
           .meshes = {"fixed"},
           .parameters = {{.name = "velocity",
                           .value = 50,
                           .unit = "m/s",
                           .what = "of the impact on the wall",
                           .least = 1,
                           .most = 2000}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("steel"), true);
    double const u_p = value_of(parameters, options, "velocity");
    SolidPoint const ahead = axial_state(m.exact, m.rho0, -u_p, 0);
    auto const exact = std::make_shared<AxialWaves>(axial_piston(m.exact, ahead, 0, Direction::right));
    if (exact->waves().size() != 2) throw std::invalid_argument("piston-ep is the case of two waves");
    SolidProblem problem{.solid = m.scheme, .dimensions = 1, .upper = {length, 1, 1}};
    problem.t_end = 0.8 * length / exact->waves()[0].head;
    problem.sides[0].kind = SolidBoundary::Kind::wall;
    problem.sides[1] = solid_inflow([=](Vec3 const&, double) { return ahead; });
    problem.initial = [q = densities(ahead)](Vec3 const&, Vec3 const&) { return q; };
    problem.reference = [=, t = problem.t_end](Vec3 const& x, Vec3 const& h) {
      std::vector<double> breaks = exact->speeds();
      for (double& b : breaks) b *= t;
      return solid_average([&](double at) { return exact->at(at / t); }, x[0] - 0.5 * h[0], x[0] + 0.5 * h[0], breaks);
    };
    problem.measure = [=](SolidGrid const&, CaseResult& r) { measure(*exact, u_p, r); };
    return run_problem("piston-ep", 800, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
