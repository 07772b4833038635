/// Contact of gas and solid in one dimension: its solver on random problems, the yielding solid against the exact
/// solution, and orders on a smooth motion of both sides.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "riemann/contact/fixed_point.hpp"
#include "riemann/eos/registry.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/order_schemes.hpp"
#include "studies/orders/order_tables.hpp"
#include "verification/exact/gas_solid.hpp"

namespace g27 {
namespace {

constexpr int problems_per_law = 25000;  // four laws: 10^5
constexpr int against_oracle = 200;

class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * unit_(random_); }
  double decades(double low, double high) { return low * std::pow(high / low, unit_(random_)); }
  GasState<> state(IdealGas const&) { return {decades(1e-3, 1e3), 0, decades(1e1, 1e9)}; }
  GasState<> state(StiffenedGas const& e) { return {decades(1, 1e4), 0, e.p_inf * (decades(1e-4, 1e4) - 1)}; }
  GasState<> state(Jwl const& e) {
    double const rho = e.rho0 * decades(1e-3, 2);
    return {rho, 0, e.cold_pressure(rho) + decades(1e4, 1e12)};
  }
  GasState<> state(MieGruneisen const& e) {
    double const rho = decades(0.2 * e.rho0, e.rho0 / (1 - 0.9 / e.s));
    return {rho, 0, e.cold_pressure(rho) + e.rho0 * e.c0 * e.c0 * decades(1e-6, 1e2)};
  }

 private:
  std::mt19937_64 random_{27};
  std::uniform_real_distribution<double> unit_;
};

struct Problem {
  GasState<> gas;
  SolidTrace solid;
};

struct Totals {
  int failures = 0, vacua = 0, fixed_failures = 0;
};

/// Impedance of the solid over the gas's from 1e-6 to 1e6, impact and expansion of 1e-6 to 1e2 sound speeds, a third
/// with a plastic branch.
template <class E>
std::vector<Problem> draw_problems(E const& eos, Draw& draw) {
  std::vector<Problem> out(problems_per_law);
  for (std::size_t i = 0; i < out.size(); ++i) {
    Problem& p = out[i];
    p.gas = draw.state(eos);
    double const c = std::sqrt(eos.bulk_modulus(p.gas.rho, p.gas.p) / p.gas.rho), z = p.gas.rho * c;
    double const push = (i % 2 ? 1 : -1) * c * draw.decades(1e-6, 1e2);
    p.solid = elastic_trace(-push, p.gas.p, z * draw.decades(1e-6, 1e6));
    if (i % 3 == 0) {
      p.solid.yield_pressure = p.gas.p + z * c * draw.between(-0.2, 1);
      p.solid.plastic_impedance = p.solid.impedance * draw.between(0.05, 1);
    }
  }
  return out;
}

template <class E>
std::vector<Value> random_row(Draw& draw, Totals& totals) {
  E const eos{};
  std::vector<Problem> const problems = draw_problems(eos, draw);
  using Clock = std::chrono::steady_clock;
  double iterations = 0, most = 0, residual = 0, fixed_iterations = 0;
  int failures = 0, vacua = 0, fixed_failures = 0;
  auto const start = Clock::now();
  for (Problem const& p : problems) {
    GasSolidContact const r = gas_solid_contact(eos, p.gas, p.solid);
    failures += !(r.converged && std::isfinite(r.contact.p) && std::isfinite(r.contact.u) && r.rho >= 0);
    vacua += r.vacuum;
    iterations += r.iterations, most = std::max<double>(most, r.iterations);
    residual = std::max(residual, r.residual);
  }
  auto const middle = Clock::now();
  for (Problem const& p : problems) {
    GasSolidContact const r = fixed_point_contact(eos, p.gas, p.solid, p.solid.velocity(p.gas.p), 1e-10, 200);
    fixed_failures += !r.converged;
    if (r.converged) fixed_iterations += r.iterations;
  }
  auto const end = Clock::now();
  auto const each = [](auto span) { return std::chrono::duration<double>(span).count() / problems_per_law; };
  totals.failures += failures, totals.vacua += vacua, totals.fixed_failures += fixed_failures;
  return {std::string(E::name),
          long{problems_per_law},
          long{failures},
          residual,
          static_cast<double>(vacua) / problems_per_law,
          iterations / problems_per_law,
          most,
          each(middle - start),
          long{fixed_failures},
          fixed_iterations / std::max(1, problems_per_law - fixed_failures),
          each(end - middle)};
}

Table random_contacts(std::vector<Finding>& findings) {
  Table table{.name = "random",
              .title = "random contacts: Newton's method, and the fixed point with at most 200 iterations",
              .columns = {{"law", "1"},
                          {"problems", "1"},
                          {"failures", "1"},
                          {"residual", "1"},
                          {"vacuum_share", "1"},
                          {"iterations", "1"},
                          {"most_iterations", "1"},
                          {"time_per_solve", "s"},
                          {"fixed_failures", "1"},
                          {"fixed_iterations", "1"},
                          {"fixed_time", "s"}},
              .rows = {},
              .facts = {}};
  Draw draw;
  Totals totals;
  EosList::for_each([&]<class E>() { table.rows.push_back(random_row<E>(draw, totals)); });
  long const total = problems_per_law * static_cast<long>(EosList::size);
  findings.push_back({fmt::format("none of {} random contacts fails", total), fmt::format("{} fail", totals.failures),
                      totals.failures == 0});
  findings.push_back({"vacua are among them", fmt::format("{}", totals.vacua), totals.vacua > total / 100});
  return table;
}

