#include "verification/cases/detonation_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "verification/cases/grid_probe.hpp"
#include "verification/cases/grid_problem.hpp"
#include "verification/cases/line_problem.hpp"
#include "verification/exact/taylor_wave.hpp"

namespace g27 {

namespace {

/// TNT-RDX; the coefficient C of its isentrope closes the set (papers/overset_fsi/parameters.toml).
Jwl const products{.A = 708.6056e9, .B = 13.16457e9, .R1 = 4.94, .R2 = 1.35, .omega = 0.28, .rho0 = 1650};
constexpr double isentrope_C = 1.058238e9;                 ///< [Pa]
constexpr double radius = 0.05, t_end = 6.4e-6, p0 = 1e5;  ///< [m], [s], [Pa] of the explosive at rest
char const* const source = "Taylor, Proc. R. Soc. A 200 (1950) 235; programmed burn: Wilkins, UCRL-7322 (1964)";

/// The exact wave, and the burn that should make it.
struct Detonation {
  JwlLaw law{products.A, products.B, products.R1, products.R2, products.omega, products.rho0};
  ChapmanJouguet front = chapman_jouguet_of_isentrope(law, isentrope_C);
  std::shared_ptr<TaylorWave const> wave = std::make_shared<TaylorWave>(law, front, 2);
  double unburnt_energy = products.rho0 * products.energy(products.rho0, p0);  ///< [J/m^3]

  [[nodiscard]] ProgrammedBurn burn() const {
    return {
        .energy = (front.E0 - unburnt_energy) / products.rho0,
        .speed = front.D,
        .lighting = [D = front.D](Vec3 const& x) { return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / D; }};
  }
  [[nodiscard]] GasConserved<> explosive() const { return {products.rho0, 0, unburnt_energy}; }
  /// Mean over [a, b] at t, weighted with r^2.
  [[nodiscard]] GasConserved<> average(double a, double b, double t) const {
    double const r = std::clamp(front.D * t, a, b);
    double const all = b * b * b - a * a * a, burnt = (r * r * r - a * a * a) / all;
    GasConserved<> const q = burnt > 0 ? wave->average(a, r, t) : GasConserved<>{0, 0, 0}, e = explosive();
    return {burnt * q.mass + (1 - burnt) * e.mass, burnt * q.momentum, burnt * q.energy + (1 - burnt) * e.energy};
  }
};

/// Mean of the exact pressure over [a, b] at the end.
double mean_pressure(Detonation const& d, double a, double b) {
  constexpr int points = 16;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    double const r = (a + (b - a) * (i + 0.5) / points) / (d.front.D * t_end);
    sum += (r < 1 ? d.wave->at(r).p : p0) / points;
  }
  return sum;
}

/// Sums of |error| and |exact|; all radii count alike.
struct Relative {
  double error = 0, exact = 0;
  void add(double weight, double value, double against) {
    error += weight * std::fabs(value - against), exact += weight * std::fabs(against);
  }
  [[nodiscard]] double ratio() const { return error / exact; }
};

/// Facts that lines and grids share. `l1_pressure_inside`, which both add, leaves out the charge's outermost width of a
/// cell: at t_end the ramp of the burn, a width to each side of the front, leaves the charge there on 32 cells.
/// `energy`: what was released [J/sr].
void add_facts(Detonation const& d, double energy, double core, double front, CaseResult& r) {
  double const reached = d.front.D * t_end, volume = reached * reached * reached / 3;
  r.facts["released"] = energy / ((d.front.E0 - d.unburnt_energy) * volume);
  r.facts["core_pressure"] = core / d.wave->core_state().p;
  r.facts["front_speed"] = front / reached;
}

}  // namespace

