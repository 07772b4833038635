/// A free elastic sphere in thin gas that swells and shrinks in its first radial mode.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "fsi/overset/body_integrals.hpp"
#include "fsi/surface/clip.hpp"
#include "fsi/surface/shapes.hpp"
#include "verification/cases/overset_problem.hpp"
#include "verification/cases/run_facts.hpp"
#include "verification/cases/solid_media.hpp"
#include "verification/exact/free_vibration.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{
    {"amplitude", 1e-3, "1", "velocity of the surface over that of P waves", 1e-6, 0.02},
    {"periods", 2, "1", "of the exact frequency", 1, 200},
    {"eighths", 0, "1",
     "of the sphere that are computed, 1 2 4 or 8, the rest by planes of symmetry; 0: whole, turned and off the cells",
     0, 8, true},
    literal_parameter()};

/// Volume in time: its zeros give the period, its extrema the amplitude.
struct Swelling {
  std::vector<double> time, change;
  [[nodiscard]] std::vector<double> zeros() const {
    std::vector<double> z;
    for (std::size_t i = 1; i < change.size(); ++i) {
      if (change[i - 1] * change[i] >= 0) continue;
      z.push_back(time[i - 1] - (time[i] - time[i - 1]) * change[i - 1] / (change[i] - change[i - 1]));
    }
    return z;
  }
  [[nodiscard]] double largest(double from, double to) const {
    double most = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (time[i] >= from && time[i] <= to) most = std::max(most, std::fabs(change[i]));
    }
    return most;
  }
};

}  // namespace

Case breathing_sphere_case() {
  auto const run = [](CaseOptions const& options) {
    SolidMedium const steel = solid_medium("steel");
    double const K = 175e9, mu = steel.scheme.mu, p = 1e-5 * K, radius = 0.2, size = 1;
    int const n = options.cells.value_or(40);
    double const h = size / n, periods = value_of(parameters, options, "periods");
    double const speed = value_of(parameters, options, "amplitude") * steel.sound;
    auto const mode = std::make_shared<FreeVibration const>(
        FreeBody::sphere, ElasticSolid{.rho = steel.rho0, .lambda = K - 2.0 / 3.0 * mu, .mu = mu}, radius, 0, 1, speed);
    double const period = 2 * std::numbers::pi / mode->frequency();
    Vec3 middle{0.503, 0.507, 0.493};
    OversetProblem problem;
    problem.setup.gas = gas_cube(IdealGas{1.4}, size, n);
    TriangleSurface surface = placed(make_sphere(radius, h), {0.3, 0.5, 1}, 0.6, middle);
    int const eighths = static_cast<int>(std::lround(value_of(parameters, options, "eighths")));
    double volume = mass_properties(surface).volume;
    if (eighths > 0) {
      int const planes = eighths == 8 ? 0 : eighths == 4 ? 1 : eighths == 2 ? 2 : eighths == 1 ? 3 : -1;
      if (planes < 0 || n % 2 != 0) throw std::invalid_argument("eighths: 1, 2, 4 or 8, and an even number of cells");
      middle = {0, 0, 0}, surface = clip_at_origin(make_sphere(radius, h), 3, 0.3 * h);
      TriangleSurface whole = surface;
      for (std::size_t a = 3; a-- > 0;) {
        whole = unfolded(whole, a, 0);
        if (static_cast<int>(a) == planes) surface = whole;
      }
      volume = mass_properties(whole).volume * eighths / 8;
      problem.setup.gas = symmetric_cube(IdealGas{1.4}, size, n, planes);
    }
    problem.gas = [=](Vec3 const&) { return GasPoint{1e-5 * steel.rho0, {0, 0, 0}, p}; };
    problem.t_end = periods * period;
    problem.setup.literal = literal_reading(value_of(parameters, options, "literal"));
    problem.setup.solid_options.cfl = largest_parabolic_body_cfl;
    BodySetup body{.surface = std::move(surface), .material = steel.scheme, .cell = h, .initial = {}};
    // of a symmetric one, the planes are faces of its cells
    double const reach = eighths > 0 ? std::ceil(1.1 * radius / h) * h : 1.1 * radius;
    body.lower = middle - Vec3{reach, reach, reach}, body.upper = 2.0 * middle - body.lower;
    body.initial = [=](Vec3 const& x) {
      SolidPoint const wave = mode->at(x - middle, 0);
      return solid_state(steel, steel.rho0 * (1 + p / K), wave.u, p);
    };
    problem.setup.bodies.push_back(std::move(body));
    auto const swelling = std::make_shared<Swelling>();
    auto const start = std::make_shared<BodyIntegrals>();
    problem.after_step = [=](OversetSolver const& solver) {
      swelling->time.push_back(solver.time() / period);
      swelling->change.push_back(enclosed(*solver.bodies()[0]).volume / volume - 1);
      if (solver.counters().steps == 1) *start = integrals(*solver.bodies()[0]);
      return std::fabs(swelling->change.back()) < 0.3;
    };
    problem.measure = [=](OversetSolver const& solver, CaseResult& r) {
      auto const zeros = swelling->zeros();
      double const none = std::numeric_limits<double>::quiet_NaN();
      r.facts["period_ratio"] =
          zeros.size() > 1 ? 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1) : none;
      double const first = swelling->largest(0, 0.5), last = swelling->largest(periods - 0.5, periods);
      r.facts["amplitude_left"] = last / first;
      if (periods >= 3) {
        // of the amplitude from one period to the next, relative; the first has the start's half swing
        double& growth = r.facts["largest_growth"] = -1;
        for (int k = 1; k + 2 <= static_cast<int>(periods); ++k)
          growth = std::max(growth, swelling->largest(k + 1, k + 2) / swelling->largest(k, k + 1) - 1);
      }
      BodyIntegrals const end = integrals(*solver.bodies()[0]);
      r.facts["energy_left"] = (end.kinetic + end.strain) / (start->kinetic + start->strain);
      r.facts["mass_change"] = end.mass / start->mass - 1;
      r.facts["radius_in_cells"] = radius / h;
    };
    return run_problem("breathing-sphere", 40, std::move(problem), options);
  };
  Case out = overset_case(
      "breathing-sphere",
      "elastic steel sphere in thin gas, swelling and shrinking in its first radial mode: period and loss",
      "Love, A Treatise on the Mathematical Theory of Elasticity, 4th ed., art. 196: free sphere, radial modes", 40,
      parameters);
  out.run = run;
  return out;
}

}  // namespace g27