/// Products of detonation and steel of constant impedance, over the velocity: solver against oracle.
Finding oracle_finding() {
  SolidMaterial const steel{.law = LinearBulkLaw{}, .mu = 80.77e9};
  SolidPoint const rest = axial_state(steel, 7800, 0, 0);
  double const Z = std::sqrt(7800 * (175e9 + 4.0 / 3 * 80.77e9));
  Draw draw;
  double worst = 0;
  for (int i = 0; i < against_oracle; ++i) {
    double const rho = draw.between(1000, 2400);
    GasState<> const gas{rho, draw.between(-1000, 3000), Jwl{}.cold_pressure(rho) + draw.decades(1e9, 1e11)};
    GasSolid const exact(JwlLaw{}, gas, steel, rest, SolidModel::linear);
    GasSolidContact const r = gas_solid_contact(Jwl{}, gas, elastic_trace(0, 0, Z));
    worst = std::max({worst, std::fabs(r.contact.p / exact.p_star() - 1), std::fabs(r.contact.u / exact.u_star() - 1)});
  }
  return {
      fmt::format("{} contacts of products and steel: pressure and velocity of the oracle to 1e-10", against_oracle),
      fmt::format("{:.2g}", worst), worst <= 1e-10};
}

Table yielding(std::vector<Finding>& findings) {
  Table table{.name = "yielding",
              .title = "Chapman-Jouguet products against steel that yields: errors of the contact's last step",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"pressure_error", "1"},
                          {"velocity_error", "1"},
                          {"position_l1", "m"}},
              .rows = {},
              .facts = {}};
  std::vector<Case> const cases = all_cases();
  Case const& problem = find_by_name(cases, "fsi-riemann-1d", "fsi-1d");
  for (Predictor const predictor : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
    for (int const n : {100, 200, 400, 800}) {
      CaseOptions options;
      options.cells = n, options.predictor = predictor;
      CaseResult const r = problem.run(options);
      double const p = r.facts.at("contact_pressure_error"), u = r.facts.at("contact_velocity_error");
      table.rows.push_back({r.scheme, long{n}, p, u, r.errors.at("interface_position").l1});
      if (n != 800 || predictor == Predictor::godunov) continue;
      findings.push_back({fmt::format("yielding steel, {}, 800 cells: p and u of the contact within 0.01 %", r.scheme),
                          fmt::format("{:.2g}, {:.2g}", p, u), std::max(std::fabs(p), std::fabs(u)) <= 1e-4});
    }
  }
  return table;
}

std::vector<OrderRow> order_rows() {
  std::vector<OrderRow> rows;
  for (std::string const mesh : {"lagrangian", "stretched"}) {
    for (OrderScheme const& s : order_schemes) {
      OrderRow row{"smooth", "fsi-piston-1d", "ideal", mesh, s.name, {}, {50, 100, 200, 400}};
      row.options.predictor = s.predictor, row.options.monotonicity = s.monotonicity;
      // in units of the gas: density, sound speed and 1 m are one
      for (char const* v : {"gas_density", "gas_velocity", "gas_pressure", "solid_density", "solid_velocity",
                            "solid_pressure", "solid_sxx", "interface_position", "interface_velocity"})
        row.units.emplace_back(v, 1.0);
      rows.push_back(row);
    }
  }
  return rows;
}

StudyReport run(StudyContext const& context) {
  std::vector<Finding> findings;
  if (context.progress) context.progress(0, "random contacts");
  Table const random = random_contacts(findings);
  findings.push_back(oracle_finding());
  if (context.progress) context.progress(0.3, "yielding steel");
  Table const steel = yielding(findings);
  std::vector<RowResult> const results = measure_orders(order_rows(), context);
  auto const claim = [&](std::string const& text, std::string const& scheme, double low, double high) {
    findings.push_back(order_claim(results, text, low, high, [&](auto& r, auto&) { return r.scheme == scheme; }));
  };
  claim("smooth, linear, off: L1 order of every variable on both sides and at the contact 1.95 to 2.1", "linear, off",
        1.95, 2.1);
  claim("smooth, linear, graded: L1 order at least 1.95", "linear, graded", 1.95, 3);
  claim("smooth, parabolic, on: L1 order at least 1.95", "parabolic, on", 1.95, 4);
  claim("smooth, Godunov: L1 order 0.8 to 1.1", "godunov", 0.8, 1.1);
  return {{random, steel, order_table(results), error_table(results)}, findings};
}

}  // namespace

Study fsi_1d_study() {
  return {"fsi-1d", "gas and solid in one dimension share an exact contact, to second order on both sides", run};
}

}  // namespace g27