Case detonation_line_case(std::string const& name) {
  auto const run = [=](CaseOptions const& options) {
    Detonation const d;
    LineProblem line{.eos = products, .x1 = radius, .t_end = t_end, .symmetry = Symmetry::spherical, .burn = d.burn()};
    line.left.kind = GasBoundary::Kind::wall;
    line.initial = [&](double, double) { return d.explosive(); };
    line.reference = [&](double a, double b) { return d.average(a, b, t_end); };
    CaseResult r = run_problem(name, 64, line, options);
    Relative rho, u, p, p_inside;
    double const h = radius / r.cells;
    double front = 0;
    for (std::size_t i = 0; i < r.x.size(); ++i) {
      double const pressure = mean_pressure(d, r.x[i] - 0.5 * h, r.x[i] + 0.5 * h);
      rho.add(1, r.rho[i], r.rho_ref[i]), u.add(1, r.u[i], r.u_ref[i]), p.add(1, r.p[i], pressure);
      if (i + 1 < r.x.size()) p_inside.add(1, r.p[i], pressure);
      double const half = 0.5 * d.front.state.p;
      if (i + 1 < r.x.size() && r.p[i] > half && r.p[i + 1] <= half)
        front = r.x[i] + h * (r.p[i] - half) / (r.p[i] - r.p[i + 1]);
    }
    r.facts["l1_density"] = rho.ratio(), r.facts["l1_velocity"] = u.ratio(), r.facts["l1_pressure"] = p.ratio();
    r.facts["l1_pressure_inside"] = p_inside.ratio();
    std::size_t const core = static_cast<std::size_t>(0.2 * radius / h);
    add_facts(d, r.ledger.energy.from_source, r.p[core], front, r);
    return r;
  };
  return {.name = name,
          .title = "A sphere of TNT-RDX detonates by programmed burn: the exact self-similar wave",
          .source = source,
          .default_cells = 64,
          .eos = {"jwl"},
          .meshes = {"uniform"},
          .run = run};
}

Case detonation_grid_case(std::string const& name) {
  auto const run = [=](CaseOptions const& options) {
    Detonation const d;
    GridProblem grid{
        .eos = products, .dimensions = 3, .upper = {radius, radius, radius}, .burn = d.burn(), .t_end = t_end};
    for (std::size_t a = 0; a < 3; ++a) grid.sides[2 * a] = wall_side, grid.sides[2 * a + 1] = outflow_side;
    grid.initial = [&](Vec3 const&, Vec3 const&) -> GasDensities {
      return {products.rho0, {0, 0, 0}, d.unburnt_energy};
    };
    grid.measure = [&](GasGrid const& done, CaseResult& r) {
      Relative rho, u, p, p_inside;
      double const h = done.widths()[0];
      Int3 const n = done.cells();
      for (int k = 0; k < n[2]; ++k) {
        for (int j = 0; j < n[1]; ++j) {
          for (int i = 0; i < n[0]; ++i) {
            Vec3 const x = done.centre({i, j, k});
            double const at = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
            if (at > radius) continue;
            GasPoint const q = done.primitive({i, j, k});
            GasConserved<> const e = d.average(std::max(0.0, at - 0.5 * h), at + 0.5 * h, t_end);
            double const speed = e.momentum / e.mass;
            double const w = 1 / (at * at);
            rho.add(w, q.rho, e.mass);
            u.add(w, (q.u[0] * x[0] + q.u[1] * x[1] + q.u[2] * x[2]) / at, speed);
            double const pressure = mean_pressure(d, std::max(0.0, at - 0.5 * h), at + 0.5 * h);
            p.add(w, q.p, pressure);
            if (at < radius - h) p_inside.add(w, q.p, pressure);
          }
        }
      }
      r.facts["l1_density"] = rho.ratio(), r.facts["l1_velocity"] = u.ratio(), r.facts["l1_pressure"] = p.ratio();
      r.facts["l1_pressure_inside"] = p_inside.ratio();
      GridProbe const probe(done, GasGrid::Field::pressure);
      double const c = 1 / std::sqrt(3.0);
      double const axis = probe.front({0, 0, 0}, {1, 0, 0}, radius, 0.5 * d.front.state.p);
      double const diagonal = probe.front({0, 0, 0}, {c, c, c}, radius, 0.5 * d.front.state.p);
      r.facts["front_diagonal_over_axis"] = axis > 0 ? diagonal / axis : 0;  // 0: too few cells for a front
      double const steradians = std::numbers::pi / 2;
      add_facts(d, done.ledger().energy.from_source / steradians,
                probe.at({0.2 * radius * c, 0.2 * radius * c, 0.2 * radius * c}), axis, r);
    };
    return run_problem(name, 32, grid, options);
  };
  return {.name = name,
          .title = "A sphere of TNT-RDX detonates by programmed burn, on an octant: the exact self-similar wave",
          .source = source,
          .dimensions = 3,
          .default_cells = 32,
          .has_reference = false,
          .eos = {"jwl"},
          .meshes = grid_meshes(),
          .run = run};
}

}  // namespace g27
